// A stream of structs.
// top: stream_struct
#include "ap_int.h"
#include "hls_stream.h"
struct Token {
  ap_uint<5> tag;
  ap_int<11> value;
  bool last;
};
void stream_struct(hls::stream<Token>& in, hls::stream<Token>& out) {
  for (int i = 0; i < 48; ++i) {
#pragma HLS PIPELINE II=1
    Token t = in.read();
    t.value = t.last ? ap_int<11>(-t.value) : ap_int<11>(t.value + t.tag);
    t.tag = i;
    out.write(t);
  }
}
