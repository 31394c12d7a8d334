// ap_ctrl_chain: calls stop behind one whose end nobody takes.
// top: calls_chain
// calls: 60
int calls_chain(int a, int b) {  // expect: loop II=1
#pragma HLS INTERFACE ap_ctrl_chain port=return
#pragma HLS PIPELINE
  static int last = 0;
  int now = a * b + last;
  last = a;
  return now;
}
