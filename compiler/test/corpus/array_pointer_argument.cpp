// An array behind a pointer of steered length.
// top: array_pointer_argument
// array: data=24
void array_pointer_argument(int* data, int add) {
#pragma HLS INTERFACE ap_memory port=data depth=24
  for (int i = 0; i < 24; ++i) data[i] += add;
}
