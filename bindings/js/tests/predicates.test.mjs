// The predicates of the package beside exact determinants of integers:
//
//   node --test bindings/js/tests
//
// PLUMB_JS_DIST is the folder that bindings/js/build wrote (default bindings/js/dist). The oracle
// scales all coordinates by 2^1074, where every double is an integer, and expands the determinant
// with a column of ones: no differences, no filters, no code in common. robust-predicates is
// compared where it can be imported from PLUMB_JS_PEERS, a folder with node_modules.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const dist = process.env.PLUMB_JS_DIST ?? join(here, '../dist');
const plumb = await import(pathToFileURL(join(dist, 'predicates.js')));

async function peer() {
  if (!process.env.PLUMB_JS_PEERS) return null;
  const found =
      createRequire(join(process.env.PLUMB_JS_PEERS, 'x.js')).resolve('robust-predicates');
  return import(pathToFileURL(found));
}
const robust = await peer();

// ---- the oracle

const view = new DataView(new ArrayBuffer(8));

function scaled(value) {
  view.setFloat64(0, value);
  const bits = view.getBigUint64(0);
  const exponent = (bits >> 52n) & 2047n;
  const fraction = bits & ((1n << 52n) - 1n);
  const magnitude = exponent === 0n ? fraction : (fraction | (1n << 52n)) << (exponent - 1n);
  return bits >> 63n ? -magnitude : magnitude;
}

function determinant(rows) {
  if (rows.length === 1) return rows[0][0];
  let sum = 0n;
  for (let i = 0; i < rows.length; ++i) {
    if (rows[i][0] === 0n) continue;
    const minor = determinant(rows.filter((_, j) => j !== i).map((row) => row.slice(1)));
    sum += i % 2 ? -rows[i][0] * minor : rows[i][0] * minor;
  }
  return sum;
}

const signOf = (value) => (value > 0n ? 1 : value < 0n ? -1 : 0);

// Each predicate by the determinant of rows [coordinates, their squares if lifted, 1], whose sign
// in our convention is `turn` times that of the determinant.
const shapes = {
  orient2d: {points: 3, dimension: 2, isLifted: false, turn: -1},
  incircle: {points: 4, dimension: 2, isLifted: true, turn: 1},
  orient3d: {points: 4, dimension: 3, isLifted: false, turn: 1},
  insphere: {points: 5, dimension: 3, isLifted: true, turn: -1},
};

function oracle(name, numbers) {
  const {points, dimension, isLifted, turn} = shapes[name];
  const rows = [];
  for (let p = 0; p < points; ++p) {
    const row = numbers.slice(p * dimension, (p + 1) * dimension).map(scaled);
    if (isLifted) row.push(row.reduce((sum, x) => sum + x * x, 0n));
    rows.push([...row, 1n]);
  }
  return turn * signOf(determinant(rows)) + 0;
}

// ---- inputs

function generator(seed) {  // xorshift32
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

function anyDouble(random) {
  do {
    view.setUint32(0, random() * 2 ** 32);
    view.setUint32(4, random() * 2 ** 32);
  } while (!Number.isFinite(view.getFloat64(0)));
  return view.getFloat64(0);
}

function nudged(value, random) {  // by up to two units in the last place
  view.setFloat64(0, value);
  view.setBigUint64(0, view.getBigUint64(0) + BigInt(Math.floor(random() * 3)));
  const next = view.getFloat64(0);
  return Number.isFinite(next) ? next : value;
}

// Points of a small grid have many equal signs of 0; nearly so are those that are moved by a unit
// in the last place.
const families = {
  grid: (random) => Math.floor(random() * 4),
  random: (random) => random() - 0.5,
  'near grid': (random) => nudged(0.5 + Math.floor(random() * 3) / 4, random),
  'any double': anyDouble,
  'subnormal grid': (random) => Math.floor(random() * 4) * Number.MIN_VALUE,
  'tiny grid': (random) => nudged((1 + Math.floor(random() * 3)) * 2 ** -540, random),
  'tiny squares': (random) => nudged((1 + Math.floor(random() * 3)) * 2 ** -270, random),
  'huge grid': (random) => (Math.floor(random() * 4) - 2) * 2 ** 1022,
  'far apart': (random) => (random() < 0.5 ? 1 : -1) * 2 ** Math.floor(random() * 2090 - 1070),
};

for (const [name, shape] of Object.entries(shapes)) {
  for (const [family, draw] of Object.entries(families)) {
    test(`${name}: ${family}`, () => {
      const random = generator(20261127);
      for (let i = 0; i < 2000; ++i) {
        const numbers = Array.from({length: shape.points * shape.dimension}, () => draw(random));
        const value = plumb[name](...numbers);
        assert.ok(Number.isFinite(value), `${name}(${numbers})`);
        assert.equal(Math.sign(value) + 0, oracle(name, numbers), `${name}(${numbers})`);
      }
    });
  }

  // The families whose products neither underflow nor overflow.
  test(`${name}: the signs of robust-predicates`, {skip: robust === null}, () => {
    for (const family of ['grid', 'random', 'near grid']) {
      const random = generator(7);
      for (let i = 0; i < 5000; ++i) {
        const numbers =
            Array.from({length: shape.points * shape.dimension}, () => families[family](random));
        assert.equal(
            Math.sign(plumb[name](...numbers)) + 0, Math.sign(robust[name](...numbers)) + 0,
            `${name}(${numbers})`);
        // Only of small integers are the determinants in doubles exact; others depend on the order
        // of operations.
        if (family !== 'grid') continue;
        assert.equal(plumb[`${name}fast`](...numbers) + 0, robust[`${name}fast`](...numbers) + 0);
      }
    }
  });

  // The reason to have these predicates: if robust-predicates mends this, the documents have to be
  // changed.
  test(`${name}: robust-predicates is wrong near underflow`, {skip: robust === null}, () => {
    const random = generator(11);
    let wrong = 0;
    for (let i = 0; i < 2000; ++i) {
      const numbers = Array.from(
          {length: shape.points * shape.dimension}, () => families['subnormal grid'](random));
      if (Math.sign(robust[name](...numbers)) + 0 !== oracle(name, numbers)) ++wrong;
    }
    assert.ok(wrong > 0);
  });

  test(`${name}: a coordinate that is not finite gives NaN`, () => {
    for (const bad of [NaN, Infinity, -Infinity]) {
      for (let at = 0; at < shape.points * shape.dimension; ++at) {
        const numbers = Array.from(
            {length: shape.points * shape.dimension}, (_, i) => (i === at ? bad : i * i % 7));
        assert.ok(Number.isNaN(plumb[name](...numbers)), `${name}(${numbers})`);
      }
    }
  });
}

test('orient2d: the side of the line, the y axis upwards', () => {
  assert.ok(plumb.orient2d(0, 0, 1, 0, 0, 1) < 0);
  assert.ok(plumb.orient2d(0, 0, 1, 0, 0, -1) > 0);
  assert.equal(plumb.orient2d(0, 0, 1, 1, 2, 2), 0);
});

test('a magnitude approximates the determinant', () => {
  assert.equal(plumb.orient2d(0, 0, 3, 0, 0, 5), -15);
  assert.equal(plumb.orient3d(1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0), 6);
});

test('calls of the exact stages keep no memory', async () => {
  const text = readFileSync(join(dist, 'predicates.wasm.js'), 'utf8');
  const {instance} = await WebAssembly.instantiate(Buffer.from(text.match(/'(.*)'/)[1], 'base64'));
  const far = [
    1e300, 1e-300, 3e-310, 7, 5e299, 1e-200, -1e300, 5e-324, 2, 9e15, 1e100, -1e-100, 4, 1e-5, 8e307
  ];
  instance.exports.insphere(...far);
  const before = instance.exports.memory.buffer.byteLength;
  for (let i = 0; i < 1000; ++i) instance.exports.insphere(...far);
  assert.equal(instance.exports.memory.buffer.byteLength, before);
});

// L. Kettner et al., Classroom examples of robustness problems in geometric computations, ESA 2004:
// differences are rounded here, which the error bound of orient2d is for.
test('orient2d: points beside the diagonal', () => {
  for (let i = 0; i < 64; ++i) {
    for (let j = 0; j < 64; ++j) {
      const numbers = [12, 12, 24, 24, 0.5 + i * 2 ** -53, 0.5 + j * 2 ** -53];
      assert.equal(
          Math.sign(plumb.orient2d(...numbers)) + 0, oracle('orient2d', numbers),
          `orient2d(${numbers})`);
    }
  }
});

// Inputs that need the floors are too rare to be drawn. The constants are proved in C++, and are to
// be the same here.
test('the filters have the constants of C++', () => {
  const proved = readFileSync(
      join(here, '../../../predicates/plumb/predicates/input/input_filters.h'), 'utf8');
  const used = readFileSync(join(dist, 'predicates.js'), 'utf8');
  let count = 0;
  for (const [, name, factor] of proved.matchAll(/k(\w+Error) = (\d+) \* kEpsilon;/g)) {
    assert.ok(
        used.includes(`${name[0].toLowerCase()}${name.slice(1)} = ${factor} * epsilon`), name);
    ++count;
  }
  for (const [, name, exponent] of proved.matchAll(/k(\w+(?:Gate|Floor)) = 0x1p(-?\d+);/g)) {
    const here = name.replace('LiftGate', 'Gate');
    assert.ok(used.includes(`${here[0].toLowerCase()}${here.slice(1)} = 2 ** ${exponent}`), name);
    ++count;
  }
  assert.equal(count, 12);
});
