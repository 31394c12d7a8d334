// A static stream of one function keeps its elements from call to call.
// top: stream_queue_static
#include "hls_stream.h"
struct Sample {
  short value;
  bool is_late;
};
int stream_queue_static(short value) {
  static bool is_primed = false;
  static hls::stream<Sample> waiting;
#pragma HLS STREAM variable=waiting depth=4
  Sample sample = {value, value > 100};
  waiting.write(sample);
  bool holds_two = is_primed;
  is_primed = true;
  if (!holds_two || waiting.empty()) return -1;
  Sample oldest = waiting.read();
  return oldest.is_late ? oldest.value : oldest.value * 3;
}
