// break out of a loop: first match.
// top: loop_break
int loop_break(const unsigned char a[32], unsigned char key) {
  int found = -1;
  for (int i = 0; i < 32; ++i) {
    if ((a[i] & 15) == (key & 15)) {
      found = i;
      break;
    }
  }
  return found;
}
