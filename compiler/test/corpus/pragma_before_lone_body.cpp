// Pragmas between a loop's head and its lone statement.
// top: pragma_before_lone_body
void pragma_before_lone_body(const int in[16], int out[16]) {
  int total = 0;
  for (int i = 0; i < 16; i++)  // expect: loop II=1
#pragma HLS PIPELINE II=1
#pragma HLS LOOP_TRIPCOUNT min=16 max=16
    out[i] = in[i] * 3;
  for (int i = 0; i < 4; i++)
#pragma HLS UNROLL
    for (int k = 0; k < 4; k++) total += in[4 * i + k] >> i;
  out[0] = total;
}
