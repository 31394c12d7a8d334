/// Every source format up to 6 bits into every target format up to 6 bits, whatever the places of the two
/// points.
#include "fixed_cases.h"

namespace {

using namespace fixed_cases;

template <class T, bool S2, int... W2>
void check_places() {
  T::check_sources({T::template from<W2, S2, -7>()...});
  T::check_sources({T::template from<W2, S2, -1>()...});
  T::check_sources({T::template from<W2, S2, 0>()...});
  T::check_sources({T::template from<W2, S2, 1>()...});
  T::check_sources({T::template from<W2, S2, 3>()...});
  T::check_sources({T::template from<W2, S2, 8>()...});
}

/// I = -3 and 9: points outside the word.
template <bool S, int... W>
void check_targets() {
  (check_places<Target<W, W, S, AP_RND, AP_SAT>, true, 1, 2, 3, 4, 5, 6>(), ...);
  (check_places<Target<W, -3, S, AP_RND_CONV, AP_SAT_SYM>, false, 1, 2, 3, 4, 5, 6>(), ...);
  (check_places<Target<W, 9, S, AP_TRN_ZERO, AP_WRAP>, true, 1, 2, 3, 4, 5, 6>(), ...);
}

TEST(FixedSources, IntoSigned) { check_targets<true, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedSources, IntoUnsigned) { check_targets<false, 1, 2, 3, 4, 5, 6>(); }

}  // namespace
