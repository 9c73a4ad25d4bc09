// Types of the package. docs/javascript.md explains it with examples.

/**
 * Loads the engine. This must be done once, before all other calls. Later calls of init() wait for
 * the same load.
 */
export function init(options?: {
  /**
   * The address, the bytes or the module of engine.wasm. It is needed if engine.wasm does not lie
   * beside the script.
   */
  wasm?: string|URL|ArrayBuffer|Uint8Array|WebAssembly.Module;
}): Promise<void>;
/** Whether the engine is loaded. */
export function isReady(): boolean;
/** The version of the library, such as '0.1.0'. */
export function version(): string;
/** Whether the arithmetic satisfies the assumptions of exact predicates. Warnings name violated
 * assumptions. */
export function selfTest(): {isOk: boolean; notes: Note[]};

// ---- errors and options

/** The reasons of errors. */
export type ErrorCode =
    |'CANNOT_OPEN'|'CANNOT_WRITE'|'NOT_TEXT'|'SYNTAX'|'NUMBER_OUT_OF_RANGE'|'COUNT_MISMATCH'|
    'BAD_INDEX'|'DEGENERATE_FACE'|'UNKNOWN_FORMAT'|'USAGE'|'CLOSED_PIPE'|'BAD_SHAPE'|
    'RESOURCE_LIMIT'|'CANCELLED'|'NOT_FINITE'|'BAD_ARGUMENT'|'OUT_OF_MEMORY'|'INTERNAL'|'NOT_READY';

/**
 * The error that all functions throw. `message` is 'FILE:LINE:COLUMN: reason', where unknown parts
 * of the position are omitted.
 */
export class PlumbError extends Error {
  constructor(
      code: ErrorCode, reason: string,
      place?: {text?: string; file?: string; line?: number; column?: number});
  readonly code: ErrorCode;
  /** The message without the position. */
  readonly reason: string;
  /** The name of the text in which the error occurred; '' if it did not occur in a text. */
  readonly file: string;
  /** The line, counted from 1; 0 if unknown. */
  readonly line: number;
  /** The column in bytes, counted from 1; 0 if unknown. */
  readonly column: number;
}

/** Options that every operation takes as its last argument. */
export interface Options {
  /** The longest time that the operation may take, in seconds. */
  timeout?: number;
  /**
   * The largest working memory that the operation may use, in bytes. The engine estimates this
   * memory.
   */
  memoryLimit?: number|bigint;
  /**
   * A callback, which is called at most 20 times a second. `total` is 0 if it is unknown. If the
   * callback throws, the operation stops and throws the same error.
   */
  onProgress?: (phase: string, done: number, total: number) => void;
  /** Stops the operation. The operation tests the signal after each report of progress. */
  signal?: AbortSignal;
}

/**
 * A note about contents of a file that the set does not represent, or about properties of a set
 * that the file does not represent.
 */
export interface Note {
  text: string;
  /** Whether geometry was lost. */
  isWarning: boolean;
}

/** Options for reading files. */
export interface ReadOptions extends Options {
  /**
   * The name of the file, which occurs in messages. Its extension determines the format. If there
   * is no name, the first bytes of the file determine the format.
   */
  name?: string;
  /**
   * Whether decimals are read exactly, for example 0.1 as a tenth. Otherwise they are rounded to
   * the nearest doubles.
   */
  exactDecimals?: boolean;
  onNote?: (note: Note) => void;
}

/** The contents of a file, as bytes or as text. */
export type FileData = Uint8Array|ArrayBuffer|ArrayBufferView|string;
/**
 * The contents of other files to which a file refers. The keys are the names of these files. If
 * `files` is given, `name` must be given, too.
 */
export interface SiblingFiles {
  files?: Record<string, FileData>;
}

// ---- numbers

/**
 * An exact number. A JavaScript number stands for its exact value, and the text '0.1' for exactly a
 * tenth.
 */
export type Exact = number|bigint|string|Fraction;
export type Vector2 = readonly[Exact, Exact]|Float64Array;
export type Vector3 = readonly[Exact, Exact, Exact]|Float64Array;
export type Vector4 = readonly[Exact, Exact, Exact, Exact]|Float64Array;
/**
 * Points, each as an array. They may also be given by all their coordinates x, y(, z), x, ... in
 * one Float64Array.
 */
export type Points2 = readonly Vector2[]|Float64Array;
export type Points3 = readonly Vector3[]|Float64Array;
export type Coordinates = Float64Array|readonly number[];
export type Indices = Uint32Array|readonly number[];

/** A rational number in lowest terms. Immutable. */
export class Fraction {
  constructor(numerator: bigint|number|string, denominator?: bigint|number|string);
  static from(value: Exact): Fraction;
  readonly numerator: bigint;
  readonly denominator: bigint;
  /** 'p/q', or 'p'. */
  toString(): string;
  toJSON(): string;
  /**
   * The nearest JavaScript number, or an infinity if the fraction lies beyond the largest number.
   */
  toNumber(): number;
  valueOf(): number;
  equals(other: Exact): boolean;
}

// ---- meshes

/**
 * A mesh of triangles. `vertices` contains the coordinates x, y, z, x, ... of all vertices.
 * `triangles` contains three indices of vertices for each triangle, counter-clockwise seen from
 * outside.
 */
export interface TriangleMesh {
  vertices: Float64Array;
  triangles: Uint32Array;
  attributes?: MeshAttributes;
}
/**
 * A mesh of polygons. Face f has the corners from corners[faceBegin[f]] to corners[faceBegin[f +
 * 1] - 1].
 */
export interface PolygonMesh {
  vertices: Float64Array;
  faceBegin: Uint32Array;
  corners: Uint32Array;
  attributes?: MeshAttributes;
}
export type Mesh = TriangleMesh|PolygonMesh;

/** A material that faces refer to. */
export interface Material {
  name?: string;
  /** Red, green, blue and opacity, each from 0 to 1. */
  color?: readonly[number, number, number, number]|null;
  /** The name of a texture file; '' for none. */
  texture?: string;
}
/** Numbers at corners or at vertices. There are `width` numbers for each corner of each face, in
 * the order of the corners, or for each vertex. */
export interface Channel {
  width: number;
  values: Coordinates;
}
/**
 * The attributes of the faces and corners of a mesh. All members can be left out. An array for
 * faces has an entry for each face; 0xffffffff means that the face has no material, group or id.
 */
export interface MeshAttributes {
  materials?: readonly Material[];
  /** The index of the material of each face. */
  faceMaterial?: Indices|null;
  groups?: readonly string[];
  /** The index of the group of each face. */
  faceGroup?: Indices|null;
  /** A number that the caller chose for each face. */
  faceId?: Indices|null;
  /**
   * Numbers of corners. Files use the names 'color' (3 or 4 numbers from 0 to 1), 'normal' (3),
   * 'texcoord_0', 'texcoord_1' and so on (2).
   */
  channels?: Readonly<Record<string, Channel>>;
  /** Numbers of vertices, which all corners at a vertex get. */
  vertexChannels?: Readonly<Record<string, Channel>>;
}
/**
 * The attributes of the boundary of a half-space. The half-space is a source with one face. Faces
 * of results that the half-space cuts have the attributes of this face.
 */
export interface PlaneSource {
  /** The name in Solid.sources(). */
  name?: string;
  material?: Material;
  group?: string;
  /** A number that the caller chose. */
  id?: number;
}
/** The attributes of a mesh that the package made. A member is null if no face has a value. */
export interface FoundAttributes {
  materials: {name: string; color: [number, number, number, number] | null; texture: string}[];
  faceMaterial: Uint32Array|null;
  groups: string[];
  faceGroup: Uint32Array|null;
  faceId: Uint32Array|null;
  /** Numbers of corners. */
  channels: Record < string, {
    width: number;
    values: Float64Array
  }
  > ;
}
/**
 * The sources of the faces of a mesh. Each face is a part of a face of a source. Faces are in
 * ascending order of `source`. Faces without a source come last, and their entries are 0xffffffff.
 */
export interface FaceSources {
  /** For each face, the index of its source in Solid.sources(). */
  source: Uint32Array;
  /** For each face, the face of the source that contains it. */
  sourceFace: Uint32Array;
  /** For each face, 1 if it and the face of the source have opposite orientations, else 0. */
  isFlipped: Uint8Array;
  /**
   * The attributes. The list of materials contains the materials of the first source, then the
   * materials of the second source, and so on. The list of groups is made in the same way.
   */
  attributes: FoundAttributes;
  report: ToMeshReport;
}
/**
 * A report on the rounding of a mesh, and on the cells of the solid that the mesh does not
 * represent.
 */
export interface ToMeshReport {
  roundedVertices: number;
  /** The number of rounds of repair; 0 if the mesh was valid without repair. */
  rounds: number;
  coarseRounds: number;
  damagedFaces: number;
  /** A bound for the distance from the exact boundary. */
  largestMove: number;
  /** Whether thin parts or gaps vanished. */
  changesTopology: boolean;
  dropped: number;
  filled: number;
  closed: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
}
/** Options for the repair of a mesh. By default, nothing is repaired. */
export interface Repair {
  /** Points whose distance is at most this value are merged. */
  weld?: number;
  /** Whether faces with the same corners as an earlier face are kept or dropped. */
  doubled?: 'keep'|'if better'|'drop';
  /** Whether faces that are not oriented like their neighbours are flipped. */
  reorient?: boolean;
  /** Holes with at most this number of edges are filled. */
  fillHoles?: number;
  /**
   * A hole with more edges is also filled if the diagonal of the box around its vertices is at most
   * this length.
   */
  fillHolesBelow?: number;
}
export interface RepairReport {
  equal: number;
  welded: number;
  farthest: number;
  unused: number;
  trimmed: number;
  degenerate: number;
  doubled: number;
  flipped: number;
  turned: number;
  filled: number;
  added: number;
  holes: number;
  isClosed: boolean;
}
/**
 * The result of checkMesh(). Most lists contain indices of faces. `doubled` and `crossings` contain
 * pairs of faces. `borders` and `holes` contain chains of vertices.
 */
export interface MeshReport {
  isClosed: boolean;
  /** The number of all pairs of crossing faces, including pairs that are not listed. */
  crossingCount: number;
  degenerate: Uint32Array;
  trimmed: Uint32Array;
  notPlanar: Uint32Array;
  notSimple: Uint32Array;
  doubled: Uint32Array;
  crossings: Uint32Array;
  flipped: Uint32Array;
  oneSided: Uint32Array;
  insideOut: Uint32Array;
  borders: Uint32Array[];
  holes: Uint32Array[];
}
/**
 * Reads a mesh from OFF, OBJ, STL, PLY, glTF or 3MF, without changes. The result is a PolygonMesh
 * only if the file has faces that are not triangles. With `attributes: true`, the mesh has the
 * attributes of the file.
 */
export function readMesh(data: FileData, options: ReadOptions&SiblingFiles&{attributes: true}):
    Mesh&{attributes: FoundAttributes};
export function readMesh(
    data: FileData, options?: ReadOptions&SiblingFiles&{attributes?: boolean}): Mesh;
/**
 * Writes 'off', 'obj', 'stl', 'stl-binary', 'ply', 'ply-text', 'glb' or '3mf', with the attributes
 * of the mesh that the format can represent.
 */
export function writeMesh(mesh: Mesh, format: MeshFormat): Uint8Array;
/**
 * Writes a mesh as files. The extension of `name` or `format` selects the format. If faces have
 * materials, an OBJ file has a second file (.mtl) beside it, with the colours.
 */
export function writeMeshFiles(
    mesh: Mesh, name: string, options?: {format?: MeshFormat}): Record<string, Uint8Array>;
/**
 * Returns a sentence that names the attributes of a mesh that a format cannot represent, or '' if
 * there are none.
 */
export function lostAttributes(mesh: Mesh, format: MeshFormat): string;
/** Finds the defects of a mesh. At most maxListed crossings are listed, by default 1000. */
export function checkMesh(mesh: Mesh, options?: Options&{maxListed?: number}): MeshReport;
/**
 * Repairs a mesh. With 'automatic', the function searches for repairs after which the mesh bounds a
 * solid, and chooses the repair that changes least. It returns null if there is no such repair. If
 * the mesh has attributes, so has the repaired mesh: faces keep their material, group, id and the
 * numbers at their corners, and faces that were added in holes have none. Channels of vertices
 * become channels of corners.
 */
export function repairMesh(mesh: Mesh, repair?: Repair|'automatic', options?: Options):
    {mesh: Mesh; report: RepairReport; notes: Note[]; repair: Repair}|null;
/**
 * Returns the Delaunay triangulation of points, with three indices of points for each triangle.
 * `points` contains the coordinates x, y, x, ...
 */
export function delaunay(points: Coordinates, options?: Options): Uint32Array;

export type MeshFormat = 'off'|'off-exact'|'obj'|'stl'|'stl-binary'|'ply'|'ply-text'|'glb'|'3mf';
export type PictureFormat = 'html'|'svg'|'glb'|'png';
/** The winding numbers that count as inside. */
export type Rule = 'positive'|'nonzero'|'evenodd';

// ---- objects

/**
 * An object whose memory lies outside the memory of JavaScript. The memory is released by `using`,
 * by dispose() or by the garbage collector.
 */
export abstract class Handle {
  /** Whether dispose() was called. */
  readonly isDisposed: boolean;
  /**
   * Releases the memory at once. Any later use of the object throws an error, except that a second
   * call of dispose() does nothing.
   */
  dispose(): void;
  [Symbol.dispose](): void;
}

/** The cell that contains a point. */
export interface Cell<Kind extends string> {
  kind: Kind;
  index: number;
  /** Whether the cell belongs to the set. */
  isInside: boolean;
}
export interface RayHit<Kind extends string> {
  cell: Cell<Kind>;
  /** The first point of the cell on the ray. */
  point: Fraction[];
}

/** Nearest points of the closures of two sets. */
export interface Distance<Kind extends string> {
  /** The square of the distance, exact. */
  squared: Fraction;
  /** The nearest point of the first set and the nearest point of the second set, both exact. */
  points: [Fraction[], Fraction[]];
  /** The cells that contain these points. */
  cells: [Cell<Kind>, Cell<Kind>];
}

/**
 * The common interface of sets of space, of the plane and of the sphere. All sets are immutable.
 */
export abstract class PointSet<Self, Vector, Kind extends string> extends Handle {
  /** Returns another object with the same set, without copying its data. */
  copy(): Self;
  union(other: Self, options?: Options): Self;
  intersection(other: Self, options?: Options): Self;
  difference(other: Self, options?: Options): Self;
  symmetricDifference(other: Self, options?: Options): Self;
  complement(options?: Options): Self;
  interior(options?: Options): Self;
  closure(options?: Options): Self;
  boundary(options?: Options): Self;
  /** The interior of the complement. */
  exterior(options?: Options): Self;
  /** The closure of the interior. */
  regularization(options?: Options): Self;
  isEmpty(): boolean;
  isWhole(): boolean;
  isClosed(): boolean;
  isOpen(): boolean;
  /** The memory in bytes; copies share it. */
  memoryBytes(): number;
  /** Whether both sets have the same points. */
  equals(other: Self): boolean;
  isSubsetOf(other: Self, options?: Options): boolean;
  contains(point: Vector, options?: Options): boolean;
  locate(point: Vector, options?: Options): Cell<Kind>;
  locateAll(points: readonly Vector[]|Float64Array, options?: Options): Cell<Kind>[];
  /** Returns the first cell on a ray that belongs to the set, or null if there is none. */
  shoot(origin: Vector, direction: Vector, options?: Options): RayHit<Kind>|null;
  /** Returns the first cell of the boundary on a ray, whether or not it belongs to the set. */
  shootToBoundary(origin: Vector, direction: Vector, options?: Options): RayHit<Kind>|null;
  /**
   * Checks every invariant from scratch. Returns a sentence about the first broken invariant, or
   * null if all invariants hold.
   */
  audit(options?: Options): string|null;
}

/**
 * The attributes of a mesh that a solid keeps. 'colours' stands for materials and for the channel
 * 'color'.
 */
export type KeptAttributes = 'none'|'colours'|'ids'|'all';
export interface FromMeshOptions extends Options {
  /**
   * The attributes that the solid keeps. By default, a solid keeps all attributes of a mesh in
   * arrays, and no attributes of a file. With 'all', a mesh in arrays becomes a source even if it
   * has no attributes, so that faces of results can be traced to its faces.
   */
  keep?: KeptAttributes;
  /**
   * The winding numbers that count as inside. By default, these are the positive numbers. In this
   * case, components that are inside out are flipped first.
   */
  rule?: Rule;
  /** Whether the set is the union of the faces. Then the mesh may be open. */
  surface?: boolean;
  /**
   * Whether a mesh that encloses nothing is accepted, as the empty set. Otherwise it is an error.
   */
  mayBeEmpty?: boolean;
  /** How the mesh is repaired first. */
  repair?: Repair;
}
export interface FromArraysOptions extends FromMeshOptions {
  /** The attributes of faces and corners. */
  attributes?: MeshAttributes;
  /** The name of the mesh in Solid.sources(). */
  sourceName?: string;
}
export interface RoundingOptions extends Options {
  /**
   * The kind of rounding. With 'valid' (the default), faces and edges meet only at common ends
   * after rounding. With 'nearest', coordinates are the nearest doubles, even if faces or edges
   * then cross.
   */
  rounding?: 'valid'|'nearest';
  onNote?: (note: Note) => void;
}
export interface ToMeshOptions extends RoundingOptions {
  /** Whether coordinates are rounded to floats. */
  floats?: boolean;
  /** Whether each cone at a vertex gets a point of its own. */
  splitVertices?: boolean;
}

/**
 * A set of points of space that can be made from half-spaces by unions, intersections and
 * complements. It may be bounded or unbounded, open or closed, and may have dangling parts.
 */
export class Solid extends PointSet<Solid, Vector3, 'vertex'|'edge'|'facet'|'volume'> {
  private constructor();
  static empty(): Solid;
  static whole(): Solid;
  static point(point: Vector3): Solid;
  static points(points: Points3, options?: Options): Solid;
  static unionOf(solids: readonly Solid[], options?: Options): Solid;
  static intersectionOf(solids: readonly Solid[], options?: Options): Solid;
  /**
   * Returns the solid that triangles bound. The mesh may cross itself. An open mesh causes the
   * error BAD_SHAPE.
   */
  static fromMesh(vertices: Coordinates, triangles: Indices, options?: FromArraysOptions): Solid;
  static fromPolygons(
      vertices: Coordinates, faceBegin: Indices, corners: Indices,
      options?: FromArraysOptions): Solid;
  /**
   * Returns the set of points with a x + b y + c z + d <= 0, or < 0 if `closed` is false. `source`
   * has the attributes of the boundary.
   */
  static halfSpace(plane: Vector4, options?: {closed?: boolean; source?: PlaneSource}): Solid;
  /**
   * Returns the intersection of half-spaces. `planes` contains four numbers for each half-space.
   */
  static halfSpaces(planes: Coordinates, options?: Options&{closed?: boolean}): Solid;
  static plane(plane: Vector4): Solid;
  static polyline(points: Points3, options?: Options): Solid;
  /** The closed polygon with these corners, which must lie in one plane. */
  static facet(corners: Points3, options?: Options): Solid;
  /** The box between two exact corners. */
  static box(low: Vector3, high: Vector3, options?: Options&{closed?: boolean}): Solid;
  /** Returns a ball around the origin, as a polyhedron of 8 * 4 ** rounds triangles. */
  static ball(radius: number, rounds?: number): Solid;
  /** Returns a ball whose equator has `chords` corners. The ball is exactly convex. */
  static sphere(radius: number, chords?: number, options?: Options): Solid;
  static cylinder(height: number, bottomRadius: number, options?: Options&{
    topRadius?: number;
    chords?: number;
    centred?: boolean
  }): Solid;
  static torus(radius: number, tubeRadius: number, options?: Options&{
    chords?: number;
    tubeChords?: number
  }): Solid;
  static hull(points: Points3, options?: Options): Solid;
  static hullOf(solids: readonly Solid[], options?: Options): Solid;
  /**
   * Returns the value of an expression such as '(A + B) * !C'. The operators are + (union), *
   * (intersection), - (difference), ^ (symmetric difference), ! (complement) and @ (Minkowski
   * sum), which binds more tightly than *.
   */
  static evaluate(expression: string, solids: Record<string, Solid>, options?: Options): Solid;
  /** Reads OFF, OBJ, STL, PLY, glTF, 3MF or .nef. */
  static read(data: FileData, options?: ReadOptions&FromMeshOptions&SiblingFiles): Solid;
  static fromBytes(data: FileData): Solid;
  /**
   * Reads half-spaces from lines `a b c d closed` or `a b c d open`, and returns their
   * intersection.
   */
  static readHalfSpaces(data: FileData, options?: ReadOptions): Solid;
  /**
   * Draws several solids. Each solid is moved away from the middle of all solids by `apart` times
   * its distance from this middle; by default, `apart` is 1.
   */
  static drawMany(solids: readonly Solid[], format: PictureFormat, options?: Options&{
    title?: string;
    apart?: number
  }): Uint8Array;

  /** Writes the solid. A mesh has the attributes of the sources that the format can represent. */
  write(format: MeshFormat|'nef', options?: RoundingOptions): Uint8Array;
  /**
   * Writes the solid as files. The extension of `name` or `format` selects the format. If sources
   * have materials, an OBJ file has a second file (.mtl) beside it, with the colours.
   */
  writeFiles(name: string, options?: RoundingOptions&{format?: MeshFormat | 'nef'}):
      Record<string, Uint8Array>;
  /** Returns the canonical .nef file of the solid. Equal sets give equal bytes. */
  toBytes(options?: Options): Uint8Array;
  draw(format: PictureFormat, options?: Options&{title?: string}): Uint8Array;
  /** Returns an HTML page that shows the solid and does not load other files. */
  toHtml(options?: Options&{title?: string}): string;
  /**
   * Returns the boundary of a bounded solid. facets[t] is the facet from which triangle t was made.
   */
  toMesh(options?: ToMeshOptions): TriangleMesh&{
    facets: Uint32Array;
    report: ToMeshReport
  };
  toPolygons(options?: ToMeshOptions): PolygonMesh&{
    facets: Uint32Array;
    report: ToMeshReport
  };
  /**
   * Returns the boundary of a bounded solid, valid after rounding, with the attributes of the
   * sources. The parts of a facet that lie in different triangles of a source are joined as
   * `pieces` states. With 'same attributes', parts with the same attributes become one face. With
   * 'same face', each face also lies in one face of a source. With 'apart', each face lies in one
   * triangle of a source.
   */
  toMeshWithAttributes(options?: Options&{
    pieces?: 'same attributes'|'apart'|'same face';
    /** Whether coordinates become floats. */
    floats?: boolean;
  }): TriangleMesh&FaceSources;
  /** Does the same, but a planar face stays a polygon. */
  toPolygonsWithAttributes(options?: Options&{pieces?: 'same attributes' | 'apart' | 'same face'}):
      PolygonMesh&FaceSources;
  /** The names of the meshes with attributes from which the solid was made. */
  sources(): string[];
  /** Returns the same solid with a single source. The faces of the source should lie on the
   * boundary of the solid. */
  withSource(mesh: Mesh, name?: string): Solid;
  /** Returns the same set with its cells in an order that depends only on the set. */
  canonical(options?: Options): Solid;
  /** Combines the solid with a half-space or a plane. */
  section(plane: Vector4, options?: Options&{
    kind?: 'closed below'|'open below'|'plane';
    operation?: 'union'|'intersection'|'difference'|'symmetricDifference';
  }): Solid;
  /** Returns the exact image under an affine map, which is given by three rows [a, b, c, d]. */
  transformed(rows: readonly Vector4[], options?: Options): Solid;
  translated(by: Vector3, options?: Options): Solid;
  /**
   * Returns the image under a rotation. The matrix of the rotation is exactly orthogonal. A
   * rotation about a coordinate axis by a multiple of 90 degrees is exact.
   */
  rotated(axis: readonly[number, number, number], degrees: number, options?: Options): Solid;
  mirrored(normal: Vector3, options?: Options): Solid;
  scaled(factors: Vector3|Exact, options?: Options): Solid;
  /**
   * Returns the image under a scaling. After this scaling, the bounding box has the sizes `size`.
   * Along an axis with the size 0, the factor is 1. If this axis is `automatic`, its factor is
   * instead the greatest factor of the other axes.
   */
  resized(size: Vector3, options?: Options&{automatic?: readonly[boolean, boolean, boolean]}):
      Solid;
  /**
   * Returns the closure of the solid, grown if `distance` is positive, and shrunk if it is
   * negative. The ball of the offset is replaced by a polyhedron: an octahedron whose faces were
   * subdivided `rounds` times (by default 3, at most 7).
   */
  offset(distance: number, options?: Options&{rounds?: number}): Solid;
  minkowskiSum(other: Solid, options?: Options): Solid;
  /**
   * Returns the set of the vectors by which the other solid can be translated so that it lies in
   * this solid.
   */
  minkowskiErosion(other: Solid, options?: Options): Solid;
  /**
   * Returns the convex parts of the solid. Every point of the solid belongs to exactly one part. If
   * `closed` is true, the closures of the parts are returned instead. The parts keep the attributes
   * of the solid; faces on cuts have none.
   */
  decompose(options?: Options&{
    method?: 'best'|'cuts'|'walls';
    closed?: boolean
  }): Solid[];
  components(options?: Options): Solid[];
  convexHull(options?: Options): Solid;
  slice(height: Exact, options?: Options): PlaneSet;
  slices(heights: readonly Exact[]|Float64Array, options?: Options): PlaneSet[];
  /** Returns the closure of the projection along the z-axis. */
  shadow(options?: Options): PlaneSet;
  /** Returns, for each point x, y, z, 1 if it belongs to the set, and 0 otherwise. */
  containsPoints(points: Coordinates, options?: Options): Uint8Array;
  counts():
      {vertices: number; edges: number; facets: number; volumes: number; markedVolumes: number};
  isBounded(): boolean;
  /** Whether the boundary is a 2-manifold. */
  isSimple(): boolean;
  isConvex(): boolean;
  /**
   * Returns whether the solid is convex, with evidence. `failing` contains pairs: a facet, and a
   * vertex on the outer side of this facet.
   */
  convexity(options?: Options): {isConvex: boolean; reflexEdges: number; failing: Uint32Array};
  /**
   * Returns nearest points of the closures of the two sets. An empty set causes the error
   * BAD_ARGUMENT.
   */
  distance(other: Solid, options?: Options): Distance<'vertex'|'edge'|'facet'|'volume'>;
  /** Returns the exact volume, or null if it is infinite. */
  volume(options?: Options): Fraction|null;
  /** Returns the exact centroid, or null if the volume is 0 or infinite. */
  centroid(options?: Options): Fraction[]|null;
  /** Returns the area of the boundary, with a relative error below 2 ** -50. */
  surfaceArea(options?: Options): number;
  /**
   * Returns the number of handles of the boundary, or null if the boundary is not a closed surface.
   */
  genus(): number|null;
  boundingBox(): {low: Fraction[]; high: Fraction[]}|null;
}

/**
 * Polygons, lines and points in flat arrays. The rings of polygon p start at polygonBegin[p], and
 * the corners of ring r start at ringCorners[ringBegin[r]].
 */
export interface Shapes {
  points: Float64Array;
  polygonBegin: Uint32Array;
  ringBegin: Uint32Array;
  ringCorners: Uint32Array;
  lineBegin: Uint32Array;
  lineCorners: Uint32Array;
  singles: Uint32Array;
}
export interface RoundingReport {
  verticesMoved: number;
  verticesMerged: number;
  edgesBent: number;
  edgesFolded: number;
  collapsed: number;
  largestMove: number;
}

/**
 * A set of points of the plane. It consists of polygons, lines and points, each of which may or may
 * not contain its boundary.
 */
export class PlaneSet extends PointSet<PlaneSet, Vector2, 'vertex'|'edge'|'face'> {
  private constructor();
  static empty(): PlaneSet;
  static whole(): PlaneSet;
  static point(point: Vector2): PlaneSet;
  static points(points: Points2, options?: Options): PlaneSet;
  static unionOf(sets: readonly PlaneSet[], options?: Options): PlaneSet;
  static intersectionOf(sets: readonly PlaneSet[], options?: Options): PlaneSet;
  /** Returns the set of points with a x + b y + c <= 0, or < 0 if `closed` is false. */
  static halfPlane(line: Vector3, options?: {closed?: boolean}): PlaneSet;
  static line(line: Vector3): PlaneSet;
  static box(low: Vector2, high: Vector2, options?: Options&{closed?: boolean}): PlaneSet;
  /**
   * Returns the regular polygon with `chords` corners that is inscribed in a circle around the
   * origin.
   */
  static disk(radius: number, chords?: number, options?: Options): PlaneSet;
  static polygon(points: Points2, options?: Options&{closed?: boolean}): PlaneSet;
  /**
   * Returns the set that closed chains of points bound. The coordinates are doubles. By default,
   * the odd winding numbers are inside.
   */
  static polygons(rings: readonly Points2[], options?: Options&{
    rule?: Rule;
    closed?: boolean
  }): PlaneSet;
  static fromRings(points: Coordinates, ringBegin: Indices, corners: Indices, options?: Options&{
    rule?: Rule;
    closed?: boolean
  }): PlaneSet;
  static polyline(points: Points2, options?: Options): PlaneSet;
  static polylines(chains: readonly Points2[], options?: Options): PlaneSet;
  static hull(points: Points2, options?: Options): PlaneSet;
  static hullOf(sets: readonly PlaneSet[], options?: Options): PlaneSet;
  /** Reads WKT, GeoJSON, WKB, DXF, SVG or .nef2. */
  static read(data: FileData, options?: ReadOptions): PlaneSet;
  static fromBytes(data: FileData): PlaneSet;

  /** Writes the set. If `grid` is given, coordinates are rounded to multiples of it. */
  write(format: 'wkt'|'wkb'|'geojson'|'dxf'|'nef2', options?: RoundingOptions&{grid?: Exact}):
      Uint8Array;
  /** Returns the .nef2 file of the set, which represents the set exactly. */
  toBytes(options?: Options): Uint8Array;
  toWkt(options?: RoundingOptions&{grid?: Exact}): string;
  toGeoJson(options?: RoundingOptions&{grid?: Exact}): object;
  draw(format: PictureFormat, options?: Options&{title?: string}): Uint8Array;
  toHtml(options?: Options&{title?: string}): string;
  /**
   * Returns the bounded parts of the closure as arrays. Coordinates are rounded to the nearest
   * doubles, and edges may then cross. To avoid this, call rounded() first.
   */
  shapes(options?: Options): Shapes;
  /**
   * Returns the closure, with coordinates rounded to doubles or to multiples of `step`. After
   * rounding, edges still meet only at common ends.
   */
  rounded(options?: Options&{step?: Exact}): {set: PlaneSet; report: RoundingReport};
  /** Returns triangles that cover a bounded set, as a mesh with z = 0. */
  triangulated(options?: Options): TriangleMesh;
  /** Returns the exact image under an affine map, which is given by two rows [a, b, c]. */
  transformed(rows: readonly Vector3[], options?: Options): PlaneSet;
  translated(by: Vector2, options?: Options): PlaneSet;
  /**
   * Returns the closure of the set, grown if `distance` is positive, and shrunk if it is negative.
   */
  offset(distance: number, options?: Options&{
    join?: 'round'|'mitre'|'square'|'bevel';
    mitreLimit?: number;
    chordError?: number;
    circleSegments?: number;
  }): PlaneSet;
  /**
   * Returns the closure of a bounded set with fewer corners, rounded to doubles. A corner and its
   * two neighbours along the border form a triangle. A corner is removed only under three
   * conditions. The area of its triangle is at most `tolerance`. More than the fraction `kept` of
   * the removable corners remains. No point of a border moves farther than `within`.
   */
  simplified(options?: SimplifyOptions): PlaneSet;
  /** Does the same as simplified(), and returns a report on the changes. */
  simplifiedWithReport(options?: SimplifyOptions): {set: PlaneSet; report: SimplifyReport};
  minkowskiSum(other: PlaneSet, options?: Options): PlaneSet;
  decompose(options?: Options&{
    method?: 'best'|'cuts'|'diagonals'|'optimal';
    closed?: boolean
  }): PlaneSet[];
  convexHull(options?: Options): PlaneSet;
  extruded(height: number, options?: Options&{
    centred?: boolean;
    /** The angle in degrees by which the top is turned clockwise. */
    twist?: number;
    layers?: number;
    /** The factor at the top, or the two factors of x and y. */
    scale?: number|readonly[number, number];
  }): Solid;
  /**
   * Returns the solid that the set sweeps when it turns around the z-axis. The y-axis of the set is
   * placed on the z-axis.
   */
  revolved(options?: Options&{
    angle?: number;
    steps?: number
  }): Solid;
  containsPoints(points: Coordinates, options?: Options): Uint8Array;
  counts(): {vertices: number; edges: number; faces: number; markedFaces: number};
  isBounded(): boolean;
  isConvex(options?: Options): boolean;
  convexity(options?: Options): {isConvex: boolean; reflexCorners: number; parts: number};
  /**
   * Returns nearest points of the closures of the two sets. An empty set causes the error
   * BAD_ARGUMENT.
   */
  distance(other: PlaneSet, options?: Options): Distance<'vertex'|'edge'|'face'>;
  /** Returns the exact area, or null if it is infinite. */
  area(options?: Options): Fraction|null;
}

/**
 * A set of directions. A direction is given by a vector; all positive multiples of a vector give
 * the same direction.
 */
export class SphereSet extends PointSet<SphereSet, Vector3, 'point'|'arc'|'face'> {
  private constructor();
  static empty(): SphereSet;
  static whole(): SphereSet;
  static point(direction: Vector3): SphereSet;
  static points(directions: Points3, options?: Options): SphereSet;
  static unionOf(sets: readonly SphereSet[], options?: Options): SphereSet;
  static intersectionOf(sets: readonly SphereSet[], options?: Options): SphereSet;
  static halfSphere(normal: Vector3, options?: Options&{closed?: boolean}): SphereSet;
  /** Returns the intersection of half-spheres. */
  static halfSpheres(normals: Points3, options?: Options&{closed?: boolean}): SphereSet;
  static circle(normal: Vector3): SphereSet;
  /** Returns the region to the left of a closed chain of shortest arcs. */
  static polygon(corners: Points3, options?: {closed?: boolean}): SphereSet;
  static arc(from: Vector3, to: Vector3, options?: {closed?: boolean}): SphereSet;
  counts(): {points: number; arcs: number; faces: number; markedFaces: number};
}

// ---- maps and layers

export interface MapDefect {
  kind: 'duplicate'|'open'|'crossing'|'twin'|'mixed'|'nested';
  cycles: number[];
  /** The edges at which the defect occurs, as pairs of vertices. */
  edges: [number, number][];
  /** The exact position, or null if the defect has no point. */
  point: [Fraction, Fraction]|null;
  near: [number, number]|null;
  /** A sentence that explains the defect and how to correct it. */
  hint: string;
}
/** A half-edge structure in flat arrays. The twin of half-edge h is h ^ 1. */
export interface HalfEdges {
  faceCount: number;
  points: Float64Array;
  origin: Uint32Array;
  next: Uint32Array;
  prev: Uint32Array;
  face: Uint32Array;
  /** For each vertex, a half-edge that leaves it; 0xffffffff for an isolated vertex. */
  leaving: Uint32Array;
}

/**
 * A map as a user lists it: points, and cycles of indices of points. check() decides whether it is
 * a planar subdivision.
 */
export class Map extends Handle {
  private constructor();
  static fromCycles(points: Points2, cycles: readonly Indices[]): Map;
  static fromArrays(points: Points2, cycleBegin: Indices, corners: Indices): Map;
  /**
   * Reads a map, or polygons from WKT, GeoJSON or WKB. Polygons do not list outer boundaries, so
   * such a map must be checked with check({outer: 'infer'}).
   */
  static read(data: FileData, options?: ReadOptions): Map;
  write(): Uint8Array;
  readonly pointCount: number;
  readonly cycleCount: number;
  points(): Float64Array;
  cycles(): number[][];
  /** Decides exactly whether the map is a planar subdivision. */
  check(options?: Options&{
    outer?: 'listed'|'infer'|'ignore';
    mergeVertices?: boolean;
    maxDefects?: number
  }): MapReport;
}
export class MapReport extends Handle {
  private constructor();
  readonly verdict: 'valid'|'not planar'|'open'|'superposed';
  readonly isValid: boolean;
  counts(): {
    vertices: number; edges: number; cycles: number; components: number; regions: number;
    defects: Record<MapDefect['kind'], number>;
  };
  defects(): MapDefect[];
  warnings(): string[];
  /** Returns, for each region, the cycles that bound it. Region 0 is the unbounded region. */
  regions(): number[][];
  /**
   * Returns the checked map. In this map, vertices are merged and outer cycles are added if the
   * options of check() asked for it.
   */
  map(): Map;
  /** Returns the union of the given regions of a valid map. */
  select(regions: readonly number[], options?: Options&{closed?: boolean}): PlaneSet;
  dcel(): HalfEdges;
  write(format: 'text'|'json'|'geojson'|PictureFormat, options?: {title?: string}): Uint8Array;
  toString(): string;
  toHtml(options?: {title?: string}): string;
}
/** The subdivision of the plane by the edges of two valid maps. */
export class MapOverlay extends Handle {
  private constructor();
  readonly faceCount: number;
  /**
   * Returns, for each face, the region of the first map and the region of the second map that
   * contain it.
   */
  regions(): [number, number][];
  /** Returns the exact areas of the faces. The area of an unbounded face is given as 0. */
  areas(): Fraction[];
  dcel(): HalfEdges;
  write(format: 'text'|'json'|'geojson'|'svg'|'html', options?: RoundingOptions&{title?: string}):
      Uint8Array;
}
export function overlay(first: MapReport, second: MapReport, options?: Options): MapOverlay;

export interface LayerReport {
  /** Whether there are overlaps, gaps, crossings or nestings. */
  hasDefects: boolean;
  regions: {
    /** A crossing is a point at which the border of a feature crosses itself, or edges on which it
     * lies twice. A nesting is a ring that is listed as a hole, but lies outside of the outer ring
     * or in another hole. */
    kind: 'overlap'|'gap'|'hole'|'crossing'|'nesting'; area: Fraction;
    /** Whether the region is a gap that opens to the outside or into a hole. */
    isOpen: boolean;
    /** Twice the area divided by the perimeter. */
    width: number;
    features: number[];
    /** The feature that gets the region, or null. */
    owner: number | null;
    /** A place to look at: the point of a crossing, or a corner of another region or of the ring of
     * a nesting. */
    at: [number, number]|null;
  }[];
  text: string;
  geoJson: object;
}
/** Bounds for the simplification of borders. A corner is removed only if all bounds allow it. */
export interface SimplifyOptions extends Options {
  /** The largest area of the triangle of a corner and its two neighbours. */
  tolerance?: number;
  /**
   * The removal stops when only this fraction of the removable corners is left. A number from 0 to
   * 1.
   */
  kept?: number;
  /** The largest distance by which a point of a border may move. */
  within?: number;
}
/** A report on the changes that a simplification has made. */
export interface SimplifyReport {
  cornersBefore: number;
  cornersAfter: number;
  /**
   * The corners of a layer that cannot be removed because three or more borders meet there. 0 for a
   * set.
   */
  fixed: number;
  /**
   * The corners whose removal the bounds allow. They are kept because borders would touch without
   * them, or because a ring would collapse.
   */
  blocked: number;
  /** The overlaps of features, which went to the first feature. */
  overlaps: number;
  /** An upper bound for the distance by which borders have moved. */
  bordersMoved: number;
  /**
   * An upper bound for the distance by which rounding has moved borders. Rounding comes before the
   * simplification.
   */
  roundingMoved: number;
}
/** Options of Layer.check(). */
export interface LayerCheckOptions extends Options {
  /** An enclosed region that no feature covers is a gap if it is narrower than this number. */
  gapsBelow?: number;
  /** Whether gaps that open to the outside or into a hole stay as they are. */
  enclosedOnly?: boolean;
}
/** Options of Layer.repaired(). */
export interface LayerRepairOptions extends LayerCheckOptions {
  /** Selects the feature that gets an overlap or a gap. */
  owner?: 'longest border'|'largest'|'smallest'|'first'|'lowest id';
  /** A number for each feature. Under the owner 'first', the feature with the least number gets a
   * region. */
  ranks?: ArrayLike<number>|null;
  /**
   * Pairs of features, which are applied before `owner`. The second feature of a pair does not get
   * a region that the first feature may get. A feature is given by its index, or by a text for
   * find().
   */
  preferences?: readonly(readonly[number | string, number|string])[];
}
/** A list of features, such as countries. A feature has polygons, an id and properties. */
export class Layer extends Handle {
  private constructor();
  /**
   * Reads GeoJSON, TopoJSON, WKT or WKB. GeoJSON may also be given as an object. `object` is the
   * name of an object of TopoJSON.
   */
  static read(data: FileData|{type: string}, options?: ReadOptions&{object?: string}): Layer;
  /**
   * Returns the Voronoi cells of points, cut off at a box. `box` contains the coordinates x, y of
   * two opposite corners.
   */
  static voronoi(points: Coordinates, box: Coordinates, options?: Options): Layer;
  /** Returns a layer with one feature for each bounded face of a set. */
  static ofFaces(set: PlaneSet, options?: Options): Layer;
  /**
   * Divides a set into the parts that the features cover. Each part becomes a feature with the id
   * and the properties of the feature that covers it. A part that several features cover is
   * assigned to the first of them. Parts that no feature covers form the last feature, which has no
   * id.
   */
  parts(set: PlaneSet, options?: Options): Layer;
  /** Returns a layer with the features of this layer, followed by the features of another layer. */
  joined(other: Layer, options?: Options): Layer;
  readonly featureCount: number;
  /**
   * The name of the coordinate reference system that the file states, or an empty text. Operations
   * pass it on, and GeoJSON is written with it. Coordinates are never converted.
   */
  readonly crs: string;
  ids(): unknown[];
  properties(): (Record<string, unknown>|null)[];
  /**
   * Returns the index of the feature with the id `idOrName`. If there is none, returns the index of
   * the feature whose property 'name' or 'NAME' is `idOrName`.
   */
  find(idOrName: string): number;
  write(format: 'geojson'|'topojson'|'wkt', options?: Options): Uint8Array;
  toGeoJson(options?: Options): object;
  /** Returns the overlaps, gaps, holes, crossings and nestings of the layer. */
  check(options?: LayerCheckOptions): LayerReport;
  /** Returns the layer without overlaps and gaps. */
  repaired(options?: LayerRepairOptions): {layer: Layer; report: LayerReport};
  /**
   * Returns a layer with one feature for each group. groups[f] is the group of feature f, or null
   * if the feature is left out.
   */
  dissolved(groups: readonly(number|null)[], options?: Options): Layer;
  /**
   * Returns the layer with fewer corners. A corner and its two neighbours along the border form a
   * triangle. A corner is removed only under three conditions. The area of its triangle is at most
   * `tolerance`. More than the fraction `kept` of the removable corners remains. No point of a
   * border moves farther than `within`.
   */
  simplified(options?: SimplifyOptions): Layer;
  /** Does the same as simplified(), and returns a report on the changes. */
  simplifiedWithReport(options?: SimplifyOptions): {layer: Layer; report: SimplifyReport};
  /** Returns a layer with one feature for each pair of overlapping features of the two layers. */
  overlaid(other: Layer, options?: Options&{pairs?: 'all' | 'first' | 'both' | 'first only'}):
      {layer: Layer; pairs: [number | null, number|null][]};
}

// ---- surfaces and models

/** A surface that consists of triangles, with points and polygons on the surface. */
export class Scene extends Handle {
  private constructor();
  /** Makes a scene without polygons. The triangles must form an orientable 2-manifold. */
  static fromMesh(vertices: Coordinates, triangles: Indices): Scene;
  static read(data: FileData, options?: ReadOptions&SiblingFiles): Scene;
  /**
   * Returns the scene as JSON. `model` is the name of the file that contains the mesh. This name is
   * written into the scene.
   */
  write(model: string): Uint8Array;
  readonly polygonCount: number;
  /**
   * Adds a point of a face, and returns the index of the point. `weights` contains the weights of
   * the second and the third corner of the face.
   */
  addPoint(face: number, weights: Vector2): number;
  /** Adds the closed polygon of geodesics through points, and returns its index. */
  addPolygon(points: Indices, options?: Options): number;
  /**
   * Adds a shape, which is the sum of the given polygons. If a scene has no shapes, each polygon
   * counts as a shape.
   */
  addShape(polygons: Indices): number;
  /**
   * Sets the face that determines where labels are 0: at the first corner of this face, the label
   * of every shape is 0.
   */
  setOutside(face: number): void;
  /**
   * Adds loops around handles so that all shapes separate the surface. Returns the number of loops.
   */
  separate(options?: Options): number;
  /**
   * Returns a path between two points, or null if the points lie on different components. The path
   * is locally shortest. If `shortest` is true, it is globally shortest.
   */
  geodesic(from: number, to: number, options?: Options&{shortest?: boolean}):
      {length: number; points: Float64Array; faces: Uint32Array}|null;
  divide(options?: Options): SurfaceDivision;
}
/** A surface that polygons divide into cells. */
export class SurfaceDivision extends Handle {
  private constructor();
  counts(): {
    triangles: number; segments: number; crossings: number; cells: number; shapes: number;
    cellEdges: number
  };
  /**
   * Returns, for each shape, the number of times that it winds around a cell. Shapes with the
   * number 0 are omitted.
   */
  labels(cell: number): {shape: number; value: number}[];
  area(cell: number): number;
  /** Returns pairs of neighbouring cells. */
  neighbours(): Uint32Array;
  separates(shape: number): {overIntegers: boolean; modulo2: boolean};
  toMesh(options?: Options): TriangleMesh&{cells: Uint32Array};
  /**
   * Returns the cells for which an expression such as 'A * !B' is true. By default, odd labels
   * count as inside.
   */
  select(expression: string, options?: Options&{rule?: Rule}): SurfaceRegion;
  audit(): string|null;
  write(format: 'obj'|'ply'|'glb'|'dot', options?: Options&{region?: SurfaceRegion}): Uint8Array;
  draw(format: PictureFormat, options?: Options&SurfacePicture): Uint8Array;
  toHtml(options?: Options&SurfacePicture): string;
}
export interface SurfacePicture {
  region?: SurfaceRegion;
  layer?: 'polygons'|'slices'|'cells'|'labels'|'result';
  title?: string;
}
export class SurfaceRegion extends Handle {
  private constructor();
  readonly cellCount: number;
  readonly loopCount: number;
  readonly area: number;
  has(cell: number): boolean;
  toScene(): Scene;
}

/** Evaluates a flattened model of OpenSCAD (.csg). Returns null if the model has no geometry. */
export function readCsg(data: FileData, options?: ReadOptions&SiblingFiles): Solid|PlaneSet|null;
