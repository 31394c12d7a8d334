// STREAM depth of what is no stream, in a function without DATAFLOW.
// top: pragma_stream_of_array
int pragma_stream_of_array(int a) {
  int b[4];
#pragma HLS STREAM variable=b depth=4
  for (int i = 0; i < 4; ++i) b[i] = a + i;
  return b[a & 3];
}
// warning: 5:9: pragma 'STREAM' has no effect: 'b' is no stream; declare it as hls::stream
