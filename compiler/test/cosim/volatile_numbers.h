#include "ap_int.h"

void volatile_numbers(volatile ap_uint<20>* in, volatile ap_int<9>* out);
