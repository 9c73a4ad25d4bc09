/**
 * Exact geometric predicates with the names, parameters and signs of robust-predicates, whose y
 * axis points downwards.
 *
 * The sign of each result is right for all finite doubles: near underflow, near overflow and for
 * any spread of exponents. The magnitude approximates the determinant, as far as the sign allows.
 * If a coordinate is NaN or infinite, the result is NaN. The functions whose names end in `fast`
 * evaluate the determinant in doubles: their sign may be wrong.
 */

/**
 * Positive if c lies to the right of the line from a to b, with the y axis upwards; 0 if the
 * points are collinear.
 */
export function orient2d(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number;

/**
 * For orient2d(a, b, c) < 0: positive if d lies inside the circle of a, b, c, negative outside; 0
 * on it.
 */
export function incircle(
    ax: number, ay: number, bx: number, by: number, cx: number, cy: number, dx: number,
    dy: number): number;

/** Positive if a, b, c appear clockwise from d; 0 if the points are coplanar. */
export function orient3d(
  ax: number, ay: number, az: number, bx: number, by: number, bz: number,
  cx: number, cy: number, cz: number, dx: number, dy: number, dz: number): number;

/**
 * For orient3d(a, b, c, d) > 0: positive if e lies outside the sphere of a, b, c, d, negative
 * inside; 0 on it.
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
