/* The numbers of GMP for WebAssembly: mini-gmp, a file that GMP's sources contain, with limbs of 64 bits. The predicates need
 * products and sums of integers alone, for which it does as well as GMP. */
#ifndef PLUMB_JS_GMP_H
#define PLUMB_JS_GMP_H

#define MINI_GMP_LIMB_TYPE long long
#include <mini-gmp.h>
#include <mini-mpq.h>

#define GMP_NUMB_BITS 64
#define GMP_NUMB_MASK (~(mp_limb_t)0)
#define __GNU_MP_VERSION 6
#define __GNU_MP_VERSION_MINOR 2

#endif
