// A pointer to one of two arrays.
// top: pointer_chosen_at_run_time
int pointer_chosen_at_run_time(int a[8], int b[8], bool left, int i) {
  int* chosen = left ? a : b;
  chosen[i & 7] = i;
  return chosen[(i + 1) & 7];
}
