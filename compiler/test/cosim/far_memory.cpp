// A memory that spans several blocks on ECP5, so that a read takes six cycles: read right after the loop that
// writes it, by a loop that stalls, by one that leaves before its last reads are there, and between loops.
#include <ap_int.h>

#include "hls_stream.h"

const int WORDS = 40000;
const int STEP = 911;  // has no factor of WORDS: neighbours lie in different blocks

inline ap_uint<16> behind(ap_uint<16> at) {
  const ap_uint<17> next = at + STEP;
  if (next >= WORDS) return next - WORDS;
  return next;
}

void far_memory(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<16> >& out, ap_uint<8> wanted) {
  static ap_uint<8> words[WORDS];
  ap_uint<16> at = 0;
FILL:
  for (int i = 0; i < 600; ++i) {
#pragma HLS PIPELINE II = 1
    words[at] = in.read();
    at = behind(at);
  }
  out.write(words[at]);
  at = 0;
COPY:
  for (int i = 0; i < 600; ++i) {
#pragma HLS PIPELINE II = 1
    out.write(words[at]);
    at = behind(at);
  }
  at = 0;
SEEK:
  while (words[at] != wanted) {
#pragma HLS PIPELINE
    at = behind(at);
  }
  out.write(at);
  out.write(words[at + 1]);
}
