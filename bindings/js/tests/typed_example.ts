// Compiled by TypeScript in types.test.mjs, never run: the types accept what the documentation
// shows, and refuse what it forbids.
import {
  Fraction,
  init,
  Layer,
  lostAttributes,
  Map,
  type MeshAttributes,
  overlay,
  PlaneSet,
  PlumbError,
  readCsg,
  readMesh,
  Scene,
  Solid,
  SphereSet,
  type ToMeshReport
} from 'plumb';
import {connect, type Remote} from 'plumb/worker';
import {orient2d} from 'plumb/predicates';

await init({wasm: new URL('https://example.org/engine.wasm')});
const box: Solid = Solid.box([0, 0, 0], ['1/3', 1, 10n ** 30n], {closed: false});
const volume: Fraction|null =
    box.union(box.complement(), {timeout: 1, signal: AbortSignal.timeout(5)}).volume();
const {vertices, triangles, report} = box.toMesh({rounding: 'nearest', floats: true});
const moved: number = (report satisfies ToMeshReport).largestMove;
const again =
    Solid.fromMesh(vertices, triangles, {rule: 'nonzero', repair: {weld: 0.1, doubled: 'drop'}});
const outline: PlaneSet = again.slice('1/3').offset(1, {join: 'mitre'});
const near: Fraction[] = box.offset(1, {rounds: 2}).distance(box, {timeout: 1}).points[0];
const flat: 'vertex'|'edge'|'face' = outline.distance(outline).cells[0].kind;
const areas: Fraction[] =
    overlay(Map.read('').check(), Map.fromCycles([[0, 0]], [[0]]).check()).areas();
const kind: 'vertex'|'edge'|'facet'|'volume' = box.locate(new Float64Array(3)).kind;
const owner: number|null =
    Layer.read({type: 'FeatureCollection'}).repaired({owner: 'first'}).report.regions[0].owner;
const model: Solid|PlaneSet|null =
    readCsg('cube();', {name: 'a.csg', files: {'b.stl': new Uint8Array(2)}});
const paint: MeshAttributes = {
  materials: [{name: 'red', color: [1, 0, 0, 1]}, {name: 'plain'}],
  faceMaterial: [0, 1],
  channels: {texcoord_0: {width: 2, values: new Float64Array(12)}},
};
const traced =
    Solid.fromMesh(vertices, triangles, {attributes: paint, sourceName: 'a', keep: 'ids'})
        .toMeshWithAttributes({pieces: 'same face', floats: true, timeout: 1});
const colour: readonly[number, number, number, number]|null = traced.attributes.materials[0].color;
const sourceFaces: Uint32Array = traced.sourceFace;
const lost: string = lostAttributes(traced, 'stl');
const ids: Uint32Array|null = readMesh('', {attributes: true}).attributes.faceId;
const files: Record<string, Uint8Array> = box.writeFiles('a.obj', {rounding: 'nearest'});
const fewer: PlaneSet = outline.simplified({within: 0.1});
const bordersMoved: number = outline.simplifiedWithReport({within: 0.1}).report.bordersMoved;
const scene: number = Scene.fromMesh(vertices, triangles).addPoint(0, ['1/3', 0.5]);
const sphere: boolean = SphereSet.halfSphere([0, 0, 1]).isSubsetOf(SphereSet.whole());
if (box instanceof PlumbError) throw new Error('never');
using disposed = box.copy();

const remote = await connect();
const a: Remote<Solid> = await remote.Solid.ball(1, 3);
const sum: Remote<Solid> =
    await a.union(await a.translated([1, 0, 0]), {onProgress: (phase: string, done: number) => {}});
const exact: Fraction|null = await sum.volume();
const pieces: Remote<Solid>[] = await sum.decompose({closed: true});
const valid: boolean = await (await (await remote.Map.read('')).check()).isValid();
const points: Float64Array = (await sum.toMesh()).vertices;
const channel: Float64Array|undefined =
    (await sum.toMeshWithAttributes()).attributes.channels['place']?.values;
remote.terminate();

// @ts-expect-error: sets of different spaces
box.union(outline);
// @ts-expect-error: sets of different spaces
box.distance(outline);
// @ts-expect-error: no such attributes
Solid.read('', {keep: 'colors'});
// @ts-expect-error: no such rule
Solid.fromMesh(vertices, triangles, {rule: 'odd'});
// @ts-expect-error: objects are made by static functions
new Solid();
// @ts-expect-error: a point of space has three coordinates
box.contains([0, 0]);
// @ts-expect-error: results of a worker are promises
const direct: boolean = a.isEmpty();

export {
  again,
  areas,
  channel,
  colour,
  direct,
  disposed,
  exact,
  bordersMoved,
  fewer,
  files,
  flat,
  ids,
  kind,
  lost,
  model,
  moved,
  near,
  orient2d,
  owner,
  pieces,
  points,
  scene,
  sourceFaces,
  sphere,
  valid,
  volume
};
