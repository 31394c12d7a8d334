// Run-length coder on streams.
// top: textbook_run_length
#include "hls_stream.h"
void textbook_run_length(hls::stream<unsigned char>& in, hls::stream<unsigned short>& out) {
  unsigned char current = in.read() & 1;
  unsigned char run = 1;
  for (int i = 1; i < 64; ++i) {  // expect: loop II=1
    unsigned char v = in.read() & 1;
    if (v == current && run < 200) {
      ++run;
    } else {
      out.write((run << 8) | current);
      current = v;
      run = 1;
    }
  }
  out.write((run << 8) | current);
}
