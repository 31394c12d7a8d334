#include <ap_int.h>
#include <stdint.h>

#include "hls_stream.h"

void wide_products(hls::stream<ap_int<64> >& in, hls::stream<ap_int<64> >& out);

namespace {

/// The low `bits` of `value`, extended by zero or by the sign.
int64_t low(uint64_t value, int bits, bool is_signed) {
  const uint64_t cut = value << (64 - bits);
  return is_signed ? static_cast<int64_t>(cut) >> (64 - bits) : static_cast<int64_t>(cut >> (64 - bits));
}

bool gives(hls::stream<ap_int<64> >& out, uint64_t a, uint64_t b) {
  return out.read() == ap_int<64>(static_cast<int64_t>(a * b));
}

}  // namespace

int main() {
  const uint64_t edges[] = {0,       1,       ~uint64_t(0), 0x8000000000, 0x7fffffffff,
                            0x1ffff, 0x20000, 0x3ffff,      0x4000000};
  hls::stream<ap_int<64> > in, out;
  uint64_t words[400], state = 1;
  for (int i = 0; i < 400; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    words[i] = i < 162 ? edges[i % 2 ? i / 2 % 9 : i / 18] : state >> 13;
    in.write(ap_int<64>(static_cast<int64_t>(words[i])));
  }
  wide_products(in, out);
  for (int i = 0; i < 400; i += 2) {
    const uint64_t a = words[i], b = words[i + 1];
    bool is_right = gives(out, low(a, 40, true), low(b, 27, true));
    is_right &= gives(out, low(a, 40, true), low(b, 19, false));
    is_right &= gives(out, low(a, 37, false), low(b, 27, true));
    is_right &= gives(out, low(a, 37, false), low(b, 19, false));
    is_right &= out.read() == ap_int<64>(low(a * b, 32, true));
    if (!is_right) return 1;
  }
  return 0;
}
