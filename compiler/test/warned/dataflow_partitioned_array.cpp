// An array between processes is one memory, whose rows go on to functions all the same.
// top: dataflow_partitioned_array
static void row(const short in[8], short out[8]) {
  for (int i = 0; i < 8; ++i) out[i] = in[7 - i] * 3;
}
static void fill(const short in[64], short block[8][8]) {
  for (int i = 0; i < 64; ++i) block[i / 8][i % 8] = in[i];
}
static void mirror(short block[8][8], short out[64]) {
  short rows[8][8];
  for (int i = 0; i < 8; ++i) row(block[i], rows[i]);
  for (int i = 0; i < 64; ++i) out[i] = rows[i % 8][i / 8];
}
void dataflow_partitioned_array(const short in[64], short out[64]) {
#pragma HLS DATAFLOW
  short block[8][8];
#pragma HLS ARRAY_PARTITION variable=block complete dim=2
  fill(in, block);
  mirror(block, out);
}
// warning: 17:9: ARRAY_PARTITION of 'block' has no effect: it lies between two processes, as one memory
