// The determinants as one double expression, without any bound: the speed that filters are measured
// against, and wrong near zero.
#pragma once

#include "plumb/predicates/point.h"

namespace plumb::bench {

inline int naive_sign(double det) { return (det > 0) - (det < 0); }

inline int naive_orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return naive_sign((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
}

inline int naive_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double adx = a.x - d.x, ady = a.y - d.y, adz = a.z - d.z;
  const double bdx = b.x - d.x, bdy = b.y - d.y, bdz = b.z - d.z;
  const double cdx = c.x - d.x, cdy = c.y - d.y, cdz = c.z - d.z;
  return naive_sign(adz * (bdx * cdy - cdx * bdy) + bdz * (cdx * ady - adx * cdy) +
                    cdz * (adx * bdy - bdx * ady));
}

inline int naive_incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  return naive_sign((adx * adx + ady * ady) * (bdx * cdy - cdx * bdy) +
                    (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy) +
                    (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady));
}

inline int naive_insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                          const Point3& e) {
  const double aex = a.x - e.x, aey = a.y - e.y, aez = a.z - e.z;
  const double bex = b.x - e.x, bey = b.y - e.y, bez = b.z - e.z;
  const double cex = c.x - e.x, cey = c.y - e.y, cez = c.z - e.z;
  const double dex = d.x - e.x, dey = d.y - e.y, dez = d.z - e.z;
  const double ab = aex * bey - bex * aey, bc = bex * cey - cex * bey;
  const double cd = cex * dey - dex * cey, da = dex * aey - aex * dey;
  const double ac = aex * cey - cex * aey, bd = bex * dey - dex * bey;
  const double abc = aez * bc - bez * ac + cez * ab, bcd = bez * cd - cez * bd + dez * bc;
  const double cda = cez * da + dez * ac + aez * cd, dab = dez * ab + aez * bd + bez * da;
  return naive_sign(
      (dex * dex + dey * dey + dez * dez) * abc - (cex * cex + cey * cey + cez * cez) * dab +
      (bex * bex + bey * bey + bez * bez) * cda - (aex * aex + aey * aey + aez * aez) * bcd);
}

}  // namespace plumb::bench
