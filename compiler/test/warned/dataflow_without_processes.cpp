// A DATAFLOW function of loops.
// top: dataflow_without_processes
void dataflow_without_processes(const int in[8], int out[8]) {
#pragma HLS DATAFLOW
  int middle[8];
  for (int i = 0; i < 8; ++i) middle[i] = in[i] * 3;
  for (int i = 0; i < 8; ++i) out[i] = middle[i] + 1;
}
// warning: 3: DATAFLOW has no effect: processes are the functions that are called here, and there are none; put each loop into a function of its own
