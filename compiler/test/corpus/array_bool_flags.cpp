// An array of bool, fully unrolled access.
// top: array_bool_flags
unsigned array_bool_flags(unsigned a) {
  bool flags[32];  // expect: memory flags none
  for (int i = 0; i < 32; ++i) {  // expect: loop unrolled
#pragma HLS UNROLL
    flags[i] = (a >> i) & 1;
  }
  unsigned reversed = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop unrolled
#pragma HLS UNROLL
    if (flags[i]) reversed |= 1u << (31 - i);
  }
  return reversed;
}
