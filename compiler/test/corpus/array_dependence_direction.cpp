// DEPENDENCE inter of one direction: a word that was written is not read later, though the subscripts may meet.
// top: array_dependence_direction
void array_dependence_direction(int a[64], unsigned char shift) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
#pragma HLS dependence variable=a type=inter direction=RAW dependent=false
    a[i + 32 + (shift & 1)*0] = a[i] * 3 + (shift & 3);
  }
}
