// Two reads an iteration of a local array and of a table reach the II that is asked for: copies are read.
// top: array_two_read_ports
static const int kTable[256] = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3};
void array_two_read_ports(const int in[64], int out[32]) {
  int buffer[64];  // expect: memory buffer ram 64x32
  for (int i = 0; i < 64; ++i) buffer[i] = in[i] + i;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    out[i] = buffer[i] * kTable[buffer[63 - i] & 255] + kTable[i * 3];
  }
  for (int i = 0; i < 32; ++i) out[i] += buffer[i] + buffer[63 - i];  // expect: loop II=1
}
