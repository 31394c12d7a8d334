static int twice(int x) { return 2 * x; }
static int thrice(int x) { return 3 * x; }
int function_pointer(int x, int which) {
  int (*chosen[2])(int) = {twice, thrice};
  return chosen[which & 1](x);
}
// error: 4:9: only integers can be loaded and stored here; pointers and floating point have no hardware form
