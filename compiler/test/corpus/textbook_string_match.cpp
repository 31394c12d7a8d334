// Naive string search with an early exit.
// top: textbook_string_match
int textbook_string_match(const signed char text[64], const signed char pattern[3]) {
  for (int i = 0; i <= 61; ++i) {
    int k = 0;
    while (k < 3 && (text[i + k] & 1) == (pattern[k] & 1)) ++k;
    if (k == 3) return i;
  }
  return -1;
}
