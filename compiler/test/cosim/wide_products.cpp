// Products of more bits than a multiplier block of ECP5 takes: each kind of sign, one wide factor and two,
// and a result that keeps only low bits.
#include <ap_int.h>

#include "hls_stream.h"

void wide_products(hls::stream<ap_int<64> >& in, hls::stream<ap_int<64> >& out) {
  for (int i = 0; i < 200; ++i) {
#pragma HLS PIPELINE II = 5
    const ap_int<64> a = in.read(), b = in.read();
    const ap_int<40> signed_wide = a;
    const ap_uint<37> unsigned_wide = a;
    const ap_int<27> signed_other = b;
    const ap_uint<19> unsigned_other = b;
    out.write(signed_wide * signed_other);
    out.write(signed_wide * unsigned_other);
    out.write(unsigned_wide * signed_other);
    out.write(unsigned_wide * unsigned_other);
    out.write(ap_int<32>(a * b));
  }
}
