// A piece of canonical Huffman: first codes from a count of lengths.
// top: textbook_huffman_lengths
void textbook_huffman_lengths(const unsigned char length[16], unsigned short code[16]) {
  unsigned char count[9];
  unsigned short next[9];
  for (int i = 0; i < 9; ++i) count[i] = 0;
  for (int i = 0; i < 16; ++i) count[length[i] & 7]++;
  count[0] = 0;
  unsigned short c = 0;
  for (int bits = 1; bits < 9; ++bits) {
    c = (c + count[bits - 1]) << 1;
    next[bits] = c;
  }
  for (int i = 0; i < 16; ++i) code[i] = (length[i] & 7) ? next[length[i] & 7]++ : 0;
}
