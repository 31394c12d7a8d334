int pragma_unknown_interface(int x) {
#pragma HLS INTERFACE teleport port=x
  return x + 1;
}
