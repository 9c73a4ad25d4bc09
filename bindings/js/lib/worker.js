// The engine in a worker, so that a page stays responsive: `const plumb = await connect()`.
//
// Classes and functions of the package are there under their names, and return promises. Objects of
// the engine stay in the worker; a page has proxies of them, whose members are asynchronous
// functions, properties included. The worker does one call after the other. If a signal is aborted,
// its promise is rejected at once. The operation stops, too, where memory can be shared (in Node,
// and on pages that are cross-origin isolated); elsewhere it ends in the worker, and its result is
// released.
import {PlumbError} from './error.js';
import {buffersOf, decodeMessage, encode} from './messages.js';

const classes = ['Solid', 'PlaneSet', 'SphereSet', 'Map', 'Layer', 'Scene'];
const functions = [
  'checkMesh', 'delaunay', 'lostAttributes', 'overlay', 'readCsg', 'readMesh', 'repairMesh',
  'selfTest', 'version', 'writeMesh', 'writeMeshFiles'
];
const numbers = new WeakMap();  // The number of each proxy, and the connection that it belongs to.

/**
 * Starts a worker, loads the engine there, and returns what it offers. `wasm` as in init();
 * `worker`: a worker of one's own.
 */
export async function connect({wasm, worker} = {}) {
  const connection = new Connection(worker ?? await startWorker());
  try {
    await connection.call(null, 'init', [{wasm: wasm instanceof URL ? wasm.href : wasm}]);
  } catch (error) {
    if (worker === undefined) connection.terminate();
    throw error;
  }
  const offered = {terminate: () => connection.terminate()};
  for (const name of classes) offered[name] = membersOf(connection, name);
  for (const name of functions) offered[name] = (...inputs) => connection.call(null, name, inputs);
  if (Symbol.dispose) offered[Symbol.dispose] = offered.terminate;
  return offered;
}

async function startWorker() {
  if (typeof Worker === 'function')
    return new Worker(new URL('./worker_entry.js', import.meta.url), {type: 'module'});
  const threads = await import('node:worker_threads');
  return new threads.Worker(new URL('./worker_entry.js', import.meta.url));
}

class Connection {
  #worker;
  #pending = new globalThis.Map();
  #last = 0;
  #ended = false;
  #registry = new FinalizationRegistry((number) => {
    if (!this.#ended) this.#post({id: 0, target: number, member: 'dispose', inputs: []});
  });

  constructor(worker) {
    this.#worker = worker;
    const receive = (message) => this.#receive(message);
    const fail = (error) =>
        this.#end(new PlumbError('INTERNAL', `the worker failed: ${error?.message ?? error}`));
    if (typeof worker.addEventListener === 'function') {
      worker.addEventListener('message', ({data}) => receive(data));
      worker.addEventListener('error', fail);
    } else {
      worker.on('message', receive);
      worker.on('error', fail);
      worker.on('exit', () => this.#end(new PlumbError('CANCELLED', 'the worker has ended')));
      worker.unref();
    }
  }

  /**
   * Calls a member of a class (by its name), of an object (by its number) or of the package
   * (null).
   */
  call(target, member, inputs) {
    if (this.#ended) return Promise.reject(new PlumbError('CANCELLED', 'the worker has ended'));
    return new Promise((resolve, reject) => {
      const {plain, callbacks} = withoutCallbacks(inputs);
      const {signal} = callbacks;
      if (signal?.aborted) return reject(signal.reason);
      const canStop = signal || callbacks.onProgress || callbacks.onNote;
      const stop = canStop && typeof SharedArrayBuffer === 'function' ?
          new Int32Array(new SharedArrayBuffer(4)) :
          null;
      const id = ++this.#last;
      // The worker ends the call before its number is forgotten.
      const fail = (error) => {
        if (stop !== null) Atomics.store(stop, 0, 1);
        settle();
        this.#pending.set(id, {...this.#pending.get(id), isAbandoned: true});
        reject(error);
      };
      const abort = () => fail(signal.reason);
      const settle = () => signal?.removeEventListener('abort', abort);
      signal?.addEventListener('abort', abort, {once: true});
      this.#pending.set(id, {resolve, reject, settle, fail, callbacks, isAbandoned: false});
      this.#hold();
      try {
        this.#post({
          id,
          target,
          member,
          stop,
          inputs: encode(plain, (object) => this.#numberOf(object)),
          reports: typeof callbacks.onProgress === 'function',
          notes: typeof callbacks.onNote === 'function',
        });
      } catch (error) {
        settle();
        this.#pending.delete(id);
        this.#hold();
        reject(error);
      }
    });
  }

  terminate() {
    this.#worker.terminate();
    this.#end(new PlumbError('CANCELLED', 'the worker has ended'));
  }

  #post(message) { this.#worker.postMessage(message); }

  // In Node, the worker keeps the process alive as long as there are calls.
  #hold() {
    if (this.#pending.size > 0)
      this.#worker.ref?.();
    else
      this.#worker.unref?.();
  }

  #receive({id, progress, note, value, error}) {
    const call = this.#pending.get(id);
    if (call === undefined) return;
    if (progress !== undefined || note !== undefined) {
      if (call.isAbandoned) return;
      try {
        if (progress !== undefined) call.callbacks.onProgress(...progress);
        if (note !== undefined) call.callbacks.onNote(note);
      } catch (error) {
        call.fail(error);
      }
      return;
    }
    this.#pending.delete(id);
    this.#hold();
    call.settle();
    if (error !== undefined) return call.reject(errorOf(error));
    call.resolve(decodeMessage(
        value,
        ({number}) => this.#proxy(number)));  // An abandoned result is released with its proxies.
  }

  #end(error) {
    this.#ended = true;
    for (const {reject, settle} of this.#pending.values()) {
      settle();
      reject(error);
    }
    this.#pending.clear();
    this.#hold();
  }

  #proxy(number) {
    const proxy = membersOf(this, number);
    numbers.set(proxy, {number, connection: this});
    this.#registry.register(proxy, number);
    return proxy;
  }

  #numberOf(object) {
    const known = numbers.get(object);
    if (known === undefined) return undefined;
    if (known.connection !== this)
      throw new PlumbError('BAD_ARGUMENT', 'an object belongs to another worker');
    return {number: known.number};
  }
}

/** What looks like a class or an object, and calls it in the worker. */
function membersOf(connection, target) {
  return new Proxy(Object.freeze({}), {
    get(_, member) {
      // A promise that is resolved by an object asks for its `then`.
      if (typeof member === 'symbol' || member === 'then') {
        return Symbol.dispose && member === Symbol.dispose ?
            () => void connection.call(target, 'dispose', []) :
            undefined;
      }
      return (...inputs) => connection.call(target, member, inputs);
    },
  });
}

/**
 * The inputs without the functions and the signal of their options, which cannot travel. The last
 * input may be another plain object, such as the operands of an expression, whose names are free; a
 * proxy answers every name with a function.
 */
function withoutCallbacks(inputs) {
  const options = inputs.at(-1);
  if (typeof options !== 'object' || options === null || numbers.has(options) ||
      Object.getPrototypeOf(options) !== Object.prototype) {
    return {plain: inputs, callbacks: {}};
  }
  const rest = {...options}, callbacks = {};
  const take = (name, isCallback) => {
    if (numbers.has(rest[name]) || !isCallback(rest[name])) return;
    callbacks[name] = rest[name];
    delete rest[name];
  };
  take('signal', (value) => typeof value?.addEventListener === 'function');
  take('onProgress', (value) => typeof value === 'function');
  take('onNote', (value) => typeof value === 'function');
  return {plain: [...inputs.slice(0, -1), rest], callbacks};
}

function errorOf({name, code, reason, message, file, line, column}) {
  if (name === 'PlumbError')
    return new PlumbError(code, reason, {text: message, file, line, column});
  return Object.assign(new Error(message), {name});
}

/**
 * Serves calls in a worker: worker_entry.js, or a worker of one's own, with the package and a
 * function that posts messages.
 */
export function serve(plumb, post) {
  const objects = new globalThis.Map();
  let last = 0;
  const isObject = (value) => typeof value.dispose === 'function';
  const numberOf = (value) => {
    if (!isObject(value)) return undefined;
    objects.set(++last, value);
    return {number: last};
  };
  const targetOf = (target) => {
    if (target === null) return plumb;
    const found = typeof target === 'string' ? plumb[target] : objects.get(target);
    if (found === undefined) throw new PlumbError('BAD_ARGUMENT', 'the object was disposed of');
    return found;
  };
  return async ({id, target, member, inputs, stop, reports, notes}) => {
    try {
      if (member === 'dispose') {
        objects.get(target)?.dispose();
        objects.delete(target);
        return id === 0 ? undefined : post({id, value: undefined});
      }
      const plain = decodeMessage(inputs, ({number}) => targetOf(number));
      const options = plain.at(-1);
      if (stop !== null && stop !== undefined) {
        const reason = new PlumbError('CANCELLED', 'cancelled');
        options.signal = {get aborted() { return Atomics.load(stop, 0) !== 0; }, reason};
      }
      if (reports) options.onProgress = (...progress) => post({id, progress});
      if (notes) options.onNote = (note) => post({id, note});
      const owner = targetOf(target), found = owner[member];
      if (found === undefined)
        throw new PlumbError('BAD_ARGUMENT', `there is no ${String(member)}`);
      const value =
          encode(await (typeof found === 'function' ? found.apply(owner, plain) : found), numberOf);
      post({id, value}, [...buffersOf(value)]);
    } catch (error) {
      const {name, code, reason, message, file, line, column} = error;
      post({id, error: {name, code, reason, message, file, line, column}});
    }
  };
}
