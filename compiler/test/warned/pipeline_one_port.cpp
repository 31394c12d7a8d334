// What holds an array outside to one port: BIND_STORAGE, and a bank of registers.
// top: pipeline_one_port
int pipeline_one_port(const int a[16], const int b[16]) {
#pragma HLS BIND_STORAGE variable=a type=ram_1p
#pragma HLS INTERFACE s_axilite port=b
  int sum = 0;
  for (int i = 0; i < 15; ++i) {
#pragma HLS PIPELINE II=1
    sum += a[i] * a[15 - i];
  }
  for (int i = 0; i < 15; ++i) {
#pragma HLS PIPELINE II=1
    sum += b[i] * b[15 - i];
  }
  return sum;
}
// warning: 7:3: II = 1 is not reached, II is 2: the read port of 'a' is used at pipeline_one_port.cpp:9:12, pipeline_one_port.cpp:9:19; partition the array or access it once an iteration
// warning: 11:3: II = 1 is not reached, II is 2: the read port of 'b' is used at pipeline_one_port.cpp:13:12, pipeline_one_port.cpp:13:19; partition the array or access it once an iteration
