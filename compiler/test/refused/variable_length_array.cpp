int variable_length_array(int n) {
  int a[n & 15];
  for (int i = 0; i < (n & 15); ++i) a[i] = i;
  return a[0];
}
// error: 3:43: 'vla' is accessed with a subscript but is no array
