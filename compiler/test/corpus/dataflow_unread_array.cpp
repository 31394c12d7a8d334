// An array between two processes of which the second one takes no word that counts.
// top: dataflow_unread_array
#include "hls_stream.h"
static void fill(hls::stream<int>& in, int buffer[8]) {
  for (int i = 0; i < 8; ++i) buffer[i] = in.read() * 3;
}
static void answer(const int buffer[8], hls::stream<int>& out, int gain) {
  for (int i = 0; i < 8; ++i) {
    int unused = buffer[i];
    out.write(gain + i + (unused & 0));
  }
}
void dataflow_unread_array(hls::stream<int>& in, hls::stream<int>& out, int gain) {
#pragma HLS DATAFLOW
  int buffer[8];
  fill(in, buffer);
  answer(buffer, out, gain);
}
