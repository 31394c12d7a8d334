// An array between processes passes on when a run ends, so runs do not overlap.
// top: calls_of_array
#include "hls_stream.h"
static void fill(hls::stream<int>& in, int words[2]) {
#pragma HLS PIPELINE II=2
  words[0] = in.read();
  words[1] = in.read();
}
static void drain(int words[2], hls::stream<int>& out) { out.write(words[0] * words[1]); }
void calls_of_array(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  int words[2];
  fill(in, words);
  drain(words, out);
}
// warning: 4:13: calls of 'fill' do not overlap as PIPELINE asks: 'words' is shared with other processes run by run
