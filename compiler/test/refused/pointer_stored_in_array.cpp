int pointer_stored_in_array(int i) {
  static int x[4], y[4];
  int* rows[2] = {x, y};
  rows[i & 1][i & 3] += i;
  return rows[(i >> 1) & 1][i & 3];
}
// error: 3:8: only integers can be loaded and stored here; pointers and floating point have no hardware form
