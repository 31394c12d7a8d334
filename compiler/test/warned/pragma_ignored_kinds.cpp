// Pragmas without effect are named, each once.
// top: pragma_ignored_kinds
static int twice(int x) { return 2 * x; }
int pragma_ignored_kinds(const int a[16], int b) {
#pragma HLS TOP name = pragma_ignored_kinds
#pragma HLS ALLOCATION function instances = twice limit = 1
#pragma HLS LOOP_MERGE
#pragma HLS PERFORMANCE target_ti = 100
#pragma HLS EXPRESSION_BALANCE
#pragma HLS INLINE
  static int state = 0;
#pragma HLS RESET variable = state
#pragma HLS SHARED variable = state
  int local[16];
#pragma HLS ARRAY_MAP variable = local instance = memory horizontal
  for (int i = 0; i < 16; ++i) {
#pragma HLS LOOP_FLATTEN
#pragma HLS OCCURRENCE cycle = 2
    local[i] = a[i] * b;
  }
  int product = twice(local[b & 15]) * b;
#pragma HLS BIND_OP variable = product op = mul impl = dsp
  {
#pragma HLS PROTOCOL fixed
    state += product;
  }
  return state;
}
// warning: 5:9: pragma 'TOP' has no effect here; results are the same without it
// warning: 6:9: pragma 'ALLOCATION' has no effect here; results are the same without it
// warning: 7:9: pragma 'LOOP_MERGE' has no effect here; results are the same without it
// warning: 8:9: pragma 'PERFORMANCE' has no effect here; results are the same without it
// warning: 9:9: pragma 'EXPRESSION_BALANCE' has no effect here; results are the same without it
// warning: 12:9: pragma 'RESET' has no effect here; results are the same without it
// warning: 13:9: pragma 'SHARED' has no effect here; results are the same without it
// warning: 15:9: pragma 'ARRAY_MAP' has no effect here; results are the same without it
// warning: 18:9: pragma 'OCCURRENCE' has no effect here; results are the same without it
// warning: 22:9: pragma 'BIND_OP' has no effect here; results are the same without it
// warning: 24:9: pragma 'PROTOCOL' has no effect here; results are the same without it
// warning: 16:3: the loop is not flattened: there is no loop around it
