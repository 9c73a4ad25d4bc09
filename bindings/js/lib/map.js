// Planar maps: lists of points and cycles, their check, and overlays.
import {Fraction, takeNumbers, vectors, withNumbers} from './fraction.js';
import {addressOf, Handle, wrap} from './handle.js';
import {
  badArgument,
  constant,
  copyOf,
  count,
  decode,
  engine,
  inFrame,
  notesOf,
  shown,
  Struct,
  takeBytes,
  taken,
  textAt,
} from './memory.js';
import {PlaneSet} from './plane_set.js';
import {isRaw, readOptions, self, withFiles, writeOptions} from './sets.js';

const optionsLayout =
    new Struct({outer: 'i32', merge_vertices: 'bool', name_places: 'bool', max_defects: 'u64'});
const countsLayout = new Struct({
  verdict: 'i32',
  vertices: 'u32',
  edges: 'u32',
  cycles: 'u32',
  components: 'u32',
  regions: 'u32',
  duplicate: 'u64',
  open: 'u64',
  crossing: 'u64',
  twin: 'u64',
  mixed: 'u64',
  nested: 'u64',
});
const defectLayout = new Struct({
  kind: 'i32',
  cycles: 'pointer',
  cycle_count: 'u32',
  edges: 'pointer',
  edge_count: 'u32',
  x: 'pointer',
  y: 'pointer',
  near_x: 'f64',
  near_y: 'f64',
  hint: 'pointer',
});
const kinds = ['duplicate', 'open', 'crossing', 'twin', 'mixed', 'nested'];
const verdicts = ['valid', 'not planar', 'open', 'superposed'];

/** Points, and cycles of indices of points: perhaps a planar subdivision. */
export class Map extends Handle {
  static free = 'plumb_map_free';

  static fromCycles(points, cycles, options) {
    if (!Array.isArray(cycles))
      throw badArgument(`cycles must be an array of cycles, not ${shown(cycles)}`);
    const begin = [0], corners = [];
    for (const cycle of cycles) {
      for (const corner of cycle) corners.push(corner);
      begin.push(corners.length);
    }
    return Map.fromArrays(points, begin, corners, options);
  }
  static fromArrays(points, cycleBegin, corners) {
    return inFrame(undefined, (frame) => {
      const begin = frame.numbers(Uint32Array, cycleBegin, 'cycleBegin'),
            indices = frame.numbers(Uint32Array, corners, 'corners');
      return withNumbers(
          frame, vectors(points, 2, 'points'), 'points',
          (numbers) => wrap(
              Map,
              frame.makeBriefly(
                  'plumb_map_from_exact_cycles', numbers, begin.address,
                  Math.max(begin.count, 1) - 1, indices.address, indices.count)));
    });
  }
  static read(data, options = {}) {
    const name = options.name ?? 'data.map';
    return inFrame(
        options, (frame) => withFiles({[name]: data}, () => {
                   const out = frame.block(4), isPolygons = frame.block(1), notes = frame.block(4);
                   frame.check(
                       'plumb_map_read_file', frame.text(name, 'name'), readOptions(frame, options),
                       out, isPolygons, notes, frame.context());
                   frame.tell(frame.notes(notes));
                   return wrap(Map, frame.u32(out));
                 }));
  }
  write() {
    return inFrame(
        undefined, (frame) => takeBytes(frame.makeBriefly('plumb_map_write', self(this))));
  }

  get pointCount() { return engine()._plumb_map_point_count(self(this)) >>> 0; }
  get cycleCount() { return engine()._plumb_map_cycle_count(self(this)) >>> 0; }
  /** The nearest doubles of the coordinates. */
  points() {
    return copyOf(Float64Array, engine()._plumb_map_points(self(this)), 2 * this.pointCount);
  }
  cycles() {
    const begin =
        copyOf(Uint32Array, engine()._plumb_map_cycle_begin(self(this)), this.cycleCount + 1);
    const corners =
        copyOf(Uint32Array, engine()._plumb_map_corners(self(this)), begin[begin.length - 1]);
    return Array.from(
        {length: this.cycleCount}, (_, i) => Array.from(corners.subarray(begin[i], begin[i + 1])));
  }

  check({outer = 'listed', mergeVertices = false, maxDefects = 1000, ...options} = {}) {
    return inFrame(options, (frame) => {
      const how = frame.struct(optionsLayout, {
        outer: constant(['listed', 'infer', 'ignore'], outer, 'outer'),
        merge_vertices: mergeVertices,
        max_defects: count(maxDefects, 'maxDefects'),
      });
      return wrap(MapReport, frame.make('plumb_map_check', self(this), how));
    });
  }
}

/** What a check says of a map. */
export class MapReport extends Handle {
  static free = 'plumb_map_report_free';

  get verdict() { return verdicts[engine()._plumb_map_report_verdict(self(this))]; }
  get isValid() { return engine()._plumb_map_report_verdict(self(this)) === 0; }
  counts() {
    return inFrame(undefined, (frame) => {
      const out = frame.struct(countsLayout);
      frame.check('plumb_map_report_count', self(this), out);
      const {verdict, vertices, edges, cycles, components, regions, ...defects} =
          countsLayout.read(out);
      return {vertices, edges, cycles, components, regions, defects};
    });
  }
  defects() {
    const length = engine()._plumb_map_report_defect_count(self(this)) >>> 0;
    return Array.from({length}, (_, i) => inFrame(undefined, (frame) => {
                                  const out = frame.struct(defectLayout);
                                  frame.check('plumb_map_report_defect', self(this), i, out);
                                  return defectOf(defectLayout.read(out));
                                }));
  }
  warnings() {
    return notesOf(engine()._plumb_map_report_warnings(self(this))).map(({text}) => text);
  }
  regions() {
    return Array.from(
        {length: this.counts().regions},
        (_, i) => inFrame(undefined, (frame) => {
          const length = frame.block(4);
          const cycles = engine()._plumb_map_report_region(self(this), i, length);
          return Array.from(copyOf(Uint32Array, cycles, frame.u32(length)));
        }));
  }
  map() {
    return inFrame(
        undefined, (frame) => wrap(Map, frame.makeBriefly('plumb_map_report_map', self(this))));
  }
  select(regions, {closed = true, ...options} = {}) {
    return inFrame(options, (frame) => {
      const length = this.counts().regions, chosen = frame.block(length);
      for (const region of regions) {
        if (count(region, 'a region') >= length)
          throw badArgument(`there is no region ${region}; there are ${length}`);
        engine().HEAPU8[chosen + region] = 1;
      }
      return wrap(
          PlaneSet, frame.make('plumb_map_report_to_set', self(this), chosen, length, closed));
    });
  }
  dcel() {
    return inFrame(
        undefined, (frame) => takeDcel(frame.makeBriefly('plumb_map_report_dcel', self(this))));
  }
  write(format, {title} = {}) {
    return inFrame(
        undefined,
        (frame) => takeBytes(frame.makeBriefly(
            'plumb_map_report_write', self(this), frame.text(format, 'format'),
            frame.text(title, 'title'))));
  }
  toString() { return decode(this.write('text')); }
  toHtml(options) { return decode(this.write('html', options)); }
}

function defectOf({
  kind,
  cycles,
  cycle_count: cycleCount,
  edges,
  edge_count: edgeCount,
  x,
  y,
  near_x: nearX,
  near_y: nearY,
  hint
}) {
  const ends = copyOf(Uint32Array, edges, 2 * edgeCount);
  return {
    kind: kinds[kind],
    cycles: Array.from(copyOf(Uint32Array, cycles, cycleCount)),
    edges: Array.from({length: edgeCount}, (_, i) => [ends[2 * i], ends[2 * i + 1]]),
    point: x === 0 ? null : [Fraction.from(textAt(x)), Fraction.from(textAt(y))],
    near: x === 0 ? null : [nearX, nearY],
    hint: textAt(hint),
  };
}

/** The arrays of a half-edge structure, which is released. The twin of half-edge h is h ^ 1. */
function takeDcel(dcel) { return taken(dcel, 'plumb_dcel_free', arraysOf); }

function arraysOf(dcel) {
  const number = (name) => engine()[`_plumb_dcel_${name}_count`](dcel) >>> 0;
  const array = (Type, name, length) => copyOf(Type, engine()[`_plumb_dcel_${name}`](dcel), length);
  const vertices = number('vertex'), halfedges = number('halfedge');
  return {
    faceCount: number('face'),
    points: array(Float64Array, 'points', 2 * vertices),
    origin: array(Uint32Array, 'origin', halfedges),
    next: array(Uint32Array, 'next', halfedges),
    prev: array(Uint32Array, 'prev', halfedges),
    face: array(Uint32Array, 'face', halfedges),
    leaving: array(Uint32Array, 'leaving', vertices),
  };
}

/** The subdivision of the plane by the edges of two valid maps. */
export class MapOverlay extends Handle {
  static free = 'plumb_overlay_free';

  get faceCount() { return engine()._plumb_overlay_face_count(self(this)) >>> 0; }
  /** For each face the region of the first map and that of the second one. */
  regions() {
    const flat =
        copyOf(Uint32Array, engine()._plumb_overlay_regions(self(this)), 2 * this.faceCount);
    return Array.from({length: this.faceCount}, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
  }
  areas() {
    return inFrame(
        undefined, (frame) => takeNumbers(frame.makeBriefly('plumb_overlay_areas', self(this))));
  }
  dcel() {
    return inFrame(
        undefined, (frame) => takeDcel(frame.makeBriefly('plumb_overlay_dcel', self(this))));
  }
  write(format, options = {}) {
    return inFrame(
        options,
        (frame) => takeBytes(frame.make(
            'plumb_overlay_write', self(this), frame.text(format, 'format'),
            writeOptions(frame, isRaw(options.rounding)), frame.text(options.title, 'title'))));
  }
}

/** Overlays two valid maps exactly. */
export function overlay(first, second, options) {
  return inFrame(
      options,
      (frame) => wrap(
          MapOverlay,
          frame.make(
              'plumb_overlay_new', addressOf(first, MapReport, 'first'),
              addressOf(second, MapReport, 'second'))));
}
