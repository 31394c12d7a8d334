// A shift register without ap_start: each call is one run. Arguments are called as an adapter's own variables
// may be.
#include "ap_int.h"

enum class State : unsigned char { kIdle, kShift, kDone };

static void edge(ap_uint<8>& bits, bool pending) { bits = (bits << 1) | pending; }

void free_running_state(ap_uint<8> bits, bool pending, bool* moved, ap_uint<8>* value, bool* done) {
#pragma HLS INTERFACE ap_ctrl_none port = return
  static State state = State::kIdle;
  static ap_uint<8> shifted = 0;
  static ap_uint<4> count = 0;
  switch (state) {
    case State::kIdle:
      shifted = bits;
      count = 0;
      if (pending) state = State::kShift;
      break;
    case State::kShift:
      edge(shifted, pending);
      if (++count == 8) state = State::kDone;
      break;
    case State::kDone:
      *value = shifted;
      state = State::kIdle;
  }
  *moved = shifted[7];
  *done = state == State::kDone;
}
