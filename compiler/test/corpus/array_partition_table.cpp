// Banks of a constant table and of an array with initial values.
// top: array_partition_table
// calls: 3
// expect: memory tab logic count=2
// expect: memory st ram 14x16 count=2

static const short tab[3][7] = {{1,2,3,4,5,6,7},{-1,-2,-3,-4,-5,-6,-7},{11,12,13,14,15,16,17}};
static short st[3][7] = {{1,2,3,4,5,6,7},{-1,-2,-3,-4,-5,-6,-7},{11,12,13,14,15,16,17}};
void array_partition_table(unsigned s, unsigned t, int out[21]) {
#pragma HLS ARRAY_PARTITION variable=tab cyclic factor=2 dim=1
#pragma HLS ARRAY_PARTITION variable=st cyclic factor=2 dim=1
  for (int i = 0; i < 21; ++i) out[i] = tab[i % 3][(i + s) % 7] * st[(i + t) % 3][i % 7];
  st[s % 3][t % 7] += 3;
}
