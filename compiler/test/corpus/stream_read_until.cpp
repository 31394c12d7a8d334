// A packet of unknown length ended by a token.
// top: stream_read_until
#include "hls_stream.h"
int stream_read_until(hls::stream<unsigned char>& in) {
  int sum = 0;
  unsigned char v;
  do {
    v = in.read();
    sum += v;
  } while ((v & 15) != 0);
  return sum;
}
