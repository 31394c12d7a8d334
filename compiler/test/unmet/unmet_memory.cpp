// Sixty-four words are no registers.
// top: unmet_memory
// expect: memory history registers
int unmet_memory(int value, unsigned char at) {
  static int history[64];
  int old = history[at & 63];
  history[at & 63] = value;
  return old;
}
