// An array parameter that nothing uses, of a class template that nothing else names.
// top: array_unused
#include "ap_int.h"
int array_unused(const ap_int<23> values[8], int offset) { return offset + 1; }
