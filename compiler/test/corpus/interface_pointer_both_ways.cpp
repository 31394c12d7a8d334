// A scalar pointer that is read and written.
// top: interface_pointer_both_ways
void interface_pointer_both_ways(int* state, int step) {
  if (step & 1) *state += step;
}
