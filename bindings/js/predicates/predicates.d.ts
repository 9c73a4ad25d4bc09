/**
 * Exact geometric predicates. Their names, parameters and signs are those of the package
 * robust-predicates, in which the y axis points downwards.
 *
 * The sign of each result is right for all finite doubles: near underflow, near overflow and for
 * any spread of exponents. The magnitude of a result approximates the determinant. If a coordinate
 * is NaN or infinite, the result is NaN. The functions whose names end in `fast` evaluate the
 * determinant in doubles, so their signs may be wrong.
 */

/**
 * Returns a positive number if c lies to the right of the line from a to b, where the y axis points
 * upwards. Returns a negative number if c lies to the left of this line, and 0 if the points are
 * collinear.
 */
export function orient2d(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;

/**
 * Suppose that orient2d(a, b, c) < 0. Then the result is positive if the point d lies inside the
 * circle of a, b, c. It is negative if d lies outside the circle, and 0 if d lies on the circle.
 */
export function incircle(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number,
    dy: number): number;

/**
 * Returns a positive number if a, b, c appear clockwise from d, a negative number if they appear
 * counter-clockwise, and 0 if the points are coplanar.
 */
export function orient3d(
  ax: number, ay: number, az: number, bx: number, by: number, bz: number,
  cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;

/**
 * Suppose that orient3d(a, b, c, d) > 0. Then the result is positive if the point e lies outside
 * the sphere of a, b, c, d. It is negative if e lies inside the sphere, and 0 if e lies on the
 * sphere.
 */
export function insphere(
  ax: number, ay: number, az: number, bx: number, by: number, bz: number,
  cx: number, cy: number, cz: number, dx: number, dy: number, dz: number,
  ex: number, ey: number, ez: number): number;

/** orient2d in doubles: its sign may be wrong. */
export function orient2dfast(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;

/** incircle in doubles: its sign may be wrong. */
export function incirclefast(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number,
    dy: number): number;

/** orient3d in doubles: its sign may be wrong. */
export function orient3dfast(
  ax: number, ay: number, az: number, bx: number, by: number, bz: number,
  cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;

/** insphere in doubles: its sign may be wrong. */
export function inspherefast(
  ax: number, ay: number, az: number, bx: number, by: number, bz: number,
  cx: number, cy: number, cz: number, dx: number, dy: number, dz: number,
  ex: number, ey: number, ez: number): number;
