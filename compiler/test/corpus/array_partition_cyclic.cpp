// Cyclic banks let an unrolled loop read two elements a cycle.
// top: array_partition_cyclic
// expect: memory bank ram 16x32 count=2
int array_partition_cyclic(const int in[32]) {
  int bank[32];
#pragma HLS ARRAY_PARTITION variable=bank cyclic factor=2
  for (int i = 0; i < 32; ++i) bank[i] = in[i] ^ i;
  int sum = 0;
  for (int i = 0; i < 32; i += 2) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    sum += bank[i] - bank[i + 1];
  }
  return sum;
}
