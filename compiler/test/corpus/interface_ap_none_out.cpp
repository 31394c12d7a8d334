// Scalar outputs by pointer and reference with ap_none.
// top: interface_ap_none_out
void interface_ap_none_out(int a, int b, int* sum, int& difference) {
#pragma HLS INTERFACE ap_none port=sum
#pragma HLS INTERFACE ap_none port=difference
  *sum = a + b;
  difference = a - b;
}
