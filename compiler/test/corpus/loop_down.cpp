// Counting down with a negative step.
// top: loop_down
int loop_down(const int a[16]) {
  int hash = 0;
  for (int i = 15; i >= 0; i -= 3) hash = hash * 31 + a[i];
  return hash;
}
