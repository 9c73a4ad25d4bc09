/* mini-gmp, compiled so that the module imports nothing: it has no files to write messages to, and it stops by a trap. Its
 * memory is that of exact.cpp. */
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>

#define fprintf(...) ((void)0)
#define abort() __builtin_trap()
#include <mini-gmp.c>
