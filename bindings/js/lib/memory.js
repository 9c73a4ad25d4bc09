// The memory of the WebAssembly module, and calls of the C interface in it.
//
// A Frame holds what one call needs: copies of arrays and texts, places for results, and the
// context. release() frees all of it, so that a call leaves nothing behind but the objects that it
// made. If a callback of the caller throws when they are made, inFrame() releases them, too. Every
// function of the C interface that can fail takes the address of an error as its last parameter;
// Frame.check() passes one and turns an error into an exception.
//
// Structs have the layout of C on wasm32: members follow each other, each at a multiple of its
// size. tests/structs.test.mjs compares the layouts with the header plumb.h.
import {PlumbError} from './error.js';

let module = null;
let failure = null;  // Why the engine cannot be used any more.

/** Makes the instance of the WebAssembly module that all calls use. */
export function setModule(instance) { module = instance; }

/** The instance, or an exception that says how to make it. */
export function engine() {
  if (failure !== null) throw failure;
  if (module === null) {
    throw new PlumbError('NOT_READY', 'plumb is not ready: call and await init() first');
  }
  return module;
}

/** Whether init() has loaded the engine, and it has not stopped. */
export const isReady = () => module !== null && failure === null;

// ---- texts and arrays that come out

/** The text at an address; null for a null pointer. */
export function textAt(address) {
  return address === 0 ? null : engine().UTF8ToString(address >>> 0);
}

/** A copy of numbers that lie at an address. */
export function copyOf(Type, address, count) {
  const heap = engine().HEAPU8;
  if (count === 0) return new Type(0);
  return new Type(
      heap.buffer.slice(address >>> 0, (address >>> 0) + count * Type.BYTES_PER_ELEMENT));
}

/** The value of a constant of an enumeration of C by its name; an exception lists the names. */
export function constant(names, value, what) {
  const index = names.indexOf(value);
  if (index >= 0) return index;
  throw new PlumbError(
      'BAD_ARGUMENT',
      `${what} must be one of ${names.map((name) => `'${name}'`).join(', ')}, not ${shown(value)}`);
}

/** A value as it stands in messages. */
export function shown(value) {
  if (typeof value === 'string') return `'${value}'`;
  if (typeof value === 'bigint') return `${value}n`;
  if (value === null || typeof value !== 'object') return String(value);
  return `an object of ${value.constructor?.name ?? 'no class'}`;
}

export function badArgument(message) { return new PlumbError('BAD_ARGUMENT', message); }

/** A count or index as a number from 0 to 2^32 - 1. */
export function count(value, what) {
  if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return value;
  throw badArgument(`${what} must be an integer from 0 to 4294967295, not ${shown(value)}`);
}

/** A number, perhaps not finite: the engine refuses what it cannot use. */
export function real(value, what) {
  if (typeof value === 'number') return value;
  throw badArgument(`${what} must be a number, not ${shown(value)}`);
}

// ---- structs

const sizes = {
  bool: 1,
  i32: 4,
  u32: 4,
  pointer: 4,
  f64: 8,
  u64: 8
};

/** The layout of a struct of C. The first member is struct_size. */
export class Struct {
  constructor(members) {
    this.members = [];
    let offset = 4, alignment = 4;
    for (const [name, type] of Object.entries(members)) {
      const size = sizes[type];
      offset = Math.ceil(offset / size) * size;
      alignment = Math.max(alignment, size);
      this.members.push({name, type, offset});
      offset += size;
    }
    this.size = Math.ceil(offset / alignment) * alignment;
  }

  write(address, values) {
    const view = new DataView(engine().HEAPU8.buffer, address >>> 0, this.size);
    view.setUint32(0, this.size, true);
    for (const {name, type, offset} of this.members) {
      const value = values[name] ?? 0;
      if (type === 'bool')
        view.setUint8(offset, value ? 1 : 0);
      else if (type === 'f64')
        view.setFloat64(offset, value, true);
      else if (type === 'u64')
        view.setBigUint64(offset, BigInt(value), true);
      else if (type === 'i32')
        view.setInt32(offset, value, true);
      else
        view.setUint32(offset, value, true);
    }
  }

  read(address) {
    const view = new DataView(engine().HEAPU8.buffer, address >>> 0, this.size);
    const values = {};
    for (const {name, type, offset} of this.members) {
      if (type === 'bool')
        values[name] = view.getUint8(offset) !== 0;
      else if (type === 'f64')
        values[name] = view.getFloat64(offset, true);
      else if (type === 'u64')
        values[name] = Number(view.getBigUint64(offset, true));
      else if (type === 'i32')
        values[name] = view.getInt32(offset, true);
      else
        values[name] = view.getUint32(offset, true);
    }
    return values;
  }
}

// ---- calls

export const isWanted = (value) => value !== undefined && value !== null;
let running = null;  // The frame whose operation reports its progress.

/** What the module calls about 20 times a second during an operation with a context. */
export function onProgress(phase, done, total) { running?.report(phase, done, total); }

/** The memory of one call. */
export class Frame {
  #blocks = [];
  #context = 0;
  #options = null;
  #stop = null;  // Why the operation shall stop: {error}, or null.
  #notes = [];   // What onNote of the options will be told.

  /** `options`: {timeout, memoryLimit, onProgress, signal}, or undefined. */
  constructor(options) {
    engine();
    if (isWanted(options)) {
      if (typeof options !== 'object')
        throw badArgument(`options must be an object, not ${shown(options)}`);
      this.#options = options;
    }
  }

  // -- blocks

  /** Reserves bytes, which are zero. */
  block(size) {
    const address = engine()._malloc(Math.max(size, 1)) >>> 0;
    if (address === 0) throw new PlumbError('OUT_OF_MEMORY', 'out of memory');
    this.#blocks.push(address);
    engine().HEAPU8.fill(0, address, address + size);
    return address;
  }

  /**
   * Copies an array of numbers; what is no array of the type is converted, and a value that
   * changes by it is refused.
   */
  numbers(Type, values, what) {
    const array = converted(Type, values, what);
    const address = engine()._malloc(Math.max(array.byteLength, 8)) >>> 0;
    if (address === 0) throw new PlumbError('OUT_OF_MEMORY', 'out of memory');
    this.#blocks.push(address);
    new Type(engine().HEAPU8.buffer, address, array.length).set(array);
    return {address, count: array.length};
  }

  /** Copies records of `width` numbers each. */
  records(Type, values, width, what) {
    const {address, count: length} = this.numbers(Type, values, what);
    if (length % width !== 0)
      throw badArgument(`${what} has ${length} numbers, which is no multiple of ${width}`);
    return {address, count: length / width};
  }

  doubles(values, width, what) { return this.records(Float64Array, values, width, what); }

  /** Copies bytes, or the UTF-8 of a text. */
  bytes(data, what) {
    let bytes = data;
    if (typeof data === 'string')
      bytes = new TextEncoder().encode(data);
    else if (data instanceof ArrayBuffer)
      bytes = new Uint8Array(data);
    else if (ArrayBuffer.isView(data))
      bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    else
      throw badArgument(
          `${what} must be a Uint8Array, an ArrayBuffer or a string, not ${shown(data)}`);
    const address = engine()._malloc(Math.max(bytes.length, 1)) >>> 0;
    if (address === 0) throw new PlumbError('OUT_OF_MEMORY', 'out of memory');
    this.#blocks.push(address);
    engine().HEAPU8.set(bytes, address);
    return {address, count: bytes.length};
  }

  /** Copies a text that ends at its first zero character; null stands for no text. */
  text(value, what) {
    if (!isWanted(value)) return 0;
    if (typeof value !== 'string')
      throw badArgument(`${what} must be a string, not ${shown(value)}`);
    const address = this.block(engine().lengthBytesUTF8(value) + 1);
    engine().stringToUTF8(value, address, engine().lengthBytesUTF8(value) + 1);
    return address;
  }

  /** Copies addresses. */
  addresses(values) { return this.numbers(Uint32Array, Uint32Array.from(values), 'addresses'); }

  struct(layout, values = {}) {
    const address = this.block(layout.size);
    layout.write(address, values);
    return address;
  }

  // -- results

  u32(address) { return engine().HEAPU32[address >>> 2]; }
  flag(address) { return engine().HEAPU8[address] !== 0; }
  f64(address) { return engine().HEAPF64[address >>> 3]; }
  u64(address) {
    return Number(new DataView(engine().HEAPU8.buffer, address, 8).getBigUint64(0, true));
  }

  /** The notes that a function left at an address; they are released. */
  notes(address) { return takeNotes(this.u32(address)); }

  /** Keeps notes of a file for onNote of the options, which finish() calls. */
  tell(notes) { this.#notes.push(...notes); }

  // -- calls

  /** The context for what the options ask for; 0 for nothing. */
  context() {
    const options = this.#options;
    if (this.#context !== 0 || options === null) return this.#context;
    const {timeout, memoryLimit, onProgress: progress, signal} = options;
    if (!isWanted(timeout) && !isWanted(memoryLimit) && !isWanted(progress) && !isWanted(signal))
      return 0;
    if (isWanted(signal) && typeof signal.aborted !== 'boolean')
      throw badArgument(`signal must be an AbortSignal, not ${shown(signal)}`);
    if (isWanted(progress) && typeof progress !== 'function')
      throw badArgument(`onProgress must be a function, not ${shown(progress)}`);
    if (signal?.aborted) throw signal.reason;
    const out = this.block(4);
    this.#call('plumb_context_new', [out]);
    this.#context = this.u32(out);
    if (isWanted(timeout))
      this.#call('plumb_context_set_time_limit', [this.#context, real(timeout, 'timeout')]);
    if (isWanted(memoryLimit))
      this.#call('plumb_context_set_memory_limit', [this.#context, byteCount(memoryLimit)]);
    if (isWanted(progress) || isWanted(signal)) engine()._plumb_js_watch(this.#context);
    return this.#context;
  }

  /** Calls a function that can fail; its last parameter, the error, is added. */
  check(name, ...inputs) {
    const outer = running;
    running = this;
    try {
      this.#call(name, inputs);
    } finally {
      running = outer;
    }
  }

  /**
   * Calls a function whose last parameters are a result, the context and the error, and returns
   * the address of the result.
   */
  make(name, ...inputs) {
    const out = this.block(4);
    this.check(name, ...inputs, out, this.context());
    return this.u32(out);
  }

  /** Does the same for a function without a context. */
  makeBriefly(name, ...inputs) {
    const out = this.block(4);
    this.check(name, ...inputs, out);
    return this.u32(out);
  }

  /**
   * Does the same for a function whose last parameters are a result, notes, the context and the
   * error. Returns both.
   */
  makeWithNotes(name, ...inputs) {
    const out = this.block(4), notes = this.block(4);
    this.check(name, ...inputs, out, notes, this.context());
    return {address: this.u32(out), notes: this.notes(notes)};
  }

  /** What the operation's progress does: the callback of the options, and the request to stop. */
  report(phase, done, total) {
    if (this.#stop !== null) return;
    const {onProgress: progress, signal} = this.#options;
    try {
      progress?.(phase, done, total);
      if (signal?.aborted) this.#stop = {error: signal.reason};
    } catch (error) {
      this.#stop = {error};
    }
    if (this.#stop !== null) engine()._plumb_context_cancel(this.#context);
  }

  /**
   * What is left to do when the results are made: an exception of a progress callback that came
   * too late to stop the operation is thrown, and onNote is told.
   */
  finish() {
    if (this.#stop !== null) throw this.#stop.error;
    const onNote = this.#options?.onNote;
    if (typeof onNote !== 'function') return;
    for (const note of this.#notes) onNote.call(this.#options, note);
  }

  #call(name, inputs) {
    const error = this.block(4);
    const status = statusOf(name, inputs, error);
    if (status === 0) return;
    const failure = takeError(status, this.u32(error));
    if (this.#stop !== null && failure.code === 'CANCELLED') throw this.#stop.error;
    throw failure;
  }

  release() {
    if (!isReady()) return;
    const free = engine()._free;
    if (this.#context !== 0) engine()._plumb_context_free(this.#context);
    for (const address of this.#blocks) free(address);
    this.#blocks = [];
    this.#context = 0;
  }
}

let depth = 0;  // The calls that run: a callback may call again.
const waiting = [];

/** Calls the action when no call runs. */
export function whenIdle(action) {
  if (depth === 0) return action();
  waiting.push(action);
}

/** Calls a function. After a trap, where GMP ends without memory, nothing can be called again. */
function statusOf(name, inputs, error) {
  ++depth;
  try {
    return engine()[`_${name}`](...inputs, error);
  } catch (trap) {
    failure = new PlumbError('INTERNAL', `the engine has stopped: ${trap?.message ?? trap}`);
    throw failure;
  } finally {
    if (--depth === 0) for (const action of waiting.splice(0)) action();
  }
}

/**
 * Runs a body with a frame, and releases the frame. If a callback of the options throws when the
 * result is made, the result is disposed of.
 */
export function inFrame(options, body) {
  const frame = new Frame(options);
  try {
    const result = body(frame);
    try {
      frame.finish();
    } catch (error) {
      disposeOf(result);
      throw error;
    }
    return result;
  } finally {
    frame.release();
  }
}

/** Disposes of the objects of the engine in a result: of itself, or of what its members are. */
function disposeOf(result) {
  if (typeof result !== 'object' || result === null || ArrayBuffer.isView(result)) return;
  if (typeof result.dispose === 'function') return result.dispose();
  Object.values(result).forEach(disposeOf);
}

/** What `read` takes from an object of the engine, which is released even if `read` fails. */
export function taken(object, free, read) {
  try {
    return read(object);
  } finally {
    if (isReady()) engine()[`_${free}`](object);
  }
}

function byteCount(value) {
  if (typeof value === 'bigint' && value >= 0n) return value;
  if (typeof value === 'number' && value >= 0 && Number.isFinite(value))
    return BigInt(Math.floor(value));
  throw badArgument(`memoryLimit must be a number of bytes, not ${shown(value)}`);
}

function converted(Type, values, what) {
  if (values instanceof Type) return values;
  if (typeof values !== 'object' || values === null || typeof values.length !== 'number') {
    throw badArgument(
        `${what} must be a ${Type.name} or an array of numbers, not ${shown(values)}`);
  }
  const result = new Type(values.length);
  for (let i = 0; i < result.length; ++i) {
    const value = values[i];
    result[i] = value;
    if (typeof value !== 'number' || (result[i] !== value && !Number.isNaN(value))) {
      throw badArgument(`${what}[${i}] is ${shown(value)}, which is no ${
          Type === Float64Array ? 'number' : 'index'}`);
    }
  }
  return result;
}

/** The exception of a status and an error object, which is released. */
function takeError(status, error) {
  const name = textAt(engine()._plumb_status_name(status)).toUpperCase().replaceAll(' ', '_');
  if (error === 0) return new PlumbError(name, name.toLowerCase());
  const failure = new PlumbError(name, textAt(engine()._plumb_error_message(error)), {
    text: textAt(engine()._plumb_error_text(error)),
    file: textAt(engine()._plumb_error_file(error)),
    line: engine()._plumb_error_line(error) >>> 0,
    column: engine()._plumb_error_column(error) >>> 0,
  });
  engine()._plumb_error_free(error);
  return failure;
}

/** The texts of notes and which are warnings; the notes are released. */
export function takeNotes(notes) { return taken(notes, 'plumb_notes_free', notesOf); }

export function notesOf(notes) {
  const result = [];
  const length = engine()._plumb_notes_count(notes) >>> 0;
  for (let i = 0; i < length; ++i) {
    result.push({
      text: textAt(engine()._plumb_notes_text(notes, i)),
      isWarning: engine()._plumb_notes_is_warning(notes, i) !== 0
    });
  }
  return result;
}

/** A copy of bytes, which are released. */
export function takeBytes(bytes) {
  return taken(
      bytes, 'plumb_bytes_free',
      () => copyOf(
          Uint8Array, engine()._plumb_bytes_data(bytes), engine()._plumb_bytes_size(bytes) >>> 0));
}

/** A copy of indices, which are released. */
export function takeIndices(indices) {
  return taken(
      indices, 'plumb_indices_free',
      () => copyOf(
          Uint32Array, engine()._plumb_indices_data(indices),
          engine()._plumb_indices_count(indices) >>> 0));
}

export const decode = (bytes) => new TextDecoder().decode(bytes);
