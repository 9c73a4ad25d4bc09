// Objects of the engine as objects of JavaScript.
//
// An object of JavaScript owns one object of the engine. dispose() releases it; if nobody calls
// dispose(), a registry releases it some time after the last reference is gone. The address is
// private to this module, which hands it to the other ones by functions.
import {badArgument, engine, isReady, shown, whenIdle} from './memory.js';

const registry = new FinalizationRegistry(({free, address}) => release(free, address));

// Nothing is left to do where the engine has stopped. A callback may release an object that the
// running operation reads.
function release(free, address) {
  whenIdle(() => {
    if (isReady()) engine()[`_${free}`](address);
  });
}
const wrapped = Symbol('wrapped');

export let addressOf, wrap;

export class Handle {
  #address;

  /** Only the package makes objects; programs call static functions such as Solid.box(). */
  constructor(token, address) {
    if (token !== wrapped)
      throw badArgument(
          `${new.target.name} has no public constructor; its static functions make objects`);
    this.#address = address;
    registry.register(this, {free: new.target.free, address}, this);
  }

  /** Whether dispose() was called. */
  get isDisposed() { return this.#address === 0; }

  /**
   * Releases the memory at once. Any other use afterwards is an error, but a second call does
   * nothing.
   */
  dispose() {
    if (this.#address === 0) return;
    registry.unregister(this);
    release(this.constructor.free, this.#address);
    this.#address = 0;
  }

  static {
    addressOf = (object, Class, what) => {
      if (!(object instanceof Class))
        throw badArgument(`${what} must be a ${Class.name}, not ${shown(object)}`);
      if (object.#address === 0) throw badArgument(`${what} was disposed of`);
      return object.#address;
    };
    wrap = (Class, address) => new Class(wrapped, address);
  }
}

if (Symbol.dispose) Handle.prototype[Symbol.dispose] = Handle.prototype.dispose;

/** The addresses of an array of objects. */
export function addressesOf(frame, objects, Class, what) {
  if (!Array.isArray(objects))
    throw badArgument(`${what} must be an array of ${Class.name}, not ${shown(objects)}`);
  return frame.addresses(objects.map((object, i) => addressOf(object, Class, `${what}[${i}]`)));
}
