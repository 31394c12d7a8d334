// Calls whose II is what a port outside needs for all of a long unrolled loop.
// top: calls_long
// calls: 3
int calls_long(const int a[300], int b[300], int k) {  // expect: loop II=300 because the read port of 'a'
#pragma HLS PIPELINE
#pragma HLS INTERFACE ap_memory port=a storage_type=ram_1p
#pragma HLS INTERFACE ap_memory port=b storage_type=ram_1p
  int sum = 0;
  for (int i = 0; i < 300; ++i) {
    sum += a[i] * k;
    b[i] = sum;
  }
  return sum;
}
