// The checks of the C interface, compiled as C++: the header works in both languages.
#include "interface_test.c"
