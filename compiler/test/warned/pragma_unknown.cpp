// An unknown pragma is named.
// top: pragma_unknown
int pragma_unknown(int a) {
#pragma HLS FLY_TO_THE_MOON
  return a + 1;
}
// warning: 4:9: pragma 'FLY_TO_THE_MOON' is not known and has no effect
