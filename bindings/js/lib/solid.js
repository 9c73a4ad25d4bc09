// Sets of space.
import {attributesOf, planeSourceOf, setAttributes, sourcesOf} from './attributes.js';
import {takeNumbers, vector, vectors, withNumbers} from './fraction.js';
import {addressesOf, addressOf, wrap} from './handle.js';
import {
  badArgument,
  constant,
  copyOf,
  count,
  decode,
  engine,
  inFrame,
  isWanted,
  real,
  shown,
  Struct,
  takeBytes,
  takeIndices,
  taken,
  textAt,
} from './memory.js';
import {PlaneSet} from './plane_set.js';
import {
  containsPoints,
  derived,
  describe,
  distanceBetween,
  filesBy,
  isRaw,
  measure,
  operations,
  PointSet,
  readOptions,
  ruleOf,
  self,
  takeSets,
  transformed,
  translated,
  withFiles,
  writeOptions,
  written,
} from './sets.js';

const solidLayout = new Struct({
  rule: 'i32',
  surface: 'bool',
  may_be_empty: 'bool',
  repair: 'pointer',
  keep: 'i32',
  source_name: 'pointer'
});
const repairLayout = new Struct(
    {weld: 'f64', doubled: 'i32', reorient: 'bool', fill_holes: 'u32', fill_holes_below: 'f64'});
const toMeshLayout = new Struct(
    {polygons: 'bool', split_vertices: 'bool', floats: 'bool', exact: 'bool', nearest: 'u32'});
const reportLayout = new Struct({
  rounded_vertices: 'u64',
  rounds: 'u32',
  coarse_rounds: 'u32',
  damaged_faces: 'u64',
  largest_move: 'f64',
  changes_topology: 'bool',
  dropped: 'u64',
  filled: 'u64',
  closed: 'u64',
  non_manifold_edges: 'u64',
  non_manifold_vertices: 'u64',
});
const repairReportLayout = new Struct({
  equal: 'u64',
  welded: 'u64',
  farthest: 'f64',
  unused: 'u64',
  trimmed: 'u64',
  degenerate: 'u64',
  doubled: 'u64',
  flipped: 'u64',
  turned: 'u64',
  filled: 'u64',
  added: 'u64',
  holes: 'u64',
  is_closed: 'bool',
});
const attributeLayout = new Struct({pieces: 'i32', polygons: 'bool', floats: 'bool'});
const keptAttributes = ['none', 'colours', 'ids', 'all'];
const doubledFaces = ['keep', 'if better', 'drop'];
const meshLists = [
  'degenerate', 'trimmed', 'notPlanar', 'notSimple', 'doubled', 'crossings', 'flipped', 'oneSided',
  'insideOut'
];

/** snake_case names as camelCase names. */
const camel = (facts) => Object.fromEntries(Object.entries(facts).map(
    ([name, value]) => [name.replace(/_(.)/g, (_, letter) => letter.toUpperCase()), value]));

function repairOptions(frame, repair) {
  if (repair === undefined || repair === null) return 0;
  const {weld = 0, doubled = 'keep', reorient = false, fillHoles = 0, fillHolesBelow = 0} = repair;
  return frame.struct(repairLayout, {
    weld: real(weld, 'weld'),
    doubled: constant(doubledFaces, doubled, 'doubled'),
    reorient,
    fill_holes: count(fillHoles, 'fillHoles'),
    fill_holes_below: real(fillHolesBelow, 'fillHolesBelow'),
  });
}

/** What stands in repair options. */
function repairOf(address) {
  if (address === 0) return {};
  const {doubled, ...rest} = camel(repairLayout.read(address));
  return {...rest, doubled: doubledFaces[doubled]};
}

/** Attributes that are given are kept, even if there is nothing in them. */
function solidOptions(frame, {
  rule,
  surface = false,
  mayBeEmpty = false,
  repair,
  attributes,
  keep = isWanted(attributes) ? 'all' : undefined,
  sourceName
} = {}) {
  return frame.struct(solidLayout, {
    rule: ruleOf(rule),
    surface,
    may_be_empty: mayBeEmpty,
    repair: repairOptions(frame, repair),
    keep: keep === undefined ? 0 : constant(keptAttributes, keep, 'keep') + 1,
    source_name: frame.text(sourceName, 'sourceName'),
  });
}

// ---- meshes

/** The arrays of a mesh of the engine. */
function arraysOf(mesh, isTriangles) {
  const points = engine()._plumb_mesh_point_count(mesh) >>> 0,
        faces = engine()._plumb_mesh_face_count(mesh) >>> 0;
  const corners = engine()._plumb_mesh_corner_count(mesh) >>> 0;
  const vertices = copyOf(Float64Array, engine()._plumb_mesh_points(mesh), 3 * points);
  const cornerArray = copyOf(Uint32Array, engine()._plumb_mesh_corners(mesh), corners);
  const facetArray = engine()._plumb_mesh_facets(mesh);
  const facets = facetArray === 0 ? new Uint32Array(0) : copyOf(Uint32Array, facetArray, faces);
  if (isTriangles) return {vertices, triangles: cornerArray, facets};
  return {
    vertices,
    faceBegin: copyOf(Uint32Array, engine()._plumb_mesh_face_begin(mesh), faces + 1),
    corners: cornerArray,
    facets
  };
}

/** Runs a body with a mesh of the engine, and releases the mesh. */
export function withMesh(frame, mesh, body) {
  if (typeof mesh !== 'object' || mesh === null)
    throw badArgument(`a mesh must be an object of arrays, not ${shown(mesh)}`);
  const {address, count: points} = frame.doubles(mesh.vertices, 3, 'vertices');
  let made;
  if (mesh.triangles !== undefined) {
    const triangles = frame.records(Uint32Array, mesh.triangles, 3, 'triangles');
    made = frame.makeBriefly(
        'plumb_mesh_from_triangles', address, points, triangles.address, triangles.count);
  } else {
    const begin = frame.numbers(Uint32Array, mesh.faceBegin, 'faceBegin'),
          corners = frame.numbers(Uint32Array, mesh.corners, 'corners');
    made = frame.makeBriefly(
        'plumb_mesh_from_polygons', address, points, begin.address, Math.max(begin.count, 1) - 1,
        corners.address, corners.count);
  }
  return taken(made, 'plumb_mesh_free', body);
}

/** Does the same with a mesh that has its attributes. */
const withAttributes = (frame, mesh, body) => withMesh(frame, mesh, (made) => {
  setAttributes(frame, made, mesh.attributes);
  return body(made);
});

/**
 * The arrays of a mesh of the engine, which is released; polygons only if the mesh has any.
 * `others` gives further members.
 */
export function takeMesh(mesh, others = () => ({})) {
  const isTriangles = (engine()._plumb_mesh_corner_count(mesh) >>> 0) ===
      3 * (engine()._plumb_mesh_face_count(mesh) >>> 0);
  return taken(mesh, 'plumb_mesh_free', () => ({...arraysOf(mesh, isTriangles), ...others(mesh)}));
}

/** Reads a mesh as it stands in a file. */
export function readMesh(data, options = {}) {
  return inFrame(options, (frame) => {
    const reading = readOptions(frame, options);
    const read = () => {
      if (options.files !== undefined) {
        return withFiles(
            {...options.files, [options.name]: data},
            () => frame.makeWithNotes(
                'plumb_mesh_read_file', frame.text(options.name, 'name'), reading));
      }
      const bytes = frame.bytes(data, 'the file');
      return frame.makeWithNotes('plumb_mesh_read', bytes.address, bytes.count, reading);
    };
    const {address, notes} = read();
    frame.tell(notes);
    return takeMesh(
        address,
        options.attributes === true ? (mesh) => ({attributes: attributesOf(mesh)}) : undefined);
  });
}

/** Writes a mesh as it is. */
export function writeMesh(mesh, format) {
  return inFrame(
      undefined,
      (frame) => withAttributes(
          frame, mesh,
          (made) => takeBytes(
              frame.makeBriefly('plumb_mesh_write', made, frame.text(format, 'format')))));
}

/** Writes a mesh as files: an OBJ file has its colours in a second one. */
export function writeMeshFiles(mesh, name, {format} = {}) {
  return inFrame(
      undefined,
      (frame) => withAttributes(
          frame, mesh,
          (made) => filesBy(
              frame, name,
              (path) =>
                  frame.check('plumb_mesh_write_file', made, path, frame.text(format, 'format')))));
}

/** A sentence that names the attributes of a mesh that a format does not hold; '' for none. */
export function lostAttributes(mesh, format) {
  return inFrame(
      undefined,
      (frame) => withAttributes(
          frame, mesh,
          (made) => decode(takeBytes(frame.makeBriefly(
              'plumb_mesh_lost_attributes', made, frame.text(format, 'format'))))));
}

/** What is wrong with a mesh: open borders, faces that cross, degenerate faces and the like. */
export function checkMesh(mesh, options = {}) {
  return inFrame(
      options,
      (frame) => withMesh(frame, mesh, (made) => {
        const report = frame.make(
            'plumb_mesh_check', made, BigInt(count(options.maxListed ?? 1000, 'maxListed')));
        const length = frame.block(4);
        const list = (which) => {
          const address = engine()._plumb_mesh_report_list(report, which, length);
          return copyOf(Uint32Array, address, frame.u32(length));
        };
        const chains = (which) => {
          const vertices = list(which),
                begin = engine()._plumb_mesh_report_chains(report, which, length);
          const offsets =
              copyOf(Uint32Array, begin, frame.u32(length) === 0 ? 0 : frame.u32(length) + 1);
          return Array.from(
              {length: Math.max(offsets.length, 1) - 1},
              (_, i) => vertices.slice(offsets[i], offsets[i + 1]));
        };
        return taken(
            report, 'plumb_mesh_report_free',
            () => ({
              isClosed: engine()._plumb_mesh_report_is_closed(report) !== 0,
              crossingCount: Number(engine()._plumb_mesh_report_crossing_count(report)),
              ...Object.fromEntries(meshLists.map((name, which) => [name, list(which)])),
              borders: chains(9),
              holes: chains(10),
            }));
      }));
}

/**
 * Mends a mesh; 'automatic' finds out how, and gives null if nothing helps. The mended mesh has
 * attributes if the mesh has some.
 */
export function repairMesh(mesh, repair = 'automatic', options = {}) {
  return inFrame(
      options, (frame) => withAttributes(frame, mesh, (made) => {
                 let how;
                 if (repair === 'automatic') {
                   how = frame.struct(repairLayout);
                   const found = frame.block(1);
                   frame.check('plumb_mesh_find_repair', made, how, found, frame.context());
                   if (!frame.flag(found)) return null;
                 } else {
                   how = repairOptions(frame, repair);
                 }
                 const out = frame.block(4), report = frame.struct(repairReportLayout),
                       notes = frame.block(4);
                 frame.check('plumb_mesh_repair', made, how, out, report, notes, frame.context());
                 const others = isWanted(mesh.attributes) ?
                     (mended) => ({attributes: attributesOf(mended)}) :
                     undefined;
                 return {
                   mesh: takeMesh(frame.u32(out), others),
                   report: camel(repairReportLayout.read(report)),
                   notes: frame.notes(notes),
                   repair: repairOf(how)
                 };
               }));
}

/** The Delaunay triangulation of points of the plane: triangles of indices. */
export function delaunay(points, options) {
  return inFrame(options, (frame) => {
    const {address, count: length} = frame.doubles(points, 2, 'points');
    return takeMesh(frame.make('plumb_mesh_delaunay', address, length)).triangles;
  });
}

// ---- solids

/**
 * A set of points of space that half-spaces can make: bounded or not, open or closed, with
 * dangling parts or not.
 */
export class Solid extends PointSet {
  static prefix = 'plumb_solid';
  static free = 'plumb_solid_free';
  static width = 3;
  static cells = ['vertex', 'edge', 'facet', 'volume'];
  static info = new Struct({
    vertices: 'u32',
    edges: 'u32',
    facets: 'u32',
    volumes: 'u32',
    marked_volumes: 'u32',
    bytes: 'u32',
    is_empty: 'bool',
    is_whole: 'bool',
    is_bounded: 'bool',
    is_closed: 'bool',
    is_open: 'bool',
    is_simple: 'bool',
    is_convex: 'bool',
  });

  static fromMesh(vertices, triangles, options) {
    if (isWanted(options?.attributes)) return ofMesh({vertices, triangles}, options);
    return inFrame(options, (frame) => {
      const points = frame.doubles(vertices, 3, 'vertices'),
            faces = frame.records(Uint32Array, triangles, 3, 'triangles');
      return wrap(
          Solid,
          frame.make(
              'plumb_solid_from_triangles', points.address, points.count, faces.address,
              faces.count, solidOptions(frame, options)));
    });
  }
  static fromPolygons(vertices, faceBegin, corners, options) {
    return ofMesh({vertices, faceBegin, corners}, options);
  }
  static halfSpace(plane, {closed = true, source} = {}) {
    const made = (frame, numbers) => isWanted(source) ?
        frame.makeBriefly(
            'plumb_solid_half_space_with_source', numbers, closed, planeSourceOf(frame, source)) :
        frame.makeBriefly('plumb_solid_half_space', numbers, closed);
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vector(plane, 4, 'the plane'), 'the plane',
            (numbers) => wrap(Solid, made(frame, numbers))));
  }
  static plane(plane) {
    return inFrame(
        undefined,
        (frame) => withNumbers(
            frame, vector(plane, 4, 'the plane'), 'the plane',
            (numbers) => wrap(Solid, frame.makeBriefly('plumb_solid_plane', numbers))));
  }
  static halfSpaces(planes, options = {}) {
    return inFrame(options, (frame) => {
      const {address, count: length} = frame.doubles(planes, 4, 'planes');
      const closed = frame.block(length);
      engine().HEAPU8.fill(options.closed === false ? 0 : 1, closed, closed + length);
      return wrap(Solid, frame.make('plumb_solid_from_half_spaces', address, closed, length));
    });
  }
  static polyline(points, options) { return ofPoints('polyline', points, options); }
  static facet(corners, options) { return ofPoints('facet', corners, options); }

  static box(low, high, options) {
    const from = vector(low, 3, 'the lower corner'), to = vector(high, 3, 'the upper corner');
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
        (i) => [0, 1, 2].map((axis) => ((i >> axis) & 1 ? to : from)[axis]));
    const box = Solid.hull(corners, options);
    if (options?.closed !== false) return box;
    try {
      return box.interior(options);
    } finally {
      box.dispose();
    }
  }
  static ball(radius, rounds = 3) {
    return inFrame(
        undefined,
        (frame) => wrap(
            Solid,
            frame.makeBriefly(
                'plumb_solid_ball', real(radius, 'radius'), count(rounds, 'rounds'))));
  }
  static sphere(radius, chords = 30, options) {
    return inFrame(
        options,
        (frame) => wrap(
            Solid,
            frame.make('plumb_solid_sphere', real(radius, 'radius'), count(chords, 'chords'))));
  }
  static cylinder(
      height, bottomRadius,
      {topRadius = bottomRadius, chords = 30, centred = false, ...options} = {}) {
    return inFrame(
        options,
        (frame) => wrap(
            Solid,
            frame.make(
                'plumb_solid_cylinder', real(height, 'height'), real(bottomRadius, 'bottomRadius'),
                real(topRadius, 'topRadius'), count(chords, 'chords'), centred)));
  }
  static torus(radius, tubeRadius, {chords = 30, tubeChords = 16, ...options} = {}) {
    return inFrame(
        options,
        (frame) => wrap(
            Solid,
            frame.make(
                'plumb_solid_torus', real(radius, 'radius'), real(tubeRadius, 'tubeRadius'),
                count(chords, 'chords'), count(tubeChords, 'tubeChords'))));
  }
  static hull(points, options) {
    if (points instanceof Float64Array) {
      return inFrame(options, (frame) => {
        const {address, count: length} = frame.doubles(points, 3, 'points');
        return wrap(Solid, frame.make('plumb_solid_hull', address, length));
      });
    }
    return ofPoints('hull_exact', points, options);
  }
  static hullOf(solids, options) {
    return inFrame(options, (frame) => {
      const {address, count: length} = addressesOf(frame, solids, Solid, 'solids');
      return wrap(Solid, frame.make('plumb_solid_hull_of', address, length));
    });
  }

  static evaluate(expression, solids, options) {
    if (typeof solids !== 'object' || solids === null)
      throw badArgument(`solids must be an object {name: Solid}, not ${shown(solids)}`);
    return inFrame(options, (frame) => {
      const names = frame.addresses(Object.keys(solids).map((name) => frame.text(name, 'name')));
      const {address, count: length} = addressesOf(frame, Object.values(solids), Solid, 'solids');
      return wrap(
          Solid,
          frame.make(
              'plumb_solid_evaluate', frame.text(expression, 'expression'), names.address, address,
              length));
    });
  }

  static read(data, options = {}) {
    return inFrame(options, (frame) => {
      const reading = readOptions(frame, options), making = solidOptions(frame, options);
      const read = () => {
        if (options.files !== undefined) {
          return withFiles(
              {...options.files, [options.name]: data},
              () => frame.makeWithNotes(
                  'plumb_solid_read_file', frame.text(options.name, 'name'), reading, making));
        }
        const bytes = frame.bytes(data, 'the file');
        return frame.makeWithNotes('plumb_solid_read', bytes.address, bytes.count, reading, making);
      };
      const {address, notes} = read();
      frame.tell(notes);
      return wrap(Solid, address);
    });
  }
  static fromBytes(data) { return Solid.read(data, {name: 'data.nef'}); }
  static readHalfSpaces(data, options = {}) {
    const name = options.name ?? 'halfspaces.txt';
    return inFrame(
        options,
        (frame) => withFiles(
            {[name]: data},
            () => wrap(
                Solid,
                frame.make(
                    'plumb_solid_read_half_spaces_file', frame.text(name, 'name'),
                    readOptions(frame, options)))));
  }

  write(format, options = {}) {
    return inFrame(
        options,
        (frame) => written(
            frame, 'plumb_solid_write', self(this), frame.text(format, 'format'),
            writeOptions(frame, isRaw(options.rounding))));
  }
  /** Writes a set as files: an OBJ file has the colours of the sources in a second one. */
  writeFiles(name, options = {}) {
    return inFrame(options, (frame) => filesBy(frame, name, (path) => {
                              const notes = frame.block(4);
                              frame.check(
                                  'plumb_solid_write_file', self(this), path,
                                  frame.text(options.format, 'format'),
                                  writeOptions(frame, isRaw(options.rounding)), notes,
                                  frame.context());
                              frame.tell(frame.notes(notes));
                            }));
  }
  toBytes(options) {
    const canonical = this.canonical(options);
    try {
      return canonical.write('nef', options);
    } finally {
      canonical.dispose();
    }
  }
  draw(format, options = {}) {
    return inFrame(
        options,
        (frame) => takeBytes(frame.make(
            'plumb_solid_draw', self(this), frame.text(format, 'format'),
            frame.text(options.title, 'title'))));
  }
  toHtml(options) { return new TextDecoder().decode(this.draw('html', options)); }
  static drawMany(solids, format, options = {}) {
    return inFrame(options, (frame) => {
      const {address, count: length} = addressesOf(frame, solids, Solid, 'solids');
      return takeBytes(frame.make(
          'plumb_solid_draw_many', address, length, real(options.apart ?? 1, 'apart'),
          frame.text(format, 'format'), frame.text(options.title, 'title')));
    });
  }

  toMesh(options = {}) { return meshOf(this, options, true); }
  toPolygons(options = {}) { return meshOf(this, options, false); }
  toMeshWithAttributes(options = {}) { return tracedMeshOf(this, options, true); }
  toPolygonsWithAttributes(options = {}) { return tracedMeshOf(this, options, false); }

  sources() {
    const length = engine()._plumb_solid_source_count(self(this)) >>> 0;
    return Array.from({length}, (_, i) => textAt(engine()._plumb_solid_source_name(self(this), i)));
  }
  withSource(mesh, name = '') {
    return inFrame(
        undefined,
        (frame) => withAttributes(
            frame, mesh,
            (made) => wrap(
                Solid,
                frame.makeBriefly(
                    'plumb_solid_with_source', self(this), made, frame.text(name, 'name')))));
  }

  canonical(options) { return derived(this, 'canonical', options); }
  section(plane, {kind = 'closed below', operation = 'intersection', ...options} = {}) {
    const kinds = ['closed below', 'open below', 'plane'];
    const names = Object.keys(operations);
    const which = operations[names[constant(names, operation, 'operation')]];
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, vector(plane, 4, 'the plane'), 'the plane',
            (numbers) => wrap(
                Solid,
                frame.make(
                    'plumb_solid_section', self(this), numbers, constant(kinds, kind, 'kind'),
                    which))));
  }
  transformed(rows, options) { return transformed(this, rows, options); }
  translated(by, options) { return translated(this, by, options); }
  rotated(axis, degrees, options) {
    return mapped(this, options, (frame) => {
      const {address} = frame.doubles(vector(axis, 3, 'the axis'), 3, 'the axis');
      return frame.makeBriefly('plumb_numbers_rotation', address, real(degrees, 'degrees'));
    });
  }
  mirrored(normal, options) {
    return mapped(
        this, options,
        (frame) => withNumbers(
            frame, vector(normal, 3, 'the normal'), 'the normal',
            (numbers) => frame.makeBriefly('plumb_numbers_reflection', numbers)));
  }
  scaled(factors, options) {
    const three = Array.isArray(factors) ? factors : [factors, factors, factors];
    return mapped(
        this, options,
        (frame) => withNumbers(
            frame, vector(three, 3, 'the factors'), 'the factors',
            (numbers) => frame.makeBriefly('plumb_numbers_scaling', numbers)));
  }
  resized(size, {automatic = [false, false, false], ...options} = {}) {
    return mapped(
        this, options,
        (frame) => withNumbers(frame, vector(size, 3, 'the size'), 'the size', (numbers) => {
          const flags = frame.block(3);
          vector(automatic, 3, 'automatic')
              .forEach((flag, i) => (engine().HEAPU8[flags + i] = flag ? 1 : 0));
          return frame.makeBriefly('plumb_numbers_resizing', self(this), numbers, flags);
        }));
  }

  /**
   * The closure grown by a distance, or shrunk by a negative one. An octahedron whose faces are
   * divided `rounds` times, at most 7, stands for the ball.
   */
  offset(distance, {rounds = 3, ...options} = {}) {
    return inFrame(
        options,
        (frame) => wrap(
            Solid,
            frame.make(
                'plumb_solid_offset', self(this), real(distance, 'distance'),
                count(rounds, 'rounds'))));
  }
  minkowskiSum(other, options) { return withOther(this, 'minkowski_sum', other, options); }
  minkowskiErosion(other, options) { return withOther(this, 'minkowski_erosion', other, options); }
  decompose({method = 'best', closed = false, ...options} = {}) {
    return inFrame(
        options,
        (frame) => takeSets(
            Solid,
            frame.make(
                'plumb_solid_decompose', self(this),
                constant(['best', 'cuts', 'walls'], method, 'method'), closed)));
  }
  components(options) {
    return inFrame(
        options, (frame) => takeSets(Solid, frame.make('plumb_solid_components', self(this))));
  }
  convexHull(options) { return Solid.hullOf([this], options); }
  slice(height, options) { return this.slices([height], options)[0]; }
  slices(heights, options) {
    return inFrame(
        options,
        (frame) => withNumbers(
            frame, heights, 'heights',
            (numbers) =>
                takeSets(PlaneSet, frame.make('plumb_solid_slices', self(this), numbers))));
  }
  shadow(options) {
    return inFrame(
        options, (frame) => wrap(PlaneSet, frame.make('plumb_solid_shadow', self(this))));
  }

  containsPoints(points, options) { return containsPoints(this, points, options); }
  counts() {
    const {vertices, edges, facets, volumes, marked_volumes: markedVolumes} = describe(this);
    return {vertices, edges, facets, volumes, markedVolumes};
  }
  isBounded() { return describe(this).is_bounded; }
  isSimple() { return describe(this).is_simple; }
  isConvex() { return describe(this).is_convex; }
  convexity(options) {
    return inFrame(options, (frame) => {
      const convex = frame.block(1), edges = frame.block(8), failing = frame.block(4);
      frame.check('plumb_solid_convexity', self(this), convex, edges, failing, frame.context());
      return {
        isConvex: frame.flag(convex),
        reflexEdges: frame.u64(edges),
        failing: takeIndices(frame.u32(failing))
      };
    });
  }
  /** Nearest points of the closures of this set and another one. */
  distance(other, options) { return distanceBetween(this, other, options); }
  volume(options) { return measure(this, 'volume', options); }
  centroid(options) {
    return inFrame(options, (frame) => {
      const numbers = takeNumbers(frame.make('plumb_solid_centroid', self(this)));
      return numbers.length === 0 ? null : numbers;
    });
  }
  surfaceArea(options) {
    return inFrame(options, (frame) => {
      const out = frame.block(8);
      frame.check('plumb_solid_surface_area', self(this), out, frame.context());
      return frame.f64(out);
    });
  }
  genus() {
    return inFrame(undefined, (frame) => {
      const isSurface = frame.block(1), genus = frame.block(8);
      frame.check('plumb_solid_genus', self(this), isSurface, genus);
      return frame.flag(isSurface) ? frame.u64(genus) : null;
    });
  }
  boundingBox() {
    return inFrame(undefined, (frame) => {
      const numbers = takeNumbers(frame.makeBriefly('plumb_solid_bounding_box', self(this)));
      return numbers.length === 0 ? null : {low: numbers.slice(0, 3), high: numbers.slice(3)};
    });
  }
}

function ofMesh(mesh, options) {
  return inFrame(
      options,
      (frame) => withAttributes(
          frame, {...mesh, attributes: options?.attributes},
          (made) => wrap(
              Solid, frame.make('plumb_solid_from_mesh', made, solidOptions(frame, options)))));
}

function ofPoints(name, points, options) {
  return inFrame(
      options,
      (frame) => withNumbers(
          frame, vectors(points, 3, 'points'), 'points',
          (list) => wrap(Solid, frame.make(`plumb_solid_${name}`, list))));
}

function withOther(solid, name, other, options) {
  return inFrame(
      options,
      (frame) => wrap(
          Solid, frame.make(`plumb_solid_${name}`, self(solid), addressOf(other, Solid, 'other'))));
}

/** The image under the map whose numbers `make` gives. */
function mapped(solid, options, make) {
  return inFrame(options, (frame) => {
    const map = make(frame);
    try {
      return wrap(Solid, frame.make('plumb_solid_transform', self(solid), map));
    } finally {
      engine()._plumb_numbers_free(map);
    }
  });
}

function meshOf(solid, options, isTriangles) {
  const {rounding, floats = false, splitVertices = false} = options;
  return inFrame(options, (frame) => {
    const settings = frame.struct(toMeshLayout, {
      polygons: !isTriangles,
      split_vertices: splitVertices,
      floats,
      nearest: isRaw(rounding) ? 1 : 0,
    });
    const out = frame.block(4), report = frame.struct(reportLayout);
    frame.check('plumb_solid_to_mesh', self(solid), settings, out, report, frame.context());
    const arrays = taken(frame.u32(out), 'plumb_mesh_free', (mesh) => arraysOf(mesh, isTriangles));
    return {...arrays, report: camel(reportLayout.read(report))};
  });
}

function tracedMeshOf(
    solid, {pieces = 'same attributes', floats = false, ...options}, isTriangles) {
  return inFrame(options, (frame) => {
    const settings = frame.struct(attributeLayout, {
      pieces: constant(['same attributes', 'apart', 'same face'], pieces, 'pieces'),
      polygons: !isTriangles,
      floats,
    });
    const out = frame.block(4), report = frame.struct(reportLayout);
    frame.check(
        'plumb_solid_to_mesh_with_attributes', self(solid), settings, out, report, frame.context());
    return taken(frame.u32(out), 'plumb_mesh_free', (mesh) => {
      const {facets, ...arrays} = arraysOf(mesh, isTriangles);
      return {
        ...arrays,
        ...sourcesOf(mesh),
        attributes: attributesOf(mesh),
        report: camel(reportLayout.read(report))
      };
    });
  });
}
