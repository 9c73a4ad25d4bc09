// The union of pairs of meshes in Manifold (npm's manifold-3d, compiled to WebAssembly), timed inside this process:
// from arrays of vertices and triangles to such arrays.
//
//   npm install --no-save --prefix build/peers manifold-3d && node bench/peers/manifold_peer.mjs DIR
//
//   manifold_peer.mjs DIR [PAIR...] [--rounds N] [--prefix FOLDER]
//
// reads DIR/PAIR_a.off and DIR/PAIR_b.off (default: ico20480 elephant bunny00) and prints user CPU seconds, the least and
// the median of the rounds (default 7), and a third of the least: native builds of Manifold were measured 2.3 to 4.8 times
// faster than this one. --prefix is that of npm (default build/peers). Manifold rounds: its results are no exact unions.
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

function readOff(file) {
  const words = readFileSync(file, 'utf8').split(/\s+/);
  if (words[0] !== 'OFF') throw new Error(`${file}: not OFF`);
  const [points, faces] = [Number(words[1]), Number(words[2])];
  const vertProperties = new Float32Array(3 * points);
  const triVerts = new Uint32Array(3 * faces);
  let at = 4;
  for (let i = 0; i < 3 * points; ++i) vertProperties[i] = Number(words[at++]);
  for (let f = 0; f < faces; ++f) {
    if (words[at++] !== '3') throw new Error(`${file}: triangles only`);
    for (let i = 0; i < 3; ++i) triVerts[3 * f + i] = Number(words[at++]);
  }
  return {numProp: 3, vertProperties, triVerts};
}

const words = process.argv.slice(2);
function option(name, otherwise) {
  const at = words.indexOf(name);
  return at < 0 ? otherwise : words.splice(at, 2)[1];
}
const rounds = Number(option('--rounds', 7));
const prefix = option('--prefix', 'build/peers');
const [directory, ...named] = words;
if (directory === undefined) throw new Error('name the folder with the pairs');

const script = resolve(prefix, 'node_modules/manifold-3d/manifold.js');
const {default: load} = await import(pathToFileURL(script).href);
const library = await load();
library.setup();
const {Manifold, Mesh} = library;

/** Seconds of user CPU time, and the triangles of the union. */
function unite(a, b) {
  const start = process.cpuUsage();
  const first = new Manifold(new Mesh(a));
  const second = new Manifold(new Mesh(b));
  const both = Manifold.union(first, second);
  const mesh = both.getMesh();
  const seconds = process.cpuUsage(start).user * 1e-6;
  for (const m of [first, second, both]) m.delete();
  return {seconds, triangles: mesh.triVerts.length / 3};
}

for (const pair of named.length > 0 ? named : ['ico20480', 'elephant', 'bunny00']) {
  const a = readOff(`${directory}/${pair}_a.off`);
  const b = readOff(`${directory}/${pair}_b.off`);
  unite(a, b);  // compiles
  const runs = [];
  for (let i = 0; i < rounds; ++i) runs.push(unite(a, b));
  const times = runs.map((r) => r.seconds).sort((x, y) => x - y);
  const [least, median] = [times[0], times[Math.floor(times.length / 2)]];
  console.log(`${pair}: ${runs[0].triangles} triangles, least ${least.toFixed(4)} s, median ` +
              `${median.toFixed(4)} s, a third of the least ${(least / 3).toFixed(4)} s`);
}
