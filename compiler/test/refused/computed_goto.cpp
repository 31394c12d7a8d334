int computed_goto(int x) {
  static void* targets[2] = {&&one, &&two};
  goto* targets[x & 1];
one:
  return 1;
two:
  return 2;
}
// error: 3:9: only integers can be loaded and stored here; pointers and floating point have no hardware form
