// An INTERFACE mode that does not exist.
// top: pragma_interface_unknown_mode
int pragma_interface_unknown_mode(int a) {
#pragma HLS INTERFACE warp_drive port=a
  return a + 1;
}
