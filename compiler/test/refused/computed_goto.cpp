int computed_goto(int x) {
  static void* targets[2] = {&&one, &&two};
  goto* targets[x & 1];
one:
  return 1;
two:
  return 2;
}
