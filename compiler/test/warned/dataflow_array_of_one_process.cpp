// A DATAFLOW function whose calls cannot be processes.
// top: dataflow_array_of_one_process
static void sum(const int in[8], int work[8], int out[8]) {
  for (int i = 0; i < 8; ++i) work[i] = in[i];
  for (int i = 0; i < 8; ++i) work[i] += work[7 - i];
  for (int i = 0; i < 8; ++i) out[i] = work[i];
}
static void twice(const int in[8], int out[8]) {
  for (int i = 0; i < 8; ++i) out[i] = 2 * in[i];
}
void dataflow_array_of_one_process(const int in[8], int out[8]) {
#pragma HLS DATAFLOW
  int work[8], middle[8];
  sum(in, work, middle);
  twice(middle, out);
}
// warning: 14:3: DATAFLOW has no effect, the calls run one after the other: array 'work' is used by this process alone; declare it in the process
