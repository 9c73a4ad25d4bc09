// The time of a call of each predicate beside robust-predicates, in nanoseconds, both in this
// process and in turn:
//
//   bindings/js/build && npm install --no-save --prefix build/peers robust-predicates
//   PLUMB_JS_PEERS=build/peers node bindings/js/bench/predicates.mjs [--rounds N]
//
// The figure is the smallest of N rounds (default 9) over 4096 inputs. `grid` are integers below 4,
// of which many are degenerate; `near` are points near a line, plane, circle or sphere, by a unit
// in the last place.
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const dist = process.env.PLUMB_JS_DIST ?? join(here, '../dist');
const plumb = await import(pathToFileURL(join(dist, 'predicates.js')));
const peers = resolve(process.env.PLUMB_JS_PEERS ?? 'build/peers');
const robust =
    await import(pathToFileURL(createRequire(join(peers, 'x.js')).resolve('robust-predicates')));
const at = process.argv.indexOf('--rounds');
const rounds = at < 0 ? 9 : Number(process.argv[at + 1]);
const inputs = 4096, repeats = 8;

const families = {
  random: () => Math.random(),
  grid: () => Math.floor(Math.random() * 4),
  near: () => 0.5 + Math.floor(Math.random() * 3) / 4 + Math.floor(Math.random() * 3) * 2 ** -52,
};
const counts = {orient2d: 6, incircle: 8, orient3d: 12, insphere: 15};

// A loop of its own for each function, so that the compiler of the engine sees one callee.
function loopOf(count) {
  const words = Array.from({length: count}, (_, i) => `numbers[at + ${i}]`).join(', ');
  return () => new Function('f', 'numbers', `let sum = 0;
    for (let at = 0; at < numbers.length; at += ${count}) sum += Math.sign(f(${words}));
    return sum;`);
}

function nanoseconds(loop, f, numbers) {
  const start = process.hrtime.bigint();
  for (let i = 0; i < repeats; ++i) loop(f, numbers);
  return Number(process.hrtime.bigint() - start) / (repeats * inputs);
}

console.log('predicate family   plumb  robust-predicates  ratio');
for (const [name, count] of Object.entries(counts)) {
  for (const [family, draw] of Object.entries(families)) {
    const numbers = Float64Array.from({length: inputs * count}, draw);
    const make = loopOf(count);
    const ours = make(), theirs = make();
    let best = [Infinity, Infinity];
    for (let round = -2; round < rounds; ++round) {
      const times =
          [nanoseconds(ours, plumb[name], numbers), nanoseconds(theirs, robust[name], numbers)];
      if (round >= 0) best = best.map((time, i) => Math.min(time, times[i]));
    }
    console.log(`${name.padEnd(9)} ${family.padEnd(7)} ${best[0].toFixed(1).padStart(7)}  ${
        best[1].toFixed(1).padStart(17)}  ${(best[0] / best[1]).toFixed(2).padStart(5)}`);
  }
}
