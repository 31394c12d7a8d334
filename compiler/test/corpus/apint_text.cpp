// Constants as text, in several radices.
// top: apint_text
#include <ap_int.h>
struct Result {
  ap_uint<96> sum;
  ap_int<40> difference;
  ap_uint<8> bits;
};
void apint_text(ap_uint<64> a, Result* result) {
  const ap_uint<64> poly("42F0E1EBA9EA3693", 16);
  static const ap_uint<96> wide("0x0123456789abcdef01234567", 16);
  ap_int<40> x("-123456", 10);
  ap_uint<64> c = "0x123456789abcdef0";
  result->sum = (a ^ poly) + wide + c;
  result->difference = x - ap_int<40>("0b1101");
  result->bits = ap_uint<8>("z", 36);
}
