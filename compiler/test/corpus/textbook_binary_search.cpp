// Binary search in a constant table.
// top: textbook_binary_search
int textbook_binary_search(unsigned char key) {
  static const unsigned char table[16] = {3, 9, 14, 22, 37, 41, 60, 77, 90, 111, 130, 155, 180, 200, 222, 250};
  int low = 0, high = 15, steps = 0;
  while (low <= high) {
    int middle = (low + high) >> 1;
    ++steps;
    if (table[middle] == key) return middle * 16 + steps;
    if (table[middle] < key)
      low = middle + 1;
    else
      high = middle - 1;
  }
  return -steps;
}
