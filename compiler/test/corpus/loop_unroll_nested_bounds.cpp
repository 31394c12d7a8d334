// Unrolled loops whose bounds are variables of the unrolled loop around them.
// top: loop_unroll_nested_bounds
template <class T, int N>
static void sort(T (&values)[N]) {
  for (int pass = 0; pass < N; pass++) {  // expect: loop unrolled
#pragma HLS UNROLL
    for (int i = pass % 2; i + 1 < N; i += 2) {  // expect: loop unrolled
#pragma HLS UNROLL
      T low = values[i] < values[i + 1] ? values[i] : values[i + 1];
      T high = values[i] < values[i + 1] ? values[i + 1] : values[i];
      values[i] = low;
      values[i + 1] = high;
    }
  }
}
void loop_unroll_nested_bounds(short data[6]) {
  short values[6];
#pragma HLS ARRAY_PARTITION variable=values complete
  for (int i = 0; i < 6; i++) values[i] = data[i];
  sort(values);
  for (int i = 0; i < 6; i++) data[i] = values[i];
}
