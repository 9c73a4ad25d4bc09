// Values in messages between a page and its worker: objects of the engine travel as numbers,
// fractions as texts, and arrays of numbers as they are. Everything else is what structured cloning
// copies.
import {Fraction} from './fraction.js';

const key = '$plumb';

/**
 * A copy of a value in which `mark` has replaced objects: it returns a marker, or undefined for
 * values that stay.
 */
function mapped(value, mark) {
  if (typeof value !== 'object' && typeof value !== 'function') return value;
  if (value === null || ArrayBuffer.isView(value) || value instanceof ArrayBuffer) return value;
  const marker = mark(value);
  if (marker !== undefined) return marker;
  if (Array.isArray(value)) return value.map((element) => mapped(element, mark));
  if (Object.getPrototypeOf(value) !== Object.prototype) return value;
  return Object.fromEntries(
      Object.entries(value).map(([name, member]) => [name, mapped(member, mark)]));
}

/** Encodes a value; `numberOf` gives the number of an object of the engine, or undefined. */
export function encode(value, numberOf) {
  return mapped(value, (object) => {
    if (object instanceof Fraction) return {[key]: 'fraction', text: object.toString()};
    const number = numberOf(object);
    return number === undefined ? undefined : {[key]: 'object', ...number};
  });
}

/** Decodes a value; `objectOf` gives the object of a number. */
export function decodeMessage(value, objectOf) {
  return mapped(value, (object) => {
    if (object[key] === 'fraction') return Fraction.from(object.text);
    return object[key] === 'object' ? objectOf(object) : undefined;
  });
}

/** The buffers of arrays in a value, which can be handed over instead of copied. */
export function buffersOf(value, found = new Set()) {
  if (ArrayBuffer.isView(value))
    found.add(value.buffer);
  else if (typeof value === 'object' && value !== null)
    Object.values(value).forEach((member) => buffersOf(member, found));
  return found;
}
