// Scalars and the return value behind AXI4-Lite.
// top: interface_axilite
int interface_axilite(int a, short b) {
#pragma HLS INTERFACE s_axilite port=a
#pragma HLS INTERFACE s_axilite port=b
#pragma HLS INTERFACE s_axilite port=return
  return a * b;
}
