// The union of pairs of meshes in Manifold (npm's manifold-3d, compiled to WebAssembly) beside plumb, in turn.
//
//   npm install --no-save --prefix build/peers manifold-3d
//   node bench/peers/manifold_peer.mjs DIR [PAIR...] [--rounds N] [--prefix FOLDER] [--plumb SPACE_PEER] [--json FILE]
//
// reads DIR/PAIR_a.off and DIR/PAIR_b.off (space_peer DIR --make writes them; default: all of those). CPU
// time, user and system, from arrays of vertices and triangles to such arrays: Manifold's in this process, plumb's in that
// of SPACE_PEER --run plumb-warm (default build/bench/bench/peers/space_peer); both have done the same once before. The answer is the volume of the union; Manifold
// keeps floats and rounds, so 10^-4 of it may differ. Native builds of Manifold were measured 2.3 to 4.8 times faster than
// this one. --prefix is that of npm (default build/peers). The JSON is that of peer_report.h.
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const tolerance = 1e-4;

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
const rounds = Number(option('--rounds', 5));
const prefix = option('--prefix', 'build/peers');
const plumb = option('--plumb', 'build/bench/bench/peers/space_peer');
const json = option('--json', '');
const [directory, ...named] = words;
if (directory === undefined) throw new Error('name the folder with the pairs');

const folder = resolve(prefix, 'node_modules/manifold-3d');
const {version} = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
const {default: load} = await import(pathToFileURL(`${folder}/manifold.js`).href);
const library = await load();
library.setup();
const {Manifold, Mesh} = library;
const name = 'Manifold (WebAssembly)';

function volume({numProp, vertProperties: p, triVerts: t}) {
  let sum = 0;
  for (let i = 0; i < t.length; i += 3) {
    const [a, b, c] = [numProp * t[i], numProp * t[i + 1], numProp * t[i + 2]];
    sum += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
        p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum / 6;
}

function theirs(a, b) {
  const start = process.cpuUsage();
  const first = new Manifold(new Mesh(a));
  const second = new Manifold(new Mesh(b));
  const both = Manifold.union(first, second);
  const mesh = both.getMesh();
  const {user, system} = process.cpuUsage(start);
  const seconds = (user + system) * 1e-6;
  for (const m of [first, second, both]) m.delete();
  return {seconds, answer: volume(mesh)};
}

function ours(files) {
  const [seconds, answer] = execFileSync(plumb, ['--run', 'plumb-warm', ...files], {encoding: 'utf8'}).split(' ').map(Number);
  return {seconds, answer};
}

function compare(pair) {
  const files = ['a', 'b'].map((side) => `${directory}/${pair}_${side}.off`);
  const [a, b] = files.map(readOff);
  theirs(a, b);  // compiles
  const runs = [];
  for (let i = 0; i < rounds; ++i) runs.push([ours(files), theirs(a, b)]);
  const least = (side) => Math.min(...runs.map((r) => r[side].seconds));
  const ratios = runs.map(([x, y]) => x.seconds / y.seconds).sort((x, y) => x - y);
  const [own, other] = runs[runs.length - 1];
  const agree = Math.abs(own.answer - other.answer) <= tolerance * Math.abs(own.answer);
  const ratio = {least: ratios[0], median: ratios[ratios.length >> 1], greatest: ratios[ratios.length - 1]};
  const [u, v] = [least(0), least(1)];
  console.log(`union of two of ${pair}, ${name}: plumb ${u.toFixed(4)} s, peer ${v.toFixed(4)} s, ratio ` +
              `${ratio.median.toFixed(3)} (${ratio.least.toFixed(3)} .. ${ratio.greatest.toFixed(3)})` +
              (agree ? '' : `  VOLUMES DIFFER: ${own.answer} and ${other.answer}`));
  return {
    job: 'union', input: `two of ${pair}`, peer: name, measure: 'volume', tolerance, rounds,
    plumb: {seconds: u, answer: own.answer}, other: {seconds: v, answer: other.answer}, ratio,
    verdict: agree ? 'agree' : 'answers differ',
  };
}

console.log(`manifold-3d ${version}`);
const comparisons = (named.length > 0 ? named : ['ico1280', 'ico5120', 'ico20480', 'bunny', 'bunny58784', 'cubes19200', 'ico5120-turned',
  'ico20480-twice', 'ico81920', 'ico327680']).map(compare);
if (json) {
  const title = 'Union of two solids beside Manifold, from mesh to triangles';
  writeFileSync(json, JSON.stringify({title, versions: {'manifold-3d': version}, comparisons}, null, 1) + '\n');
}
process.exitCode = comparisons.every((c) => c.verdict === 'agree') ? 0 : 1;
