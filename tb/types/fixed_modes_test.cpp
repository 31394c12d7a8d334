/// Every format up to 6 bits in every quantisation and overflow mode, from every number of 6 bits whose last
/// bit lies at, or one, two or four places below, or two above that of the target. Compiled once for signed
/// and once for unsigned targets.
#include "fixed_cases.h"

namespace {

using namespace fixed_cases;

template <int W, ap_q_mode Q, ap_o_mode O, int N = 0>
void check_target() {
  using T = Target<W, W / 2, SIGNED_TARGETS, Q, O, N>;
  T::check_sources({T::template from<6, true, -2>(), T::template from<6, true, 0>(),
                    T::template from<6, true, 1>(), T::template from<6, true, 4>(),
                    T::template from<6, false, 2>()});
}

template <ap_o_mode O, int... W>
void check_every_quantisation() {
  (check_target<W, AP_RND, O>(), ...);
  (check_target<W, AP_RND_ZERO, O>(), ...);
  (check_target<W, AP_RND_MIN_INF, O>(), ...);
  (check_target<W, AP_RND_INF, O>(), ...);
  (check_target<W, AP_RND_CONV, O>(), ...);
  (check_target<W, AP_TRN, O>(), ...);
  (check_target<W, AP_TRN_ZERO, O>(), ...);
}

template <ap_o_mode O, int W, int... N>
void check_saturated_bits(std::integer_sequence<int, N...>) {
  (check_target<W, AP_TRN, O, N + 1>(), ...);
  (check_target<W, AP_RND, O, N + 1>(), ...);
  (check_target<W, AP_TRN_ZERO, O, N + 1>(), ...);
}
template <ap_o_mode O, int... W>
void check_every_saturated_bit() {
  (check_saturated_bits<O, W>(std::make_integer_sequence<int, W>()), ...);
}

TEST(FixedModes, Saturate) { check_every_quantisation<AP_SAT, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedModes, SaturateToZero) { check_every_quantisation<AP_SAT_ZERO, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedModes, SaturateSymmetrically) { check_every_quantisation<AP_SAT_SYM, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedModes, Wrap) { check_every_quantisation<AP_WRAP, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedModes, WrapWithSaturatedBits) { check_every_saturated_bit<AP_WRAP, 1, 2, 3, 4, 5, 6>(); }
#if SIGNED_TARGETS
TEST(FixedModes, WrapSignMagnitude) { check_every_quantisation<AP_WRAP_SM, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedModes, WrapSignMagnitudeWithSaturatedBits) {
  check_every_saturated_bit<AP_WRAP_SM, 1, 2, 3, 4, 5, 6>();
}
#endif

}  // namespace
