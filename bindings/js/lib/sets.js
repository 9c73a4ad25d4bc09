// What sets of space, of the plane and of the sphere have in common: defineSet() adds it to a
// class.
//
// A class states the prefix of its functions in C (`prefix`), how many numbers a point has
// (`width`), and what its cells are called
// (`cells`). Every operation takes options last: {timeout, memoryLimit, onProgress, signal}.
import {takeNumbers, vector, vectors, withNumbers} from './fraction.js';
import {addressesOf, addressOf, Handle, wrap} from './handle.js';
import {
  badArgument,
  copyOf,
  decode,
  engine,
  inFrame,
  real,
  shown,
  Struct,
  takeBytes,
} from './memory.js';

export const operations = {
  union: 14,
  intersection: 8,
  difference: 2,
  symmetricDifference: 6
};
export const rules = {
  positive: 3,
  nonzero: 1,
  evenodd: 2
};

/** The winding numbers that are inside: undefined for those that are the default. */
export function ruleOf(rule) {
  if (rule === undefined || rule === null) return 0;
  if (Object.hasOwn(rules, rule)) return rules[rule];
  throw badArgument(`rule must be 'positive', 'nonzero' or 'evenodd', not ${shown(rule)}`);
}

/** A set of points. Immutable. */
export class PointSet extends Handle {
  static empty() {
    return inFrame(undefined, (frame) => wrap(this, frame.makeBriefly(`${this.prefix}_empty`)));
  }
  static whole() {
    return inFrame(undefined, (frame) => wrap(this, frame.makeBriefly(`${this.prefix}_whole`)));
  }
  static point(point) { return this.points([point]); }
  static points(points, options) {
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, vectors(points, this.width, 'points'), 'points',
            (list) => wrap(this, frame.make(`${this.prefix}_points`, list))));
  }
  static unionOf(sets, options) { return ofMany(this, 'union_of', sets, options); }
  static intersectionOf(sets, options) { return ofMany(this, 'intersection_of', sets, options); }

  copy() {
    return inFrame(
        undefined,
        (frame) => wrap(
            this.constructor, frame.makeBriefly(`${this.constructor.prefix}_copy`, self(this))));
  }

  union(other, options) { return combined(this, other, 'union', options); }
  intersection(other, options) { return combined(this, other, 'intersection', options); }
  difference(other, options) { return combined(this, other, 'difference', options); }
  symmetricDifference(other, options) {
    return combined(this, other, 'symmetric_difference', options);
  }

  complement(options) { return derived(this, 'complement', options); }
  interior(options) { return derived(this, 'interior', options); }
  closure(options) { return derived(this, 'closure', options); }
  boundary(options) { return derived(this, 'boundary', options); }
  exterior(options) { return derived(this, 'exterior', options); }
  regularization(options) { return derived(this, 'regularization', options); }

  isEmpty() { return engine()[`_${this.constructor.prefix}_is_empty`](self(this)) !== 0; }
  isWhole() { return engine()[`_${this.constructor.prefix}_is_whole`](self(this)) !== 0; }
  isClosed() { return describe(this).is_closed; }
  isOpen() { return describe(this).is_open; }
  memoryBytes() { return describe(this).bytes; }

  equals(other) {
    return inFrame(undefined, (frame) => {
      const out = frame.block(1);
      frame.check(
          `${this.constructor.prefix}_equals`, self(this),
          addressOf(other, this.constructor, 'other'), out);
      return frame.flag(out);
    });
  }
  isSubsetOf(other, options) {
    return inFrame(options, (frame) => {
      const out = frame.block(1);
      frame.check(
          `${this.constructor.prefix}_is_subset`, self(this),
          addressOf(other, this.constructor, 'other'), out, frame.context());
      return frame.flag(out);
    });
  }

  /** The cell that contains a point. */
  locate(point, options) { return this.locateAll([point], options)[0]; }
  locateAll(points, options) {
    const {prefix, width} = this.constructor;
    return inFrame(
        options,
        (frame) => withNumbers(frame, vectors(points, width, 'points'), 'points', (list) => {
          const count = (engine()._plumb_numbers_count(list) >>> 0) / width;
          const cells = frame.block(12 * count);
          frame.check(`${prefix}_locate`, self(this), list, cells, count, frame.context());
          return Array.from({length: count}, (_, i) => cellAt(this, cells + 12 * i));
        }));
  }
  contains(point, options) { return this.locate(point, options).isInside; }

  /** The first cell of the set on a ray; null if there is none. */
  shoot(origin, direction, options) { return shot(this, origin, direction, false, options); }
  shootToBoundary(origin, direction, options) {
    return shot(this, origin, direction, true, options);
  }

  /** The first broken invariant as a sentence; null if there is none. */
  audit(options) {
    return inFrame(options, (frame) => {
      const flaw = frame.make(`${this.constructor.prefix}_audit`, self(this));
      return flaw === 0 ? null : decode(takeBytes(flaw));
    });
  }
}

export function self(object) { return addressOf(object, object.constructor, 'the object'); }

function ofMany(Class, name, sets, options) {
  return inFrame(options, (frame) => {
    const {address, count} = addressesOf(frame, sets, Class, 'sets');
    return wrap(Class, frame.make(`${Class.prefix}_${name}`, address, count));
  });
}

function combined(set, other, name, options) {
  const Class = set.constructor;
  return inFrame(
      options,
      (frame) => wrap(
          Class,
          frame.make(`${Class.prefix}_${name}`, self(set), addressOf(other, Class, 'other'))));
}

/** A set that a function without further inputs makes of a set. */
export function derived(set, name, options) {
  const Class = set.constructor;
  return inFrame(options, (frame) => wrap(Class, frame.make(`${Class.prefix}_${name}`, self(set))));
}

/** The facts that the describing function of a class fills in. */
export function describe(set) {
  const {prefix, info} = set.constructor;
  return inFrame(undefined, (frame) => {
    const facts = frame.struct(info);
    frame.check(`${prefix}_describe`, self(set), facts);
    return info.read(facts);
  });
}

/** Whether each of many points, in an array of coordinates, belongs to the set. */
export function containsPoints(set, coordinates, options) {
  const {prefix, width} = set.constructor;
  return inFrame(options, (frame) => {
    const {address, count} = frame.doubles(coordinates, width, 'points');
    const inside = frame.block(count);
    frame.check(`${prefix}_contains`, self(set), address, count, inside, frame.context());
    return copyOf(Uint8Array, inside, count);
  });
}

/** The image under an affine map of rows; each row has the matrix and then the translation. */
export function transformed(set, rows, options) {
  const Class = set.constructor, width = Class.width;
  if (!Array.isArray(rows) || rows.length !== width)
    throw badArgument(`the matrix must have ${width} rows of ${width + 1} numbers`);
  const entries = rows.flatMap((row, i) => vector(row, width + 1, `row ${i} of the matrix`));
  return inFrame(
      options,
      (frame) => withNumbers(
          frame, entries, 'the matrix',
          (map) => wrap(Class, frame.make(`${Class.prefix}_transform`, self(set), map))));
}

export function translated(set, by, options) {
  const shift = vector(by, set.constructor.width, 'the vector');
  return transformed(
      set, shift.map((step, i) => [...shift.map((_, j) => (i === j ? 1 : 0)), step]), options);
}

/** The exact measure of a function that gives one number, or none for an infinite one: null. */
export function measure(set, name, options) {
  return inFrame(
      options,
      (frame) =>
          takeNumbers(frame.make(`${set.constructor.prefix}_${name}`, self(set)))[0] ?? null);
}

/** Nearest points of the closures of two sets, and the cells that have them. */
export function distanceBetween(set, other, options) {
  const Class = set.constructor, {prefix, width} = Class;
  return inFrame(options, (frame) => {
    const out = frame.block(4), cells = frame.block(24);
    frame.check(
        `${prefix}_distance`, self(set), addressOf(other, Class, 'other'), out, cells,
        frame.context());
    const numbers = takeNumbers(frame.u32(out));
    return {
      squared: numbers[0],
      points: [numbers.slice(1, 1 + width), numbers.slice(1 + width)],
      cells: [cellAt(set, cells), cellAt(other, cells + 12)],
    };
  });
}

/** The sets of a list, which is released. */
const simplifyLayout = new Struct({
  corners_before: 'u64',
  corners_after: 'u64',
  fixed: 'u64',
  blocked: 'u64',
  overlaps: 'u64',
  borders_moved: 'f64',
  rounding_moved: 'f64',
});

/**
 * Calls a function of C that simplifies a set or a layer: the address of what it made, and what
 * it says.
 */
export function simplified(frame, name, object, options) {
  const {tolerance = Infinity, kept = 0, within = Infinity} = options ?? {};
  const out = frame.block(4), facts = frame.struct(simplifyLayout);
  frame.check(
      name, self(object), real(tolerance, 'tolerance'), real(kept, 'kept'), real(within, 'within'),
      out, facts, frame.context());
  const told = simplifyLayout.read(facts);
  const report = {
    cornersBefore: told.corners_before,
    cornersAfter: told.corners_after,
    fixed: told.fixed,
    blocked: told.blocked,
    overlaps: told.overlaps,
    bordersMoved: told.borders_moved,
    roundingMoved: told.rounding_moved,
  };
  return {made: frame.u32(out), report};
}

export function takeSets(Class, list) {
  const length = engine()[`_${Class.prefix}_list_count`](list) >>> 0;
  try {
    return Array.from(
        {length},
        (_, i) => inFrame(
            undefined,
            (frame) => wrap(
                Class,
                frame.makeBriefly(
                    `${Class.prefix}_copy`, engine()[`_${Class.prefix}_list_at`](list, i)))));
  } finally {
    engine()[`_${Class.prefix}_list_free`](list);
  }
}

function cellAt(set, address) {
  const view = new DataView(engine().HEAPU8.buffer, address, 12);
  return {
    kind: set.constructor.cells[view.getInt32(0, true)],
    index: view.getUint32(4, true),
    isInside: view.getUint8(8) !== 0
  };
}

function shot(set, origin, direction, toBoundary, options) {
  const {prefix, width} = set.constructor;
  const ray =
      [...vector(origin, width, 'the origin'), ...vector(direction, width, 'the direction')];
  return inFrame(
      options,
      (frame) => withNumbers(frame, ray, 'the ray', (list) => {
        const hit = frame.block(1), cell = frame.block(12), point = frame.block(4);
        frame.check(
            `${prefix}_shoot`, self(set), list, toBoundary, hit, cell, point, frame.context());
        return frame.flag(hit) ? {cell: cellAt(set, cell), point: takeNumbers(frame.u32(point))} :
                                 null;
      }));
}

// ---- files

const readLayout = new Struct({name: 'pointer', exact_decimals: 'bool', attributes: 'u32'});
const writeLayout = new Struct({raw: 'bool', grid: 'pointer'});

export function readOptions(frame, {name, exactDecimals, attributes} = {}) {
  return frame.struct(readLayout, {
    name: frame.text(name, 'name'),
    exact_decimals: exactDecimals,
    attributes: attributes === true ? 1 : 0
  });
}

export function writeOptions(frame, raw, grid = 0) {
  return frame.struct(writeLayout, {raw, grid});
}

/** Whether coordinates become the nearest numbers even if the result is not valid. */
export function isRaw(rounding) {
  if (rounding === undefined || rounding === 'valid') return false;
  if (rounding === 'nearest') return true;
  throw badArgument(`rounding must be 'valid' or 'nearest', not ${shown(rounding)}`);
}

/** The bytes that a writing function with notes makes. */
export function written(frame, name, ...inputs) {
  const {address, notes} = frame.makeWithNotes(name, ...inputs);
  frame.tell(notes);
  return takeBytes(address);
}

let folders = 0;

/**
 * Runs a body with files in the module's memory, {name: bytes}, in a folder that is gone
 * afterwards. While the body runs, it is the current folder, so that names of files are all that
 * messages and sources have.
 */
export function withFiles(files, body) {
  const {FS} = engine();
  const folder = `/files${++folders}`, before = FS.cwd();
  FS.mkdir(folder);
  FS.chdir(folder);
  try {
    for (const [name, data] of Object.entries(files))
      FS.writeFile(fileName(name), bytesOf(data, name));
    return body();
  } finally {
    FS.chdir(before);
    for (const name of namesIn(folder)) FS.unlink(`${folder}/${name}`);
    FS.rmdir(folder);
  }
}

const namesIn = (folder) =>
    engine().FS.readdir(folder).filter((name) => name !== '.' && name !== '..');

/** A name, unless it leads out of its folder or stands for something else than a file. */
function fileName(name) {
  if (typeof name !== 'string' || name.includes('/') || ['', '.', '..', '-'].includes(name))
    throw badArgument(`${shown(name)} is no name of a file: names have no folders`);
  return name;
}

/** The files that a body writes, {name: bytes}. It gets the address of the name of the first. */
export function filesBy(frame, name, body) {
  return withFiles({}, () => {
    body(frame.text(fileName(name), 'name'));
    return Object.fromEntries(namesIn('.').map((file) => [file, engine().FS.readFile(file)]));
  });
}

function bytesOf(data, name) {
  if (typeof data === 'string') return new TextEncoder().encode(data);
  if (data instanceof ArrayBuffer) return new Uint8Array(data);
  if (ArrayBuffer.isView(data))
    return new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  throw badArgument(`${name} must be a Uint8Array, an ArrayBuffer or a string, not ${shown(data)}`);
}
