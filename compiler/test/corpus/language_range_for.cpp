// A range-based for loop over a local array.
// top: language_range_for
int language_range_for(int a) {
  int values[6] = {1, 2, 3, 5, 8, 13};
  int sum = 0;
  for (int& value : values) value *= a;
  for (int value : values) sum ^= value;
  return sum;
}
