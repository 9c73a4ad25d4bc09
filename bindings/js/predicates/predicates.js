// Predicates on points of doubles, with the names, parameters and signs of robust-predicates.
//
// Each predicate evaluates the determinant in doubles, and with it a bound of what rounding,
// underflow and overflow can have changed. If the bound cannot rule out a wrong sign, the exact
// stages decide, which are compiled to WebAssembly (exact.cpp). The filters are those of
// plumb/predicates/input/input_filters.h, where their constants are proved. JavaScript rounds to
// nearest and has subnormal numbers, so differences never underflow.
//
// Signs: robust-predicates has its y axis point downwards. So the signs of orient2d and insphere
// are opposite to those in C++, and those of orient3d and incircle are the same.
import encoded from './predicates.wasm.js';

const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
const {instance} = await WebAssembly.instantiate(bytes);
const exact = instance.exports;

const epsilon = 2 ** -52;
const orient2dError = 4 * epsilon, orient2dGate = 2 ** 340, orient2dFloor = 2 ** -675;
const orient3dError = 8 * epsilon, orient3dGate = 2 ** 200, orient3dFloor = 2 ** -612;
const incircleError = 12 * epsilon, incircleGate = 2 ** 287, incircleFloor = 2 ** -578;
const insphereError = 18 * epsilon, insphereGate = 2 ** 223, insphereFloor = 2 ** -560;

const abs = Math.abs;

// The determinant in doubles if it has the given sign, else the smallest number that has it.
function withDeterminant(det, sign) {
  if (sign === 0) return 0;
  const magnitude = sign * det;
  return magnitude > 0 && magnitude < Infinity ? det : sign * Number.MIN_VALUE;
}

// The exact stages of each predicate are called in functions of their own. Without them the
// exported functions are so small that engines compile them into their callers, which passes
// coordinates without boxes. A number times 0 is 0 if the number is finite, and NaN otherwise.

function orient2dBeyondFilter(det, ax, ay, bx, by, cx, cy) {
  if (ax * 0 + ay * 0 + bx * 0 + by * 0 + cx * 0 + cy * 0 !== 0) return NaN;
  return withDeterminant(det, -exact.orient2d(ax, ay, bx, by, cx, cy));
}

function incircleBeyondFilter(det, ax, ay, bx, by, cx, cy, dx, dy) {
  if (ax * 0 + ay * 0 + bx * 0 + by * 0 + cx * 0 + cy * 0 + dx * 0 + dy * 0 !== 0) return NaN;
  return withDeterminant(det, exact.incircle(ax, ay, bx, by, cx, cy, dx, dy));
}

function orient3dBeyondFilter(det, ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz) {
  const zero = ax * 0 + ay * 0 + az * 0 + bx * 0 + by * 0 + bz * 0 + cx * 0 + cy * 0 + cz * 0 +
      dx * 0 + dy * 0 + dz * 0;
  if (zero !== 0) return NaN;
  return withDeterminant(det, exact.orient3d(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz));
}

function insphereBeyondFilter(det, ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) {
  const zero = ax * 0 + ay * 0 + az * 0 + bx * 0 + by * 0 + bz * 0 + cx * 0 + cy * 0 + cz * 0 +
      dx * 0 + dy * 0 + dz * 0 + ex * 0 + ey * 0 + ez * 0;
  if (zero !== 0) return NaN;
  return withDeterminant(
      det, -exact.insphere(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez));
}

export function orient2d(ax, ay, bx, by, cx, cy) {
  const acx = ax - cx, acy = ay - cy, bcx = bx - cx, bcy = by - cy;
  const left = acy * bcx, right = acx * bcy;
  const det = left - right;
  if (abs(acx) + abs(bcy) + (abs(acy) + abs(bcx)) <= orient2dGate &&
      abs(det) > orient2dError * (abs(left) + abs(right)) + orient2dFloor) {
    return det;
  }
  return orient2dBeyondFilter(det, ax, ay, bx, by, cx, cy);
}

export function incircle(ax, ay, bx, by, cx, cy, dx, dy) {
  const adx = ax - dx, ady = ay - dy, bdx = bx - dx, bdy = by - dy, cdx = cx - dx, cdy = cy - dy;
  const bc = bdx * cdy, cb = cdx * bdy;
  const ca = cdx * ady, ac = adx * cdy;
  const ab = adx * bdy, ba = bdx * ady;
  const aLift = adx * adx + ady * ady;
  const bLift = bdx * bdx + bdy * bdy;
  const cLift = cdx * cdx + cdy * cdy;
  const det = aLift * (bc - cb) + bLift * (ca - ac) + cLift * (ab - ba);
  if (aLift <= incircleGate && bLift <= incircleGate && cLift <= incircleGate) {
    const permanent = aLift * (abs(bc) + abs(cb)) + bLift * (abs(ca) + abs(ac)) +
        cLift * (abs(ab) + abs(ba));
    if (abs(det) > incircleError * permanent + incircleFloor) return det;
  }
  return incircleBeyondFilter(det, ax, ay, bx, by, cx, cy, dx, dy);
}

export function orient3d(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz) {
  const adx = ax - dx, ady = ay - dy, adz = az - dz;
  const bdx = bx - dx, bdy = by - dy, bdz = bz - dz;
  const cdx = cx - dx, cdy = cy - dy, cdz = cz - dz;
  const bc = bdx * cdy, cb = cdx * bdy;
  const ca = cdx * ady, ac = adx * cdy;
  const ab = adx * bdy, ba = bdx * ady;
  const det = adz * (bc - cb) + bdz * (ca - ac) + cdz * (ab - ba);
  const permanent = abs(adz) * (abs(bc) + abs(cb)) + abs(bdz) * (abs(ca) + abs(ac)) +
      abs(cdz) * (abs(ab) + abs(ba));
  // A product that underflows is off by 2^-1075, times at most 2^200: far below the floor. One that
  // overflows, or a difference that does, makes the permanent infinite or NaN.
  const reach = abs(adz) + abs(bdz) + abs(cdz);
  if (reach <= orient3dGate && abs(det) > orient3dError * permanent + orient3dFloor) return det;
  return orient3dBeyondFilter(det, ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz);
}

export function insphere(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) {
  const aex = ax - ex, aey = ay - ey, aez = az - ez;
  const bex = bx - ex, bey = by - ey, bez = bz - ez;
  const cex = cx - ex, cey = cy - ey, cez = cz - ez;
  const dex = dx - ex, dey = dy - ey, dez = dz - ez;
  const ab1 = aex * bey, ab2 = bex * aey, ab = ab1 - ab2;
  const bc1 = bex * cey, bc2 = cex * bey, bc = bc1 - bc2;
  const cd1 = cex * dey, cd2 = dex * cey, cd = cd1 - cd2;
  const ad1 = aex * dey, ad2 = dex * aey, ad = ad1 - ad2;
  const ac1 = aex * cey, ac2 = cex * aey, ac = ac1 - ac2;
  const bd1 = bex * dey, bd2 = dex * bey, bd = bd1 - bd2;
  const abc = aez * bc - bez * ac + cez * ab;
  const bcd = bez * cd - cez * bd + dez * bc;
  const abd = aez * bd - bez * ad + dez * ab;
  const acd = aez * cd - cez * ad + dez * ac;
  const aLift = aex * aex + aey * aey + aez * aez;
  const bLift = bex * bex + bey * bey + bez * bez;
  const cLift = cex * cex + cey * cey + cez * cez;
  const dLift = dex * dex + dey * dey + dez * dez;
  const det = (cLift * abd - dLift * abc) + (aLift * bcd - bLift * acd);
  if (aLift <= insphereGate && bLift <= insphereGate && cLift <= insphereGate &&
      dLift <= insphereGate) {
    const a = abs(aez), b = abs(bez), c = abs(cez), d = abs(dez);
    const abSize = abs(ab1) + abs(ab2), bcSize = abs(bc1) + abs(bc2);
    const cdSize = abs(cd1) + abs(cd2), adSize = abs(ad1) + abs(ad2);
    const acSize = abs(ac1) + abs(ac2), bdSize = abs(bd1) + abs(bd2);
    const permanent = (dLift * (a * bcSize + b * acSize + c * abSize) +
        cLift * (a * bdSize + b * adSize + d * abSize)) +
        (bLift * (a * cdSize + c * adSize + d * acSize) +
        aLift * (b * cdSize + c * bdSize + d * bcSize));
    if (abs(det) > insphereError * permanent + insphereFloor) return det;
  }
  return insphereBeyondFilter(det, ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez);
}

export function orient2dfast(ax, ay, bx, by, cx, cy) {
  return (ay - cy) * (bx - cx) - (ax - cx) * (by - cy);
}

export function incirclefast(ax, ay, bx, by, cx, cy, dx, dy) {
  const adx = ax - dx, ady = ay - dy, bdx = bx - dx, bdy = by - dy, cdx = cx - dx, cdy = cy - dy;
  return (adx * adx + ady * ady) * (bdx * cdy - cdx * bdy) +
      (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy) +
      (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady);
}

export function orient3dfast(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz) {
  const adx = ax - dx, ady = ay - dy, bdx = bx - dx, bdy = by - dy, cdx = cx - dx, cdy = cy - dy;
  return (az - dz) * (bdx * cdy - cdx * bdy) + (bz - dz) * (cdx * ady - adx * cdy) +
      (cz - dz) * (adx * bdy - bdx * ady);
}

export function inspherefast(ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz, ex, ey, ez) {
  const aex = ax - ex, aey = ay - ey, aez = az - ez;
  const bex = bx - ex, bey = by - ey, bez = bz - ez;
  const cex = cx - ex, cey = cy - ey, cez = cz - ez;
  const dex = dx - ex, dey = dy - ey, dez = dz - ez;
  const ab = aex * bey - bex * aey, bc = bex * cey - cex * bey, cd = cex * dey - dex * cey;
  const ad = aex * dey - dex * aey, ac = aex * cey - cex * aey, bd = bex * dey - dex * bey;
  const abc = aez * bc - bez * ac + cez * ab, bcd = bez * cd - cez * bd + dez * bc;
  const abd = aez * bd - bez * ad + dez * ab, acd = aez * cd - cez * ad + dez * ac;
  return ((cex * cex + cey * cey + cez * cez) * abd - (dex * dex + dey * dey + dez * dez) * abc) +
      ((aex * aex + aey * aey + aez * aez) * bcd - (bex * bex + bey * bey + bez * bez) * acd);
}
