// Polygons on surfaces: scenes, the cells into which polygons divide a surface, and geodesics.
import {withNumbers} from './fraction.js';
import {addressOf, Handle, wrap} from './handle.js';
import {
  badArgument,
  copyOf,
  count,
  decode,
  engine,
  inFrame,
  shown,
  Struct,
  takeBytes,
  takeIndices,
  taken,
} from './memory.js';
import {readOptions, ruleOf, self, withFiles} from './sets.js';
import {takeMesh} from './solid.js';

const infoLayout = new Struct({
  triangles: 'u32',
  segments: 'u32',
  crossings: 'u32',
  cells: 'u32',
  cell_edges: 'u32',
  shapes: 'u32',
});

/**
 * A surface of triangles with points and polygons on it. Points and polygons can be added until it
 * is divided.
 */
export class Scene extends Handle {
  static free = 'plumb_scene_free';

  static fromMesh(vertices, triangles) {
    return inFrame(undefined, (frame) => {
      const points = frame.doubles(vertices, 3, 'vertices'),
            faces = frame.records(Uint32Array, triangles, 3, 'triangles');
      return wrap(
          Scene,
          frame.makeBriefly(
              'plumb_scene_new', points.address, points.count, faces.address, faces.count));
    });
  }
  /** `files` has the files that the scene names. */
  static read(data, {name = 'scene.json', files = {}, ...options} = {}) {
    return inFrame(options, (frame) => withFiles({...files, [name]: data}, () => {
                              const {address, notes} = frame.makeWithNotes(
                                  'plumb_scene_read_file', frame.text(name, 'name'),
                                  readOptions(frame, options));
                              frame.tell(notes);
                              return wrap(Scene, address);
                            }));
  }
  /** The scene as JSON; `model` is the name of the file of its mesh. */
  write(model) {
    return inFrame(
        undefined,
        (frame) => takeBytes(
            frame.makeBriefly('plumb_scene_write', self(this), frame.text(model, 'model'))));
  }

  get polygonCount() { return engine()._plumb_scene_polygon_count(self(this)) >>> 0; }
  /** Adds the point of a face whose second and third corner have the weights u and v. */
  addPoint(face, [u, v]) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, [u, v], 'weights',
            (weights) =>
                indexOf(frame, 'plumb_scene_add_point', self(this), count(face, 'face'), weights)));
  }
  /** Adds the closed polygon of geodesics through points. */
  addPolygon(points, options) {
    return inFrame(options, (frame) => {
      const {address, count: length} = frame.numbers(Uint32Array, points, 'points');
      const out = frame.block(4);
      frame.check('plumb_scene_add_polygon', self(this), address, length, out, frame.context());
      return frame.u32(out);
    });
  }
  /** Adds a shape, the sum of polygons. Without shapes, each polygon is one. */
  addShape(polygons) {
    return inFrame(undefined, (frame) => {
      const {address, count: length} = frame.numbers(Uint32Array, polygons, 'polygons');
      return indexOf(frame, 'plumb_scene_add_shape', self(this), address, length);
    });
  }
  setOutside(face) {
    inFrame(
        undefined,
        (frame) => frame.check('plumb_scene_set_outside', self(this), count(face, 'face')));
  }
  /** Adds loops around handles, so that shapes separate the surface; returns how many. */
  separate(options) {
    return inFrame(options, (frame) => {
      const added = frame.block(4);
      frame.check('plumb_scene_separate', self(this), added, frame.context());
      return frame.u32(added);
    });
  }
  /**
   * A path between two points; null between components. It is a locally shortest path, or with
   * `shortest` a shortest path of all.
   */
  geodesic(from, to, options) {
    return inFrame(options, (frame) => {
      const path = frame.make(
          'plumb_scene_trace', self(this), count(from, 'from'), count(to, 'to'),
          options?.shortest ? 1 : 0);
      return taken(path, 'plumb_path_free', () => {
        const length = engine()._plumb_path_count(path) >>> 0;
        if (length === 0) return null;
        return {
          length: engine()._plumb_path_length(path),
          points: copyOf(Float64Array, engine()._plumb_path_points(path), 3 * length),
          faces: copyOf(Uint32Array, engine()._plumb_path_faces(path), length - 1),
        };
      });
    });
  }
  divide(options) {
    return inFrame(
        options, (frame) => wrap(SurfaceDivision, frame.make('plumb_surface_divide', self(this))));
  }
}

function indexOf(frame, name, ...inputs) {
  const out = frame.block(4);
  frame.check(name, ...inputs, out);
  return frame.u32(out);
}

/** A surface that polygons divide into cells. */
export class SurfaceDivision extends Handle {
  static free = 'plumb_surface_free';

  counts() {
    return inFrame(undefined, (frame) => {
      const out = frame.struct(infoLayout);
      frame.check('plumb_surface_describe', self(this), out);
      const {cell_edges: cellEdges, ...rest} = infoLayout.read(out);
      return {...rest, cellEdges};
    });
  }
  /** How often shapes wind around a cell: [{shape, value}], without zeros. */
  labels(cell) {
    return inFrame(undefined, (frame) => {
      const length = frame.block(4);
      const labels = engine()._plumb_surface_labels(self(this), cellOf(this, cell), length);
      const flat = copyOf(Int32Array, labels, 2 * frame.u32(length));
      return Array.from(
          {length: flat.length / 2}, (_, i) => ({shape: flat[2 * i], value: flat[2 * i + 1]}));
    });
  }
  area(cell) { return engine()._plumb_surface_area(self(this), cellOf(this, cell)); }
  neighbours() {
    return inFrame(undefined, (frame) => {
      const length = frame.block(4);
      const pairs = engine()._plumb_surface_neighbours(self(this), length);
      return copyOf(Uint32Array, pairs, 2 * frame.u32(length));
    });
  }
  separates(shape) {
    return inFrame(undefined, (frame) => {
      const overIntegers = frame.block(1), modulo2 = frame.block(1);
      frame.check(
          'plumb_surface_separates', self(this), count(shape, 'shape'), overIntegers, modulo2);
      return {overIntegers: frame.flag(overIntegers), modulo2: frame.flag(modulo2)};
    });
  }
  toMesh(options) {
    return inFrame(options, (frame) => {
      const out = frame.block(4), cells = frame.block(4);
      frame.check('plumb_surface_triangulate', self(this), out, cells, frame.context());
      const {vertices, triangles} = takeMesh(frame.u32(out));
      return {vertices, triangles, cells: takeIndices(frame.u32(cells))};
    });
  }
  select(expression, {rule, ...options} = {}) {
    return inFrame(
        options,
        (frame) => wrap(
            SurfaceRegion,
            frame.make(
                'plumb_surface_evaluate', self(this), frame.text(expression, 'expression'),
                ruleOf(rule))));
  }
  audit() {
    return inFrame(undefined, (frame) => {
      const flaw = frame.makeBriefly('plumb_surface_audit', self(this));
      return flaw === 0 ? null : decode(takeBytes(flaw));
    });
  }
  write(format, {region, ...options} = {}) {
    return inFrame(
        options,
        (frame) => takeBytes(frame.make(
            'plumb_surface_write', self(this), regionOf(region), frame.text(format, 'format'))));
  }
  draw(format, {region, layer = 'cells', title, ...options} = {}) {
    return inFrame(
        options,
        (frame) => takeBytes(frame.make(
            'plumb_surface_draw', self(this), regionOf(region), frame.text(layer, 'layer'),
            frame.text(format, 'format'), frame.text(title, 'title'))));
  }
  toHtml(options) { return decode(this.draw('html', options)); }
}

/** Cells of a divided surface that an expression selects. */
export class SurfaceRegion extends Handle {
  static free = 'plumb_region_free';

  get cellCount() { return engine()._plumb_region_cell_count(self(this)) >>> 0; }
  get loopCount() { return engine()._plumb_region_loop_count(self(this)) >>> 0; }
  get area() { return engine()._plumb_region_area(self(this)); }
  has(cell) { return engine()._plumb_region_has(self(this), count(cell, 'cell')) !== 0; }
  toScene() {
    return inFrame(
        undefined, (frame) => wrap(Scene, frame.makeBriefly('plumb_region_to_scene', self(this))));
  }
}

const regionOf = (region) =>
    (region === undefined ? 0 : addressOf(region, SurfaceRegion, 'region'));

function cellOf(division, cell) {
  const cells = division.counts().cells;
  if (count(cell, 'cell') < cells) return cell;
  throw badArgument(`there is no cell ${shown(cell)}; there are ${cells}`);
}
