// The union of pairs of meshes in the npm package plumb beside npm's manifold-3d, both WebAssembly.
//
//   bindings/js/build && npm install --no-save --prefix build/peers manifold-3d
//   node bench/peers/js_peer.mjs [PAIR...] [--rounds N] [--prefix FOLDER] [--package FOLDER]
//
// CPU time, user and system, of this process, from arrays of vertices and triangles to such arrays:
// both libraries in turn, N rounds, and one before that is not counted; medians. Each has one
// thread. plumb rounds to the nearest doubles, as space_peer.cpp does; the last column is its time
// with a mesh that is valid after rounding. Manifold keeps floats, to which it rounds the input.
// The pairs are those of space_peer.cpp. The answer is the volume of the union, to 1e-4 of it.
import {readFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const tolerance = 1e-4;

const words = process.argv.slice(2);
function option(name, otherwise) {
  const at = words.indexOf(name);
  return at < 0 ? otherwise : words.splice(at, 2)[1];
}
const rounds = Number(option('--rounds', 7));
const prefix = resolve(option('--prefix', join(root, 'build/peers')));
const dist = resolve(option('--package', join(root, 'bindings/js/dist')));

// ---- pairs

/** A sphere of 20 * 4 ** depth triangles around a centre. */
function icosphere(depth, centre) {
  const golden = (1 + Math.sqrt(5)) / 2;
  const first = [[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0]];
  const unit = (p) => p.map((x) => x / Math.hypot(...p));
  const points = [
    ...first, ...first.map(([x, y, z]) => [z, x, y]), ...first.map(([x, y, z]) => [y, z, x])
  ].map(unit);
  const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const det = (p, q, r) =>
      dot(p, [q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]]);
  const near = (i, j) => i !== j && dot(points[i], points[j]) > 0.4;
  let faces = [];
  for (let i = 0; i < 12; ++i) {
    for (let j = i + 1; j < 12; ++j) {
      for (let k = i + 1; k < 12; ++k) {
        if (near(i, j) && near(i, k) && near(j, k) && det(points[i], points[j], points[k]) > 0)
          faces.push([i, j, k]);
      }
    }
  }
  for (let round = 0; round < depth; ++round) {
    const middle = new Map();
    const between = (a, b) => {
      const key = Math.min(a, b) * 1e6 + Math.max(a, b);
      if (!middle.has(key))
        middle.set(key, points.push(unit(points[a].map((x, axis) => x + points[b][axis]))) - 1);
      return middle.get(key);
    };
    faces = faces.flatMap(([a, b, c]) => {
      const ab = between(a, b), bc = between(b, c), ca = between(c, a);
      return [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]];
    });
  }
  return {
    vertices: Float64Array.from(points.flatMap((p) => p.map((x, axis) => x + centre[axis]))),
    triangles: Uint32Array.from(faces.flat())
  };
}

function gridCube(n, low) {
  const numbers = new Map(), points = [], triangles = [];
  const vertex = (p) => {
    const key = p.join();
    if (!numbers.has(key)) numbers.set(key, points.push(p) - 1);
    return numbers.get(key);
  };
  for (let axis = 0; axis < 3; ++axis) {
    for (const side of [0, n]) {
      for (let i = 0; i < n; ++i) {
        for (let j = 0; j < n; ++j) {
          const at = (u, v) => {
            const p = [0, 0, 0];
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = j + v;
            return vertex(p);
          };
          const [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
          triangles.push(...(side > 0 ? [a, b, c, a, c, d] : [c, b, a, d, c, a]));
        }
      }
    }
  }
  return {
    vertices: Float64Array.from(points.flatMap((p) => p.map((x, axis) => x + low[axis]))),
    triangles: Uint32Array.from(triangles)
  };
}

function bunny() {
  const numbers =
      readFileSync(join(root, 'corpus/solids/bunny.off'), 'utf8').split(/\s+/).slice(1).map(Number);
  const [points, faces] = numbers, at = 3 + 3 * points;
  return {
    vertices: Float64Array.from(numbers.slice(3, at)),
    triangles: Uint32Array.from(
        {length: 3 * faces}, (_, i) => numbers[at + 4 * Math.floor(i / 3) + 1 + (i % 3)]),
  };
}

function moved({vertices, triangles}) {
  const xs = vertices.filter((_, i) => i % 3 === 0), step = (Math.max(...xs) - Math.min(...xs)) / 7;
  return {vertices: vertices.map((x, i) => x + step / (1 + (i % 3))), triangles};
}

function turned({vertices, triangles}, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), result = vertices.slice();
  for (let i = 0; i < vertices.length; i += 3) {
    result[i] = c * vertices[i] - s * vertices[i + 1];
    result[i + 1] = s * vertices[i] + c * vertices[i + 1];
  }
  return {vertices: result, triangles};
}

const spheres = (depth) => [icosphere(depth, [0, 0, 0]), icosphere(depth, [0.3, 0.2, 0.1])];
const pairs = {
  'ico1280': () => spheres(3),
  'ico5120': () => spheres(4),
  'ico20480': () => spheres(5),
  'bunny': () => [bunny(), moved(bunny())],
  'cubes19200': () => [gridCube(40, [0, 0, 0]), gridCube(40, [3.25, 2.5, 0])],
  'ico5120-turned': () => [icosphere(4, [0, 0, 0]), turned(icosphere(4, [0, 0, 0]), 1e-12)],
  'ico20480-twice': () => [icosphere(5, [0.1, 0.2, 0.3]), icosphere(5, [0.1, 0.2, 0.3])],
};

// ---- libraries

const plumb = await import(pathToFileURL(join(dist, 'index.js')).href);
await plumb.init();
const {default: load} =
    await import(pathToFileURL(join(prefix, 'node_modules/manifold-3d/manifold.js')).href);
const {version} =
    JSON.parse(readFileSync(join(prefix, 'node_modules/manifold-3d/package.json'), 'utf8'));
const {Manifold, Mesh} = await load().then((library) => (library.setup(), library));

function byPlumb([a, b], rounding) {
  const {Solid} = plumb;
  const first = Solid.fromMesh(a.vertices, a.triangles),
        second = Solid.fromMesh(b.vertices, b.triangles), sum = first.union(second);
  const mesh = sum.toMesh({rounding});
  for (const solid of [first, second, sum]) solid.dispose();
  return mesh;
}

function byManifold(meshes) {
  const [first, second] = meshes.map(
      ({floats, triangles}) =>
          new Manifold(new Mesh({numProp: 3, vertProperties: floats, triVerts: triangles})));
  const sum = first.add(second), mesh = sum.getMesh();
  for (const solid of [first, second, sum]) solid.delete();
  return {vertices: mesh.vertProperties, triangles: mesh.triVerts, width: mesh.numProp};
}

function volume({vertices: p, triangles, width = 3}) {
  let sum = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => width * triangles[i + k]);
    sum += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
        p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
        p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum / 6;
}

function cpuOf(body) {
  const before = process.cpuUsage(), result = body(), {user, system} = process.cpuUsage(before);
  return {seconds: (user + system) / 1e6, result};
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

console.log(
    `plumb ${plumb.version()} and manifold-3d ${version}, ${rounds} rounds; seconds of CPU`);
console.log('| two of | plumb, nearest doubles | manifold-3d | ratio | plumb, valid |');
console.log('|---|---|---|---|---|');
for (const name of words.length > 0 ? words : Object.keys(pairs)) {
  const pair = pairs[name]().map((mesh) => ({...mesh, floats: Float32Array.from(mesh.vertices)}));
  const ways = {
    nearest: () => byPlumb(pair, 'nearest'),
    manifold: () => byManifold(pair),
    valid: () => byPlumb(pair, 'valid')
  };
  const times = {nearest: [], manifold: [], valid: []}, volumes = {};
  for (let round = -1; round < rounds; ++round) {
    for (const [way, body] of Object.entries(ways)) {
      const {seconds, result} = cpuOf(body);
      if (round >= 0)
        times[way].push(seconds);
      else
        volumes[way] = volume(result);
    }
  }
  for (const way of ['manifold', 'valid']) {
    if (Math.abs(volumes[way] - volumes.nearest) > tolerance * volumes.nearest)
      throw new Error(`${name}: volumes ${JSON.stringify(volumes)}`);
  }
  const ratios = times.nearest.map((seconds, i) => seconds / times.manifold[i]);
  const shown = (way) => `${median(times[way]).toPrecision(2)} s`;
  console.log(`| ${name} | ${shown('nearest')} | ${shown('manifold')} | ${
      median(ratios).toFixed(2)} | ${shown('valid')} |`);
}
