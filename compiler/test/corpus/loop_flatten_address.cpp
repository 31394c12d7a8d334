// An address that the outer loop of a nest makes and the inner one uses, which becomes one loop with it.
// top: loop_flatten_address
void loop_flatten_address(const int table[32][2], unsigned char out[4]) {
  for (int i = 0; i < 5; ++i)
    for (int j = 1; j < 8; ++j) {
#pragma HLS PIPELINE
      out[table[i & 3][1] & 3] = ~(table[1][1] % -7 - table[i != 0][out[i & 3] & 1]);
    }
}
