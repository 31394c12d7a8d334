// A static state with a store in each case of a switch: all of one iteration take one cycle.
// top: state_machine_static
// tokens: 64
#include "ap_int.h"
#include "hls_stream.h"
enum class State : unsigned char { kIdle, kLength, kPayload, kCheck };
struct Packet {
  ap_uint<8> data;
  bool first, last;
};
void state_machine_static(hls::stream<ap_uint<8> >& in, hls::stream<Packet>& out, ap_uint<16>& errors) {
  static State state = State::kIdle;
  static ap_uint<4> remaining = 0;
  static ap_uint<8> sum = 0;
  static bool is_first = false;
  static ap_uint<16> bad = 0;
  for (int i = 0; i < 64; i++) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    ap_uint<8> c = in.read();
    switch (state) {
      case State::kIdle:
        if ((c & 3) == 1) state = State::kLength;
        break;
      case State::kLength:
        remaining = c(3, 0);
        sum = 0;
        is_first = true;
        state = remaining == 0 ? State::kCheck : State::kPayload;
        break;
      case State::kPayload: {
        Packet p = {c, is_first, remaining == 1};
        out.write(p);
        sum ^= c;
        is_first = false;
        if (--remaining == 0) state = State::kCheck;
        break;
      }
      default:
        if (c != sum) bad++;
        state = State::kIdle;
    }
  }
  errors = bad;
}
