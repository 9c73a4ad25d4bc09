// Sets of the plane.
import {vector, vectors, withNumbers} from './fraction.js';
import {addressesOf, addressOf, wrap} from './handle.js';
import {
  badArgument,
  constant,
  copyOf,
  count,
  decode,
  engine,
  inFrame,
  real,
  shown,
  Struct,
  takeBytes,
  taken,
} from './memory.js';
import {
  containsPoints,
  describe,
  distanceBetween,
  isRaw,
  measure,
  PointSet,
  readOptions,
  ruleOf,
  self,
  simplified,
  takeSets,
  transformed,
  translated,
  writeOptions,
  written,
} from './sets.js';
import {Solid, takeMesh} from './solid.js';

const extrusionLayout = new Struct({
  height: 'f64',
  is_centred: 'bool',
  twist: 'f64',
  layers: 'u32',
  scale_x: 'f64',
  scale_y: 'f64'
});
const offsetLayout =
    new Struct({join: 'i32', mitre_limit: 'f64', chord_error: 'f64', circle_segments: 'u32'});
const roundingLayout = new Struct({
  vertices_moved: 'u32',
  vertices_merged: 'u32',
  edges_bent: 'u32',
  edges_folded: 'u32',
  collapsed: 'u32',
  largest_move: 'f64',
});

/** Chains of points [x, y] as flat arrays: coordinates, where each chain begins, and corners. */
function flattened(chains, what) {
  if (!Array.isArray(chains))
    throw badArgument(`${what} must be an array of chains of points, not ${shown(chains)}`);
  const xy = [], begin = [0];
  chains.forEach((chain, i) => {
    for (const number of vectors(chain, 2, `${what}[${i}]`)) xy.push(number);
    begin.push(xy.length / 2);
  });
  return {xy, begin, corners: Uint32Array.from({length: xy.length / 2}, (_, i) => i)};
}

/** Calls `make` with the addresses and counts that the functions of chains take. */
function withChains(frame, {xy, begin, corners}, make) {
  const points = frame.doubles(xy, 2, 'points');
  const offsets = frame.numbers(Uint32Array, begin, 'begin'),
        indices = frame.numbers(Uint32Array, corners, 'corners');
  return make(
      points.address, points.count, offsets.address, Math.max(offsets.count, 1) - 1,
      indices.address, indices.count);
}

/** A set of points of the plane: polygons, lines and points, each with or without its boundary. */
export class PlaneSet extends PointSet {
  static prefix = 'plumb_plane_set';
  static free = 'plumb_plane_set_free';
  static width = 2;
  static cells = ['vertex', 'edge', 'face'];
  static info = new Struct({
    vertices: 'u32',
    edges: 'u32',
    faces: 'u32',
    marked_faces: 'u32',
    bytes: 'u32',
    is_empty: 'bool',
    is_whole: 'bool',
    is_bounded: 'bool',
    is_closed: 'bool',
    is_open: 'bool',
  });

  static halfPlane(line, {closed = true} = {}) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vector(line, 3, 'the line'), 'the line',
            (numbers) =>
                wrap(PlaneSet, frame.makeBriefly('plumb_plane_set_half_plane', numbers, closed))));
  }
  static line(line) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vector(line, 3, 'the line'), 'the line',
            (numbers) => wrap(PlaneSet, frame.makeBriefly('plumb_plane_set_line', numbers))));
  }
  static box(low, high, options) {
    const [x0, y0] = vector(low, 2, 'the lower corner'),
               [x1, y1] = vector(high, 2, 'the upper corner');
    return PlaneSet.polygon([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], options);
  }
  static disk(radius, chords = 30, options) {
    return inFrame(
        options,
        (frame) => wrap(
            PlaneSet,
            frame.make('plumb_plane_set_disk', real(radius, 'radius'), count(chords, 'chords'))));
  }
  static polygon(points, {closed = true, ...options} = {}) {
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, vectors(points, 2, 'points'), 'points',
            (numbers) => wrap(PlaneSet, frame.make('plumb_plane_set_polygon', numbers, closed))));
  }
  static polygons(rings, options) {
    const {xy, begin, corners} = flattened(rings, 'rings');
    return PlaneSet.fromRings(xy, begin, corners, options);
  }
  static fromRings(points, ringBegin, corners, {rule, closed = true, ...options} = {}) {
    return inFrame(
        options,
        (frame) => withChains(
            frame, {xy: points, begin: ringBegin, corners},
            (...arrays) => wrap(
                PlaneSet,
                frame.make('plumb_plane_set_polygons', ...arrays, ruleOf(rule), closed))));
  }
  static polyline(points, options) { return PlaneSet.polylines([points], options); }
  static polylines(chains, options) {
    return inFrame(
        options,
        (frame) => withChains(
            frame, flattened(chains, 'chains'),
            (...arrays) => wrap(PlaneSet, frame.make('plumb_plane_set_polylines', ...arrays))));
  }
  static hull(points, options) {
    if (points instanceof Float64Array) {
      return inFrame(options, (frame) => {
        const {address, count: length} = frame.doubles(points, 2, 'points');
        return wrap(PlaneSet, frame.make('plumb_plane_set_hull', address, length));
      });
    }
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, vectors(points, 2, 'points'), 'points',
            (numbers) => wrap(PlaneSet, frame.make('plumb_plane_set_hull_exact', numbers))));
  }
  static hullOf(sets, options) {
    return inFrame(options, (frame) => {
      const {address, count: length} = addressesOf(frame, sets, PlaneSet, 'sets');
      return wrap(PlaneSet, frame.make('plumb_plane_set_hull_of', address, length));
    });
  }

  static read(data, options = {}) {
    return inFrame(options, (frame) => {
      const bytes = frame.bytes(data, 'the file');
      const {address, notes} = frame.makeWithNotes(
          'plumb_plane_set_read', bytes.address, bytes.count, readOptions(frame, options));
      frame.tell(notes);
      return wrap(PlaneSet, address);
    });
  }
  static fromBytes(data) { return PlaneSet.read(data, {name: 'data.nef2'}); }
  write(format, options = {}) {
    const write = (frame, grid) => written(
        frame, 'plumb_plane_set_write', self(this), frame.text(format, 'format'),
        writeOptions(frame, isRaw(options.rounding), grid));
    return inFrame(
        options,
        (frame) => options.grid === undefined ?
            write(frame, 0) :
            withNumbers(frame, [options.grid], 'the grid', (grid) => write(frame, grid)));
  }
  toBytes(options) { return this.write('nef2', options); }
  toWkt(options) { return decode(this.write('wkt', options)); }
  toGeoJson(options) { return JSON.parse(decode(this.write('geojson', options))); }
  draw(format, options = {}) {
    return inFrame(
        options,
        (frame) => takeBytes(frame.make(
            'plumb_plane_set_draw', self(this), frame.text(format, 'format'),
            frame.text(options.title, 'title'))));
  }
  toHtml(options) { return decode(this.draw('html', options)); }

  shapes(options) {
    return inFrame(options, (frame) => {
      const shapes = frame.make('plumb_plane_set_shapes', self(this));
      return taken(shapes, 'plumb_shapes_free', arraysOf);
    });
  }
  rounded({step, ...options} = {}) {
    const round = (frame, numbers) => {
      const out = frame.block(4), report = frame.struct(roundingLayout);
      frame.check('plumb_plane_set_round', self(this), numbers, out, report, frame.context());
      const facts = roundingLayout.read(report);
      return {
        set: wrap(PlaneSet, frame.u32(out)),
        report: {
          verticesMoved: facts.vertices_moved,
          verticesMerged: facts.vertices_merged,
          edgesBent: facts.edges_bent,
          edgesFolded: facts.edges_folded,
          collapsed: facts.collapsed,
          largestMove: facts.largest_move,
        },
      };
    };
    return inFrame(
        options,
        (frame) => step === undefined ?
            round(frame, 0) :
            withNumbers(frame, [step], 'the step', (numbers) => round(frame, numbers)));
  }
  triangulated(options) {
    return inFrame(
        options, (frame) => takeMesh(frame.make('plumb_plane_set_triangulate', self(this))));
  }

  transformed(rows, options) { return transformed(this, rows, options); }
  translated(by, options) { return translated(this, by, options); }
  offset(
      distance,
      {join = 'round', mitreLimit = 2, chordError = 0, circleSegments = 0, ...options} = {}) {
    return inFrame(options, (frame) => {
      const how = frame.struct(offsetLayout, {
        join: constant(['round', 'mitre', 'square', 'bevel'], join, 'join'),
        mitre_limit: real(mitreLimit, 'mitreLimit'),
        chord_error: real(chordError, 'chordError'),
        circle_segments: count(circleSegments, 'circleSegments'),
      });
      return wrap(
          PlaneSet,
          frame.make('plumb_plane_set_offset', self(this), real(distance, 'distance'), how));
    });
  }
  simplified(options) { return this.simplifiedWithReport(options).set; }
  simplifiedWithReport(options) {
    return inFrame(options, (frame) => {
      const {made, report} =
          simplified(frame, 'plumb_plane_set_simplify_with_report', this, options);
      return {set: wrap(PlaneSet, made), report};
    });
  }
  minkowskiSum(other, options) {
    return inFrame(
        options,
        (frame) => wrap(
            PlaneSet,
            frame.make(
                'plumb_plane_set_minkowski_sum', self(this), addressOf(other, PlaneSet, 'other'))));
  }
  decompose({method = 'best', closed = false, ...options} = {}) {
    const methods = ['best', 'cuts', 'diagonals', 'optimal'];
    return inFrame(
        options,
        (frame) => takeSets(
            PlaneSet,
            frame.make(
                'plumb_plane_set_decompose', self(this), constant(methods, method, 'method'),
                closed)));
  }
  convexHull(options) { return PlaneSet.hullOf([this], options); }
  extruded(height, {centred = false, twist = 0, layers = 1, scale = [1, 1], ...options} = {}) {
    return inFrame(options, (frame) => {
      const [x, y] = vector(Array.isArray(scale) ? scale : [scale, scale], 2, 'scale');
      const how = frame.struct(extrusionLayout, {
        height: real(height, 'height'),
        is_centred: centred,
        twist: real(twist, 'twist'),
        layers: count(layers, 'layers'),
        scale_x: real(x, 'scale'),
        scale_y: real(y, 'scale'),
      });
      return wrap(Solid, frame.make('plumb_plane_set_extrude', self(this), how));
    });
  }
  revolved({angle = 360, steps = 30, ...options} = {}) {
    return inFrame(
        options,
        (frame) => wrap(
            Solid,
            frame.make(
                'plumb_plane_set_revolve', self(this), real(angle, 'angle'),
                count(steps, 'steps'))));
  }

  containsPoints(points, options) { return containsPoints(this, points, options); }
  counts() {
    const {vertices, edges, faces, marked_faces: markedFaces} = describe(this);
    return {vertices, edges, faces, markedFaces};
  }
  isBounded() { return describe(this).is_bounded; }
  isConvex(options) { return this.convexity(options).isConvex; }
  convexity(options) {
    return inFrame(options, (frame) => {
      const convex = frame.block(1), corners = frame.block(8), parts = frame.block(8);
      frame.check('plumb_plane_set_convexity', self(this), convex, corners, parts, frame.context());
      return {
        isConvex: frame.flag(convex),
        reflexCorners: frame.u64(corners),
        parts: frame.u64(parts)
      };
    });
  }
  /** Nearest points of the closures of this set and another one. */
  distance(other, options) { return distanceBetween(this, other, options); }
  area(options) { return measure(this, 'area', options); }
}

/** The arrays of shapes of the engine. */
function arraysOf(shapes) {
  const number = (name) => engine()[`_plumb_shapes_${name}_count`](shapes) >>> 0;
  const array = (Type, name, length) =>
      copyOf(Type, engine()[`_plumb_shapes_${name}`](shapes), length);
  const polygons = number('polygon'), rings = number('ring'), lines = number('line');
  const ringBegin = array(Uint32Array, 'ring_begin', rings + 1),
        lineBegin = array(Uint32Array, 'line_begin', lines + 1);
  return {
    points: array(Float64Array, 'points', 2 * number('point')),
    polygonBegin: array(Uint32Array, 'polygon_begin', polygons + 1),
    ringBegin,
    ringCorners: array(Uint32Array, 'ring_corners', ringBegin[rings]),
    lineBegin,
    lineCorners: array(Uint32Array, 'line_corners', lineBegin[lines]),
    singles: array(Uint32Array, 'singles', number('single')),
  };
}
