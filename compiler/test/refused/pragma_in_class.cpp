struct Buffer {
  int words[4];
#pragma HLS ARRAY_PARTITION variable=words complete
  int sum() const { return words[0] + words[3]; }
};
int pragma_in_class(int a) {
  Buffer buffer = {{a, 1, 2, a}};
  return buffer.sum();
}
// error: 3:9: a pragma has no effect between the members of a class; move it into the constructor or a member function
