// Arrays that are filled with constants, but hold other values too, or are read before: no tables.
// top: array_filled_in_turns
int array_filled_in_turns(unsigned char place, int value) {
  int own[8], again[8];
  static int kept[8];
  int before = kept[place & 7];
#pragma HLS PIPELINE
  for (int i = 0; i < 8; ++i) kept[i] = 3 * i;
  for (int i = 0; i < 8; ++i) own[i] = 5 * i;
  if (value > 0) own[place & 7] = value;
  if (value & 1)
    for (int i = 0; i < 8; ++i) again[i] = i;
  else
    for (int i = 0; i < 8; ++i) again[i] = 7 - i;
  return before + own[(place >> 3) & 7] + again[place >> 5];
}
