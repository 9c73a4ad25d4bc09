// The package: loads the engine, and names what there is.
import createEngine from './engine.js';
import {PlumbError} from './error.js';
import {engine, inFrame, isReady, onProgress, setModule, textAt} from './memory.js';

export {readCsg} from './csg.js';
export {PlumbError} from './error.js';
export {Fraction} from './fraction.js';
export {Handle} from './handle.js';
export {Layer} from './layer.js';
export {Map, MapOverlay, MapReport, overlay} from './map.js';
export {PlaneSet} from './plane_set.js';
export {PointSet} from './sets.js';
export {
  checkMesh,
  delaunay,
  lostAttributes,
  readMesh,
  repairMesh,
  Solid,
  writeMesh,
  writeMeshFiles
} from './solid.js';
export {SphereSet} from './sphere_set.js';
export {Scene, SurfaceDivision, SurfaceRegion} from './surface.js';

let loading = null;

/**
 * Loads the engine; later calls wait for the same load. `wasm`: the address, bytes or module of
 * engine.wasm if it lies elsewhere.
 */
export function init({wasm} = {}) {
  loading ??= load(wasm).catch((error) => {
    loading = null;  // A later call may succeed.
    throw error;
  });
  return loading;
}

async function load(wasm) {
  const settings = {onProgress};
  let failed = null;  // A promise that a failure rejects.
  if (wasm instanceof WebAssembly.Module) {
    failed = new Promise((_, reject) => {
      settings.instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then((made) => done(made, wasm)).catch(reject);
        return {};
      };
    });
  } else if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm)) {
    settings.wasmBinary = wasm;
  } else {
    settings.wasmBinary = await bytesAt(wasm ?? new URL('engine.wasm', import.meta.url));
  }
  const loaded = createEngine(settings);
  setModule(await (failed === null ? loaded : Promise.race([failed, loaded])));
}

async function bytesAt(address) {
  const url = new URL(address, import.meta.url);
  if (url.protocol === 'file:' && typeof process === 'object') {
    const {readFile} = await import('node:fs/promises');
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok)
    throw new PlumbError('CANNOT_OPEN', `${url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** The version of the library, such as '0.1.0'. */
export function version() { return textAt(engine()._plumb_version()); }

/** Whether the arithmetic is what exact predicates need, and what is wrong or unusual. */
export function selfTest() {
  return inFrame(undefined, (frame) => {
    const isOk = frame.block(1), notes = frame.block(4);
    frame.check('plumb_self_test', isOk, notes);
    return {isOk: frame.flag(isOk), notes: frame.notes(notes)};
  });
}

export {isReady};
