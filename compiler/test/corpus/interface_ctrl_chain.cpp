// ap_ctrl_chain: the result waits for ap_continue.
// top: interface_ctrl_chain
int interface_ctrl_chain(int a, int b) {
#pragma HLS INTERFACE mode=ap_ctrl_chain port=return
  int sum = 0;
  for (int i = 0; i < 5; ++i) sum += a ^ (b + i);  // expect: loop II=1 cycles=5
  return sum;
}
