int interface_unknown_port(int x) {
#pragma HLS INTERFACE s_axilite port=y
  return x + 1;
}
// error: 2:38: use of undeclared identifier 'y'
