// Two reads an iteration of an array outside: it has two read ports, as a dual-port memory offers them.
// top: array_two_ports_read
void array_two_ports_read(const int a[64], int sums[32], int neighbours[63]) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    sums[i] = a[i] + a[63 - i];
  }
  for (int i = 0; i < 63; ++i) neighbours[i] = a[i] ^ a[i + 1];  // expect: loop II=1
}
