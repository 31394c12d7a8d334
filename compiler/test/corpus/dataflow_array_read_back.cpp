// A process reads the array that it writes for the next one: a histogram in halves.
// top: dataflow_array_read_back
static void count(const unsigned char in[24], int histogram[16]) {
  for (int i = 0; i < 16; i++) histogram[i] = 0;
  for (int i = 0; i < 24; i++) histogram[in[i] % 16]++;
}
static void join(const int first[16], const int second[16], int out[16]) {
  for (int i = 0; i < 16; i++) out[i] = first[i] + 100 * second[i];
}
void dataflow_array_read_back(const unsigned char a[24], const unsigned char b[24], int out[16]) {
#pragma HLS DATAFLOW
  int first[16], second[16];
  count(a, first);
  count(b, second);
  join(first, second, out);
}
