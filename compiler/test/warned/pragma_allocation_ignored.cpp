// ALLOCATION has no effect.
// top: pragma_allocation_ignored
int pragma_allocation_ignored(int a, int b) {
#pragma HLS ALLOCATION operation instances=mul limit=1
  return a * b + (a + 1) * (b + 1);
}
// warning: 4:9: pragma 'ALLOCATION' has no effect here; results are the same without it
