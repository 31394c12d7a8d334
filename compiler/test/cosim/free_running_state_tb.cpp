#include "ap_int.h"

void free_running_state(ap_uint<8> bits, bool pending, bool* moved, ap_uint<8>* value, bool* done);

int main() {
  for (unsigned round = 0; round < 4; ++round) {
    const unsigned sent = 0x35 * (round + 1) & 0xff, answer = 0xa7 ^ round;
    unsigned received = 0;
    ap_uint<8> value = 0;
    bool moved = false, done = false;
    free_running_state(sent, true, &moved, &value, &done);
    for (int bit = 7; bit >= 0; --bit) {
      received = received << 1 | moved;
      free_running_state(0, answer >> bit & 1, &moved, &value, &done);
      if (done != (bit == 0)) return 1;
    }
    free_running_state(0, false, &moved, &value, &done);
    if (received != sent || value != answer || done) return 1;
  }
  return 0;
}
