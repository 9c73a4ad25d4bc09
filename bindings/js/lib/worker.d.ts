import type * as plumb from './index.js';

/**
 * The types of values that are sent to the worker: handles are sent as proxies, all other values
 * unchanged.
 */
type Sent<T> =
    T extends plumb.Handle ? Remote<T>: T extends readonly(infer E)[] ? readonly Sent<E>[] : T;
type Received<T> = T extends plumb.Handle ? Remote<T>: T extends plumb.Fraction|ArrayBufferView ?
    T :
    T extends(infer E)[] ? Received<E>[] :
                           T extends object ? {[Name in keyof T]: Received<T[Name]>} : T;
type Call<T> = T extends(...inputs: infer I) => infer R ?
    (...inputs: {[Name in keyof I]: Sent<I[Name]>}) => Promise<Received<R>>:
    () => Promise<Received<T>>;
/** A proxy of an object in the worker. Its functions and properties are asynchronous functions. */
export type Remote<T> = {
  [Name in Exclude<keyof T, symbol>]: Call<T[Name]>
};
type RemoteClass<C> = {
  [Name in Exclude<keyof C, 'prototype'>]: Call<C[Name]>
};

/** The functions and classes of the package, which run in a worker. */
export interface RemotePlumb {
  Solid: RemoteClass<typeof plumb.Solid>;
  PlaneSet: RemoteClass<typeof plumb.PlaneSet>;
  SphereSet: RemoteClass<typeof plumb.SphereSet>;
  Map: RemoteClass<typeof plumb.Map>;
  Layer: RemoteClass<typeof plumb.Layer>;
  Scene: RemoteClass<typeof plumb.Scene>;
  checkMesh: Call<typeof plumb.checkMesh>;
  delaunay: Call<typeof plumb.delaunay>;
  lostAttributes: Call<typeof plumb.lostAttributes>;
  overlay: Call<typeof plumb.overlay>;
  readCsg: Call<typeof plumb.readCsg>;
  readMesh: Call<typeof plumb.readMesh>;
  repairMesh: Call<typeof plumb.repairMesh>;
  selfTest: Call<typeof plumb.selfTest>;
  version: Call<typeof plumb.version>;
  writeMesh: Call<typeof plumb.writeMesh>;
  writeMeshFiles: Call<typeof plumb.writeMeshFiles>;
  /** Ends the worker at once. The promises of running calls are rejected. */
  terminate(): void;
  [Symbol.dispose](): void;
}

/**
 * Starts a worker, loads the engine there, and returns the package in the worker. If `worker` is
 * given, this worker is used, which must run plumb/worker-entry.
 */
export function connect(
    options?: {wasm?: string|URL|ArrayBuffer|Uint8Array|WebAssembly.Module; worker?: Worker;}):
    Promise<RemotePlumb>;
