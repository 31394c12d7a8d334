// An array outside with two ports, which read and write, beside one in the registers, which has one port to
// read.
void two_ports(int a[64], const int gains[64], int sums[32]) {
#pragma HLS INTERFACE s_axilite port = gains
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II = 1
    int even = a[2 * i], odd = a[2 * i + 1];
    sums[i] = even + odd * gains[i];
  }
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II = 1
    a[2 * i] = i;
    a[2 * i + 1] = -i;
  }
}
