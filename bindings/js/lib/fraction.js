// Exact numbers: fractions of BigInts, and lists of exact numbers in the engine's memory.
import {PlumbError} from './error.js';
import {badArgument, engine, shown, taken, textAt} from './memory.js';

const gcd = (a, b) => {
  while (b !== 0n) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
};

/** A rational number in lowest terms. Immutable. */
export class Fraction {
  /** The greatest common divisor is removed, and the denominator becomes positive. */
  constructor(numerator, denominator = 1n) {
    let p = BigInt(numerator), q = BigInt(denominator);
    if (q === 0n) throw badArgument('the denominator of a fraction is 0');
    const divisor = gcd(p, q) * (q < 0n ? -1n : 1n);
    p /= divisor;
    q /= divisor;
    this.numerator = p;
    this.denominator = q;
    Object.freeze(this);
  }

  /**
   * The exact value of a number, BigInt, fraction, or text such as '1/3', '0.1' (a tenth) or
   * '2.5e-3'.
   */
  static from(value) {
    if (value instanceof Fraction) return value;
    if (typeof value === 'bigint') return new Fraction(value);
    if (typeof value === 'number') return ofDouble(value);
    if (typeof value === 'string') return ofText(value);
    throw badArgument(
        `an exact number is a number, a BigInt, a Fraction or a string, not ${shown(value)}`);
  }

  /** 'p/q', or 'p'. */
  toString() {
    return this.denominator === 1n ? `${this.numerator}` : `${this.numerator}/${this.denominator}`;
  }
  toJSON() { return this.toString(); }

  /** The nearest number; an infinity beyond the largest one. */
  toNumber() { return nearest(this.numerator, this.denominator); }
  valueOf() { return this.toNumber(); }

  /** Whether an exact number has the same value. */
  equals(other) {
    const {numerator, denominator} = Fraction.from(other);
    return this.numerator === numerator && this.denominator === denominator;
  }
}

const bitLength = (n) =>
    (n === 0n ? 0 : n.toString(16).length * 4 - Math.clz32(parseInt(n.toString(16)[0], 16)) + 28);

// A quotient of 64 bits or more, whose last bit says whether anything is left, is rounded once by
// Number(): to nearest, ties to even. A result below the normal numbers is cut to the bits that it
// has before it is rounded.
function nearest(p, q) {
  if (p === 0n) return 0;
  const sign = p < 0n ? -1 : 1;
  if (p < 0n) p = -p;
  let shift = 66 - (bitLength(p) - bitLength(q));  // The quotient has 66 or 67 bits.
  if (shift > 1074 + 2) shift = 1074 + 2;  // Two bits below the last one of subnormal numbers.
  let quotient = shift >= 0 ? (p << BigInt(shift)) / q : p / (q << BigInt(-shift));
  const exact =
      shift >= 0 ? quotient * q === p << BigInt(shift) : quotient * (q << BigInt(-shift)) === p;
  if (shift === 1076) {
    // Multiples of 2^-1074 are what there is below the normal numbers: round to one here.
    const units = quotient >> 2n, rest = (quotient & 3n) * 2n + (exact ? 0n : 1n);
    const rounded = units + (rest > 4n || (rest === 4n && (units & 1n) === 1n) ? 1n : 0n);
    if (bitLength(units) <= 53) return sign * Number(rounded) * 2 ** -1074;
  }
  quotient = (quotient << 1n) | (exact ? 0n : 1n);
  return sign * scaled(Number(quotient), -shift - 1);
}

// x times 2^exponent. Neither step rounds, because x has 53 bits and the result is normal, or is an
// infinity.
function scaled(x, exponent) {
  const half = Math.trunc(exponent / 2);
  return x * 2 ** half * 2 ** (exponent - half);
}

function ofDouble(x) {
  if (!Number.isFinite(x)) throw new PlumbError('NOT_FINITE', `${x} is not finite`);
  if (Number.isInteger(x)) return new Fraction(BigInt(x));
  let q = 1n;
  while (!Number.isInteger(
      x)) {  // Products with powers of 2 are exact, as long as they are below the largest number.
    const step = Math.abs(x) < 1 ? 2 ** 500 : 2 ** 53;
    x *= step;
    q *= BigInt(step);
  }
  return new Fraction(BigInt(x), q);
}

const decimal =
    /^([+-]?)(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d{1,5}))?$|^([+-]?)\.(\d+)(?:[eE]([+-]?\d{1,5}))?$/;
function ofText(text) {
  const quotient = /^\s*([+-]?\d+)\s*\/\s*(\d+)\s*$/.exec(text);
  if (quotient) return new Fraction(BigInt(quotient[1].replace('+', '')), BigInt(quotient[2]));
  const match = decimal.exec(text.trim());
  if (!match) throw new PlumbError('SYNTAX', `'${text}' is no exact number`);
  const sign = (match[1] ?? match[5]) === '-' ? -1n : 1n;
  const whole = match[2] ?? '', part = match[3] ?? match[6] ?? '';
  const exponent = Number(match[4] ?? match[7] ?? 0) - part.length;
  const digits = sign * BigInt(whole + part || '0');
  return exponent >= 0 ? new Fraction(digits * 10n ** BigInt(exponent)) :
                         new Fraction(digits, 10n ** BigInt(-exponent));
}

// ---- lists in the engine's memory

/** Makes a list of exact numbers, which release() of the frame does not know: use withNumbers(). */
function listOf(frame, values) {
  if (values instanceof Float64Array || values.every((value) => typeof value === 'number')) {
    const {address, count} = frame.doubles(values, 1, 'the numbers');
    return frame.makeBriefly('plumb_numbers_from_doubles', address, count);
  }
  const texts = Array.from(values, (value) => frame.text(Fraction.from(value).toString()));
  const {address, count} = frame.addresses(texts);
  return frame.make('plumb_numbers_from_texts', address, count);
}

/**
 * Runs a body with a list of exact numbers, and releases the list. `values` is an array of exact
 * numbers.
 */
export function withNumbers(frame, values, what, body) {
  if (!Array.isArray(values) && !(values instanceof Float64Array)) {
    throw badArgument(`${what} must be an array of exact numbers, not ${shown(values)}`);
  }
  const list = listOf(frame, values);
  try {
    return body(list);
  } finally {
    engine()._plumb_numbers_free(list);
  }
}

/** A point or vector of exactly `width` exact numbers. */
export function vector(values, width, what) {
  if ((Array.isArray(values) || ArrayBuffer.isView(values)) && values.length === width)
    return Array.from(values);
  throw badArgument(`${what} must be an array of ${width} exact numbers, not ${
      Array.isArray(values) ? `of ${values.length}` : shown(values)}`);
}

/** Points of `width` exact numbers each, as one list. */
export function vectors(points, width, what) {
  if (points instanceof Float64Array) {
    if (points.length % width !== 0)
      throw badArgument(`${what} has ${points.length} numbers, which is no multiple of ${width}`);
    return points;
  }
  if (!Array.isArray(points))
    throw badArgument(`${what} must be an array of points, not ${shown(points)}`);
  return points.flatMap((point, i) => vector(point, width, `${what}[${i}]`));
}

/** The fractions of a list, which is released. */
export function takeNumbers(list) {
  return taken(list, 'plumb_numbers_free', () => {
    const length = engine()._plumb_numbers_count(list) >>> 0;
    return Array.from({length}, (_, i) => ofText(textAt(engine()._plumb_numbers_exact(list, i))));
  });
}
