// return from the middle of nested loops.
// top: loop_early_return
int loop_early_return(const unsigned char a[8][8]) {
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 8; ++c)
      if ((a[r][c] & 63) == 7) return r * 8 + c;
  return -1;
}
