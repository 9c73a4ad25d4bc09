// Types of the package. docs/javascript.md explains it with examples.

/** Loads the engine; needed once, before anything else. Later calls wait for the same load. */
export function init(options?: {
  /** The address, the bytes or the module of engine.wasm, if it does not lie beside the script. */
  wasm?: string|URL|ArrayBuffer|Uint8Array|WebAssembly.Module;
}): Promise<void>;
/** Whether the engine is loaded. */
export function isReady(): boolean;
/** The version of the library, such as '0.1.0'. */
export function version(): string;
/** Whether the arithmetic is what exact predicates need. Warnings say what is wrong. */
export function selfTest(): {isOk: boolean; notes: Note[]};

// ---- errors and options

/** Names of what goes wrong. */
export type ErrorCode =
    |'CANNOT_OPEN'|'CANNOT_WRITE'|'NOT_TEXT'|'SYNTAX'|'NUMBER_OUT_OF_RANGE'|'COUNT_MISMATCH'|
    'BAD_INDEX'|'DEGENERATE_FACE'|'UNKNOWN_FORMAT'|'USAGE'|'CLOSED_PIPE'|'BAD_SHAPE'|
    'RESOURCE_LIMIT'|'CANCELLED'|'NOT_FINITE'|'BAD_ARGUMENT'|'OUT_OF_MEMORY'|'INTERNAL'|'NOT_READY';

/**
 * What every function throws. `message` is 'FILE:LINE:COLUMN: reason', as far as the place is
 * known.
 */
export class PlumbError extends Error {
  constructor(
      code: ErrorCode, reason: string,
      place?: {text?: string; file?: string; line?: number; column?: number});
  readonly code: ErrorCode;
  /** The sentence without the place. */
  readonly reason: string;
  /** The name of the text that the error is about; '' if it is about none. */
  readonly file: string;
  /** From 1; 0 if unknown. */
  readonly line: number;
  /** In bytes, from 1; 0 if unknown. */
  readonly column: number;
}

/** What every operation takes as its last argument. */
export interface Options {
  /** The time that the operation may take, in seconds. */
  timeout?: number;
  /** The working memory that it may take, in bytes, as the engine estimates it. */
  memoryLimit?: number|bigint;
  /**
   * Called at most 20 times a second; `total` is 0 if unknown. What it throws stops the operation
   * and is thrown by it.
   */
  onProgress?: (phase: string, done: number, total: number) => void;
  /**
   * Stops the operation. On the thread of the operation it is asked after each report of progress.
   */
  signal?: AbortSignal;
}

/** What a file holds and a set does not, or the reverse. */
export interface Note {
  text: string;
  /** Whether geometry was lost. */
  isWarning: boolean;
}

/** How files are read. */
export interface ReadOptions extends Options {
  /**
   * The name of the file: its extension chooses the format, and messages have it. Without a name,
   * the first bytes choose.
   */
  name?: string;
  /** Whether 0.1 means a tenth, not the nearest double. */
  exactDecimals?: boolean;
  onNote?: (note: Note) => void;
}

/** Files are bytes or texts. */
export type FileData = Uint8Array|ArrayBuffer|ArrayBufferView|string;
/** The files that a file names, by their names. `name` must then be stated, too. */
export interface SiblingFiles {
  files?: Record<string, FileData>;
}

// ---- numbers

/** An exact number: a double stands for exactly what it is, '0.1' for a tenth. */
export type Exact = number|bigint|string|Fraction;
export type Vector2 = readonly[Exact, Exact]|Float64Array;
export type Vector3 = readonly[Exact, Exact, Exact]|Float64Array;
export type Vector4 = readonly[Exact, Exact, Exact, Exact]|Float64Array;
/** Points as arrays, or coordinates x, y(, z), x, ... in one Float64Array. */
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
  /** The nearest number; an infinity beyond the largest one. */
  toNumber(): number;
  valueOf(): number;
  equals(other: Exact): boolean;
}

// ---- meshes

/** vertices: x, y, z, x, ... triangles: three indices each, counter-clockwise seen from outside. */
export interface TriangleMesh {
  vertices: Float64Array;
  triangles: Uint32Array;
  attributes?: MeshAttributes;
}
/** Face f has the corners from corners[faceBegin[f]] to corners[faceBegin[f + 1] - 1]. */
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
/** `width` numbers for each corner of each face, in the order of the corners, or each vertex. */
export interface Channel {
  width: number;
  values: Coordinates;
}
/**
 * What belongs to the faces and corners of a mesh. All members can be left out. Arrays of faces
 * have an entry for each face; 0xffffffff stands for none.
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
/** The attributes of a mesh that the package made: null where no face has a value. */
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
 * Which faces of which sources the faces of a mesh are parts of. Faces are in the order of
 * `source`; those without a source are last, and have 0xffffffff.
 */
export interface FaceSources {
  /** For each face, the index in Solid.sources() of the mesh that it is a part of. */
  source: Uint32Array;
  /** For each face, the face of this mesh. */
  sourceFace: Uint32Array;
  /** For each face, 1 if it and the face of the source have opposite sides, else 0. */
  isFlipped: Uint8Array;
  /** Materials and groups of all sources follow each other. */
  attributes: FoundAttributes;
  report: ToMeshReport;
}
/** What a mesh of a solid changes or does not show. */
export interface ToMeshReport {
  roundedVertices: number;
  /** Rounds of repair; 0: the nearest numbers are valid. */
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
/** How a mesh is mended. By default nothing is done. */
export interface Repair {
  /** Points at most this far apart become one. */
  weld?: number;
  /** What happens to faces with the corners of an earlier face. */
  doubled?: 'keep'|'if better'|'drop';
  /** Whether faces that disagree with their neighbours are turned. */
  reorient?: boolean;
  /** Holes with at most so many edges are filled. */
  fillHoles?: number;
  /** Holes in a box of at most this diagonal are filled, too. */
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
 * Indices of faces; `doubled` and `crossings` are pairs of faces, `borders` and `holes` chains of
 * vertices.
 */
export interface MeshReport {
  isClosed: boolean;
  /** All crossing pairs, listed or not. */
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
 * Reads OFF, OBJ, STL, PLY, glTF or 3MF as it is; polygons only if the file has any. With
 * `attributes: true`, the mesh has the attributes of the file.
 */
export function readMesh(data: FileData, options: ReadOptions&SiblingFiles&{attributes: true}):
    Mesh&{attributes: FoundAttributes};
export function readMesh(
    data: FileData, options?: ReadOptions&SiblingFiles&{attributes?: boolean}): Mesh;
/**
 * Writes 'off', 'obj', 'stl', 'stl-binary', 'ply', 'ply-text', 'glb' or '3mf', with those
 * attributes of the mesh that the format holds.
 */
export function writeMesh(mesh: Mesh, format: MeshFormat): Uint8Array;
/**
 * Writes a mesh as files: the extension of `name` or `format` chooses the format. An OBJ file whose
 * faces have materials has a second one beside it, with the colours (.mtl).
 */
export function writeMeshFiles(
    mesh: Mesh, name: string, options?: {format?: MeshFormat}): Record<string, Uint8Array>;
/** A sentence that names the attributes of a mesh that a format does not hold; '' for none. */
export function lostAttributes(mesh: Mesh, format: MeshFormat): string;
/** What is wrong with a mesh. At most maxListed (1000) crossings are listed. */
export function checkMesh(mesh: Mesh, options?: Options&{maxListed?: number}): MeshReport;
/**
 * Mends a mesh, which loses its attributes. 'automatic' changes as little as possible, and gives
 * null if nothing makes a solid of it. `repair` in the result says what was done; Solid.fromMesh()
 * takes it, and keeps attributes.
 */
export function repairMesh(mesh: Mesh, repair?: Repair|'automatic', options?: Options):
    {mesh: Mesh; report: RepairReport; notes: Note[]; repair: Repair}|null;
/** The Delaunay triangulation of points x, y, x, ...: three indices for each triangle. */
export function delaunay(points: Coordinates, options?: Options): Uint32Array;

export type MeshFormat = 'off'|'off-exact'|'obj'|'stl'|'stl-binary'|'ply'|'ply-text'|'glb'|'3mf';
export type PictureFormat = 'html'|'svg'|'glb'|'png';
/** Winding numbers that are inside. */
export type Rule = 'positive'|'nonzero'|'evenodd';

// ---- objects

/**
 * An object whose memory is outside of JavaScript's. `using`, dispose() or the garbage collector
 * releases it.
 */
export abstract class Handle {
  /** Whether dispose() was called. */
  readonly isDisposed: boolean;
  /**
   * Releases the memory at once. Any other use afterwards throws an error, but a second call does
   * nothing.
   */
  dispose(): void;
  [Symbol.dispose](): void;
}

/** The cell that contains a point. */
export interface Cell<Kind extends string> {
  kind: Kind;
  index: number;
  /** Whether it belongs to the set. */
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
  /** The point of the first set, and that of the second one, exact. */
  points: [Fraction[], Fraction[]];
  /** The cells that have these points. */
  cells: [Cell<Kind>, Cell<Kind>];
}

/** What sets of space, of the plane and of the sphere have in common. All are immutable. */
export abstract class PointSet<Self, Vector, Kind extends string> extends Handle {
  /** Another object with the same set; costs no time. */
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
  /** Whether both have the same points. */
  equals(other: Self): boolean;
  isSubsetOf(other: Self, options?: Options): boolean;
  contains(point: Vector, options?: Options): boolean;
  locate(point: Vector, options?: Options): Cell<Kind>;
  locateAll(points: readonly Vector[]|Float64Array, options?: Options): Cell<Kind>[];
  /** The first cell of the set on a ray; null if there is none. */
  shoot(origin: Vector, direction: Vector, options?: Options): RayHit<Kind>|null;
  /** The first cell of the boundary on a ray, whether it belongs to the set or not. */
  shootToBoundary(origin: Vector, direction: Vector, options?: Options): RayHit<Kind>|null;
  /** Checks every invariant from scratch: the first broken one as a sentence, or null. */
  audit(options?: Options): string|null;
}

/** Which attributes of a mesh its solid keeps: 'colours' are materials and the channel 'color'. */
export type KeptAttributes = 'none'|'colours'|'ids'|'all';
export interface FromMeshOptions extends Options {
  /**
   * By default all attributes that are given, and none of a file. A mesh in arrays with 'all'
   * becomes a source even without attributes, so that faces of results can be traced to its faces.
   */
  keep?: KeptAttributes;
  /** By default the positive winding numbers, after components that are inside out were turned. */
  rule?: Rule;
  /** Whether the set is the union of the faces; the mesh may be open. */
  surface?: boolean;
  /** Whether faces that enclose nothing are the empty set and not an error. */
  mayBeEmpty?: boolean;
  /** How the mesh is mended first. */
  repair?: Repair;
}
export interface FromArraysOptions extends FromMeshOptions {
  /** What belongs to the faces and corners. */
  attributes?: MeshAttributes;
  /** The name of the mesh in Solid.sources(). */
  sourceName?: string;
}
export interface RoundingOptions extends Options {
  /**
   * 'valid' (the default): faces or edges meet only in common ends after rounding. 'nearest': the
   * nearest doubles, even if not.
   */
  rounding?: 'valid'|'nearest';
  onNote?: (note: Note) => void;
}
export interface ToMeshOptions extends RoundingOptions {
  /** Whether coordinates become floats. */
  floats?: boolean;
  /** Whether each cone at a vertex gets a point of its own. */
  splitVertices?: boolean;
}

/**
 * A set of points of space that half-spaces can make: bounded or not, open or closed, with
 * dangling parts or not.
 */
export class Solid extends PointSet<Solid, Vector3, 'vertex'|'edge'|'facet'|'volume'> {
  private constructor();
  static empty(): Solid;
  static whole(): Solid;
  static point(point: Vector3): Solid;
  static points(points: Points3, options?: Options): Solid;
  static unionOf(solids: readonly Solid[], options?: Options): Solid;
  static intersectionOf(solids: readonly Solid[], options?: Options): Solid;
  /** The solid that triangles bound; the mesh may cross itself. An open mesh throws BAD_SHAPE. */
  static fromMesh(vertices: Coordinates, triangles: Indices, options?: FromArraysOptions): Solid;
  static fromPolygons(
      vertices: Coordinates, faceBegin: Indices, corners: Indices,
      options?: FromArraysOptions): Solid;
  /** The points with a x + b y + c z + d <= 0, or < 0. */
  static halfSpace(plane: Vector4, options?: {closed?: boolean}): Solid;
  /** The intersection of half-spaces, of four numbers each. */
  static halfSpaces(planes: Coordinates, options?: Options&{closed?: boolean}): Solid;
  static plane(plane: Vector4): Solid;
  static polyline(points: Points3, options?: Options): Solid;
  /** The closed planar polygon with these corners. */
  static facet(corners: Points3, options?: Options): Solid;
  /** The box between two exact corners. */
  static box(low: Vector3, high: Vector3, options?: Options&{closed?: boolean}): Solid;
  /** A ball of 8 * 4 ** rounds triangles around the origin. */
  static ball(radius: number, rounds?: number): Solid;
  /** A ball whose equator has `chords` corners; convex exactly. */
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
   * The value of an expression such as '(A + B) * !C': + union, * intersection, - difference, ^
   * symmetric difference, ! complement.
   */
  static evaluate(expression: string, solids: Record<string, Solid>, options?: Options): Solid;
  /** Reads OFF, OBJ, STL, PLY, glTF, 3MF or .nef. */
  static read(data: FileData, options?: ReadOptions&FromMeshOptions&SiblingFiles): Solid;
  static fromBytes(data: FileData): Solid;
  /** Reads lines `a b c d closed` or `a b c d open`, and intersects the half-spaces. */
  static readHalfSpaces(data: FileData, options?: ReadOptions): Solid;
  /** Draws several solids, moved apart by `apart` (1) times their distances. */
  static drawMany(solids: readonly Solid[], format: PictureFormat, options?: Options&{
    title?: string;
    apart?: number
  }): Uint8Array;

  /** Meshes have those attributes of the sources that the format holds. */
  write(format: MeshFormat|'nef', options?: RoundingOptions): Uint8Array;
  /**
   * Writes files: the extension of `name` or `format` chooses the format. If sources have
   * materials, an OBJ file has a second one beside it, with the colours (.mtl).
   */
  writeFiles(name: string, options?: RoundingOptions&{format?: MeshFormat | 'nef'}):
      Record<string, Uint8Array>;
  /** The canonical .nef file: equal sets give equal bytes. */
  toBytes(options?: Options): Uint8Array;
  draw(format: PictureFormat, options?: Options&{title?: string}): Uint8Array;
  /** A page that shows the solid and loads nothing. */
  toHtml(options?: Options&{title?: string}): string;
  /** The boundary of a bounded solid; facets[t] is the facet that triangle t is of. */
  toMesh(options?: ToMeshOptions): TriangleMesh&{
    facets: Uint32Array;
    report: ToMeshReport
  };
  toPolygons(options?: ToMeshOptions): PolygonMesh&{
    facets: Uint32Array;
    report: ToMeshReport
  };
  /**
   * The boundary of a bounded solid, valid after rounding, with the attributes of the sources.
   * `pieces`: parts of a facet with the same attributes are one face; or each face lies in one face
   * of a source, or in one triangle of it ('apart').
   */
  toMeshWithAttributes(options?: Options&{
    pieces?: 'same attributes'|'apart'|'same face';
    /** Whether coordinates become floats. */
    floats?: boolean;
  }): TriangleMesh&FaceSources;
  /** Does the same with polygons where parts are planar. */
  toPolygonsWithAttributes(options?: Options&{pieces?: 'same attributes' | 'apart' | 'same face'}):
      PolygonMesh&FaceSources;
  /** The names of the meshes with attributes from which the solid was made. */
  sources(): string[];
  /** The same solid with one source, whose faces lie where the boundary of the solid lies. */
  withSource(mesh: Mesh, name?: string): Solid;
  /** The same set with its cells in the one order that depends on the set alone. */
  canonical(options?: Options): Solid;
  /** Combines the solid with a half-space or a plane. */
  section(plane: Vector4, options?: Options&{
    kind?: 'closed below'|'open below'|'plane';
    operation?: 'union'|'intersection'|'difference'|'symmetricDifference';
  }): Solid;
  /** The image under an affine map: three rows [a, b, c, d], exact. */
  transformed(rows: readonly Vector4[], options?: Options): Solid;
  translated(by: Vector3, options?: Options): Solid;
  /**
   * The rotation is exactly orthogonal, and exact for multiples of 90 degrees about a coordinate
   * axis.
   */
  rotated(axis: readonly[number, number, number], degrees: number, options?: Options): Solid;
  mirrored(normal: Vector3, options?: Options): Solid;
  scaled(factors: Vector3|Exact, options?: Options): Solid;
  /**
   * Scales the bounding box to sizes; 0 keeps an axis, or scales it with the others if it is
   * `automatic`.
   */
  resized(size: Vector3, options?: Options&{automatic?: readonly[boolean, boolean, boolean]}):
      Solid;
  /**
   * The closure grown by a distance, or shrunk by a negative one. An octahedron whose faces are
   * divided `rounds` times, at most 7, stands for the ball; by default 3 times.
   */
  offset(distance: number, options?: Options&{rounds?: number}): Solid;
  minkowskiSum(other: Solid, options?: Options): Solid;
  /** The vectors by which the other solid can be moved so that it lies in this one. */
  minkowskiErosion(other: Solid, options?: Options): Solid;
  /** The convex parts; every point belongs to one of them, or their closures. */
  decompose(options?: Options&{
    method?: 'best'|'cuts'|'walls';
    closed?: boolean
  }): Solid[];
  components(options?: Options): Solid[];
  convexHull(options?: Options): Solid;
  slice(height: Exact, options?: Options): PlaneSet;
  slices(heights: readonly Exact[]|Float64Array, options?: Options): PlaneSet[];
  /** The closure of the projection along the z-axis. */
  shadow(options?: Options): PlaneSet;
  /** 1 for each point x, y, z that belongs to the set, else 0. */
  containsPoints(points: Coordinates, options?: Options): Uint8Array;
  counts():
      {vertices: number; edges: number; facets: number; volumes: number; markedVolumes: number};
  isBounded(): boolean;
  /** Whether the boundary is a 2-manifold. */
  isSimple(): boolean;
  isConvex(): boolean;
  /** `failing`: pairs of a facet and a vertex on its outer side. */
  convexity(options?: Options): {isConvex: boolean; reflexEdges: number; failing: Uint32Array};
  /** The nearest points of the closures; an error (BAD_ARGUMENT) if a set is empty. */
  distance(other: Solid, options?: Options): Distance<'vertex'|'edge'|'facet'|'volume'>;
  /** The exact volume; null if it is infinite. */
  volume(options?: Options): Fraction|null;
  /** The exact centroid; null if the volume is 0 or infinite. */
  centroid(options?: Options): Fraction[]|null;
  /** The area of the boundary, with a relative error below 2 ** -50. */
  surfaceArea(options?: Options): number;
  /** The handles of the boundary; null if it is no closed surface. */
  genus(): number|null;
  boundingBox(): {low: Fraction[]; high: Fraction[]}|null;
}

/**
 * Flat arrays: polygon p has the rings from polygonBegin[p] on, and ring r the corners from
 * ringBegin[r] on.
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

/** A set of points of the plane: polygons, lines and points, each with or without its boundary. */
export class PlaneSet extends PointSet<PlaneSet, Vector2, 'vertex'|'edge'|'face'> {
  private constructor();
  static empty(): PlaneSet;
  static whole(): PlaneSet;
  static point(point: Vector2): PlaneSet;
  static points(points: Points2, options?: Options): PlaneSet;
  static unionOf(sets: readonly PlaneSet[], options?: Options): PlaneSet;
  static intersectionOf(sets: readonly PlaneSet[], options?: Options): PlaneSet;
  /** The points with a x + b y + c <= 0, or < 0. */
  static halfPlane(line: Vector3, options?: {closed?: boolean}): PlaneSet;
  static line(line: Vector3): PlaneSet;
  static box(low: Vector2, high: Vector2, options?: Options&{closed?: boolean}): PlaneSet;
  /** The regular polygon in a circle around the origin. */
  static disk(radius: number, chords?: number, options?: Options): PlaneSet;
  static polygon(points: Points2, options?: Options&{closed?: boolean}): PlaneSet;
  /** What closed chains of doubles bound; by default the odd winding numbers. */
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

  /** `grid`: coordinates become its multiples. */
  write(format: 'wkt'|'wkb'|'geojson'|'dxf'|'nef2', options?: RoundingOptions&{grid?: Exact}):
      Uint8Array;
  /** The .nef2 file, which holds the set exactly. */
  toBytes(options?: Options): Uint8Array;
  toWkt(options?: RoundingOptions&{grid?: Exact}): string;
  toGeoJson(options?: RoundingOptions&{grid?: Exact}): object;
  draw(format: PictureFormat, options?: Options&{title?: string}): Uint8Array;
  toHtml(options?: Options&{title?: string}): string;
  /**
   * The bounded parts of the closure as arrays, with the nearest doubles; rounded() makes them
   * valid first.
   */
  shapes(options?: Options): Shapes;
  /**
   * The closure with coordinates that are doubles, or multiples of a step; edges meet only in
   * common ends.
   */
  rounded(options?: Options&{step?: Exact}): {set: PlaneSet; report: RoundingReport};
  /** Triangles that cover a bounded set, as a mesh with z = 0. */
  triangulated(options?: Options): TriangleMesh;
  /** The image under an affine map: two rows [a, b, c], exact. */
  transformed(rows: readonly Vector3[], options?: Options): PlaneSet;
  translated(by: Vector2, options?: Options): PlaneSet;
  /** Grown by a distance, or shrunk by a negative one. */
  offset(distance: number, options?: Options&{
    join?: 'round'|'mitre'|'square'|'bevel';
    mitreLimit?: number;
    chordError?: number;
    circleSegments?: number;
  }): PlaneSet;
  /**
   * The closure of a bounded set with fewer corners, which are doubles. Corners are removed while
   * their triangle has at most the area `tolerance`, while more than the part `kept` of them is
   * left, and while no point of a border moves farther than `within`.
   */
  simplified(options?: Options&{
    tolerance?: number;
    kept?: number;
    within?: number
  }): PlaneSet;
  minkowskiSum(other: PlaneSet, options?: Options): PlaneSet;
  decompose(options?: Options&{
    method?: 'best'|'cuts'|'diagonals'|'optimal';
    closed?: boolean
  }): PlaneSet[];
  convexHull(options?: Options): PlaneSet;
  extruded(height: number, options?: Options&{
    centred?: boolean;
    /** Degrees by which the top is turned clockwise. */
    twist?: number;
    layers?: number;
    /** The factor, or those of x and y, at the top. */
    scale?: number|readonly[number, number];
  }): Solid;
  /** What the set sweeps around the z-axis; its y-axis becomes the z-axis. */
  revolved(options?: Options&{
    angle?: number;
    steps?: number
  }): Solid;
  containsPoints(points: Coordinates, options?: Options): Uint8Array;
  counts(): {vertices: number; edges: number; faces: number; markedFaces: number};
  isBounded(): boolean;
  isConvex(options?: Options): boolean;
  convexity(options?: Options): {isConvex: boolean; reflexCorners: number; parts: number};
  /** The nearest points of the closures; an error (BAD_ARGUMENT) if a set is empty. */
  distance(other: PlaneSet, options?: Options): Distance<'vertex'|'edge'|'face'>;
  /** The exact area; null if it is infinite. */
  area(options?: Options): Fraction|null;
}

/** A set of directions: vectors, all of whose positive multiples are the same direction. */
export class SphereSet extends PointSet<SphereSet, Vector3, 'point'|'arc'|'face'> {
  private constructor();
  static empty(): SphereSet;
  static whole(): SphereSet;
  static point(direction: Vector3): SphereSet;
  static points(directions: Points3, options?: Options): SphereSet;
  static unionOf(sets: readonly SphereSet[], options?: Options): SphereSet;
  static intersectionOf(sets: readonly SphereSet[], options?: Options): SphereSet;
  static halfSphere(normal: Vector3, options?: Options&{closed?: boolean}): SphereSet;
  /** The intersection of half-spheres. */
  static halfSpheres(normals: Points3, options?: Options&{closed?: boolean}): SphereSet;
  static circle(normal: Vector3): SphereSet;
  /** The region to the left of a closed chain of shortest arcs. */
  static polygon(corners: Points3, options?: {closed?: boolean}): SphereSet;
  static arc(from: Vector3, to: Vector3, options?: {closed?: boolean}): SphereSet;
  counts(): {points: number; arcs: number; faces: number; markedFaces: number};
}

// ---- maps and layers

export interface MapDefect {
  kind: 'duplicate'|'open'|'crossing'|'twin'|'mixed'|'nested';
  cycles: number[];
  /** Pairs of vertices. */
  edges: [number, number][];
  /** The exact place. */
  point: [Fraction, Fraction]|null;
  near: [number, number]|null;
  /** What is wrong and how to correct it. */
  hint: string;
}
/** Half-edges as arrays; the twin of half-edge h is h ^ 1. */
export interface HalfEdges {
  faceCount: number;
  points: Float64Array;
  origin: Uint32Array;
  next: Uint32Array;
  prev: Uint32Array;
  face: Uint32Array;
  /** A half-edge that leaves each vertex; 0xffffffff at isolated ones. */
  leaving: Uint32Array;
}

/** Points, and cycles of indices of points: perhaps a planar subdivision. */
export class Map extends Handle {
  private constructor();
  static fromCycles(points: Points2, cycles: readonly Indices[]): Map;
  static fromArrays(points: Points2, cycleBegin: Indices, corners: Indices): Map;
  /**
   * Reads a map, or polygons of WKT, GeoJSON or WKB; those lack outer boundaries: check({outer:
   * 'infer'}).
   */
  static read(data: FileData, options?: ReadOptions): Map;
  write(): Uint8Array;
  readonly pointCount: number;
  readonly cycleCount: number;
  points(): Float64Array;
  cycles(): number[][];
  /** Decides exactly whether it is a planar subdivision. */
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
  /** For each region the cycles that bound it; region 0 is the unbounded one. */
  regions(): number[][];
  /** The map after vertices were merged and cycles were added. */
  map(): Map;
  /** The union of regions of a valid map. */
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
  /** For each face the region of the first map and that of the second one. */
  regions(): [number, number][];
  /** The exact areas; 0 for unbounded faces. */
  areas(): Fraction[];
  dcel(): HalfEdges;
  write(format: 'text'|'json'|'geojson'|'svg'|'html', options?: RoundingOptions&{title?: string}):
      Uint8Array;
}
export function overlay(first: MapReport, second: MapReport, options?: Options): MapOverlay;

export interface LayerReport {
  /** Whether there are overlaps or gaps. */
  hasDefects: boolean;
  regions: {
    kind: 'overlap'|'gap'|'hole'; area: Fraction;
    /** Twice the area divided by the perimeter. */
    width: number;
    features: number[];
    /** The feature that got the region. */
    owner: number | null;
  }[];
  text: string;
  geoJson: object;
}
/** Features with polygons, ids and properties, such as countries. */
export class Layer extends Handle {
  private constructor();
  /**
   * Reads GeoJSON (also as an object), TopoJSON, WKT or WKB. `object` names an object of TopoJSON.
   */
  static read(data: FileData|{type: string}, options?: ReadOptions&{object?: string}): Layer;
  /** The Voronoi cells of points in a box x, y, x, y. */
  static voronoi(points: Coordinates, box: Coordinates, options?: Options): Layer;
  /** A feature for each bounded face of a set. */
  static ofFaces(set: PlaneSet, options?: Options): Layer;
  /**
   * The parts of a set that come from the features, with their ids and properties. Where several
   * features cover a part, it belongs to the first one. Parts of the set that no feature covers are
   * the last feature, without an id.
   */
  parts(set: PlaneSet, options?: Options): Layer;
  /** These features, and then those of another layer. */
  joined(other: Layer, options?: Options): Layer;
  readonly featureCount: number;
  ids(): unknown[];
  properties(): (Record<string, unknown>|null)[];
  write(format: 'geojson'|'topojson'|'wkt', options?: Options): Uint8Array;
  toGeoJson(options?: Options): object;
  /** An enclosed region that no feature covers is a gap if it is narrower than gapsBelow. */
  check(options?: Options&{gapsBelow?: number}): LayerReport;
  /** The layer without overlaps and gaps. */
  repaired(options?: Options&{
    owner?: 'longest border'|'largest'|'smallest'|'first';
    gapsBelow?: number
  }): {layer: Layer; report: LayerReport};
  /** A feature for each group; null leaves a feature out. */
  dissolved(groups: readonly(number|null)[], options?: Options): Layer;
  /**
   * Fewer corners: those of triangles of at most this area go, while more than the part `kept` of
   * them is left.
   */
  simplified(options?: Options&{
    tolerance?: number;
    kept?: number
  }): Layer;
  /** A feature for each pair of features that have common points. */
  overlaid(other: Layer, options?: Options&{pairs?: 'all' | 'first' | 'both' | 'first only'}):
      {layer: Layer; pairs: [number | null, number|null][]};
}

// ---- surfaces and models

/** A surface of triangles with points and polygons on it. */
export class Scene extends Handle {
  private constructor();
  /** An orientable 2-manifold of triangles. */
  static fromMesh(vertices: Coordinates, triangles: Indices): Scene;
  static read(data: FileData, options?: ReadOptions&SiblingFiles): Scene;
  /** The scene as JSON; `model` is the name of the file of its mesh. */
  write(model: string): Uint8Array;
  readonly polygonCount: number;
  /**
   * Adds the point of a face whose second and third corner have these weights, and returns its
   * index.
   */
  addPoint(face: number, weights: Vector2): number;
  /** Adds the closed polygon of geodesics through points, and returns its index. */
  addPolygon(points: Indices, options?: Options): number;
  /** Adds a shape, the sum of polygons. Without shapes, each polygon is one. */
  addShape(polygons: Indices): number;
  /** Sets the face at whose first corner all labels are 0. */
  setOutside(face: number): void;
  /** Adds loops around handles so that shapes separate the surface; returns how many. */
  separate(options?: Options): number;
  /**
   * A path between two points; null between components. It is a locally shortest path, or with
   * `shortest` a shortest path of all.
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
  /** How often shapes wind around a cell, without zeros. */
  labels(cell: number): {shape: number; value: number}[];
  area(cell: number): number;
  /** Pairs of neighbouring cells. */
  neighbours(): Uint32Array;
  separates(shape: number): {overIntegers: boolean; modulo2: boolean};
  toMesh(options?: Options): TriangleMesh&{cells: Uint32Array};
  /**
   * The cells for which an expression such as 'A * !B' holds; by default the odd labels are
   * inside.
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

/** Evaluates a flattened model of OpenSCAD (.csg); null if it has no geometry. */
export function readCsg(data: FileData, options?: ReadOptions&SiblingFiles): Solid|PlaneSet|null;
