// DEPENDENCE of a member array says nothing of the scalars beside it, which carry from iteration to iteration.
// top: array_dependence_member
struct Ring {
  int words[32];
  int last, sum;
};
void array_dependence_member(const int in[64], int out[64]) {
  Ring ring;
  for (int i = 0; i < 32; ++i) ring.words[i] = i;
  ring.last = in[0];
  ring.sum = 0;
  for (int i = 0; i < 64; ++i) {
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=ring.words inter false
    ring.sum += ring.last ^ ring.words[(i + 1) & 31];
    ring.words[(i + 30) & 31] = ring.sum;
    ring.last = in[i];
    out[i] = ring.sum;
  }
}
