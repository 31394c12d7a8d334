#include <ap_int.h>

#include "hls_stream.h"

void far_memory(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<16> >& out, ap_uint<8> wanted);

namespace {

const int WORDS = 40000, STEP = 911;

ap_uint<8> word(int run, int i) { return ap_uint<8>((i * 37 + run * 11) % 251); }

}  // namespace

int main() {
  static ap_uint<8> words[WORDS];
  hls::stream<ap_uint<8> > in;
  hls::stream<ap_uint<16> > out;
  for (int run = 0; run < 3; ++run) {
    for (int i = 0; i < 600; ++i) {
      in.write(word(run, i));
      words[i * STEP % WORDS] = word(run, i);
    }
    const int place = 60 + 83 * run;
    far_memory(in, out, word(run, place));
    bool is_right = out.read() == words[600 * STEP % WORDS];
    for (int i = 0; i < 600; ++i) is_right &= out.read() == word(run, i);
    is_right &= out.read() == place * STEP % WORDS;
    is_right &= out.read() == words[place * STEP % WORDS + 1];
    if (!is_right) return 1;
  }
  return 0;
}
