// A scalar output with a valid flag.
// top: interface_ap_vld
void interface_ap_vld(int a, int* out) {
#pragma HLS INTERFACE ap_vld port=out
  if (a & 1) *out = a * 2;
  else *out = -a;
}
