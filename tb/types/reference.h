/// SystemC as the reference of the arbitrary-precision types, behind plain numbers, so that one file pays for
/// its headers. Every format is a run-time value here.
#ifndef FLOORLINE_TB_TYPES_REFERENCE_H
#define FLOORLINE_TB_TYPES_REFERENCE_H

#include <memory>

namespace reference {

/// W bits, I of them left of the point.
struct Format {
  int width;
  int integer;
  bool is_signed;
};

/// q and o in the order of ap_q_mode and ap_o_mode; n saturated bits of a wrap.
struct Modes {
  int q;
  int o;
  int n;
};

/// A number with room for every exact result of the tests.
using Big = _BitInt(640);

/// A variable of sc_fix or sc_ufix, assigned again and again. Where the published Vitis types differ from
/// SystemC, the Vitis rule is applied to the number that SystemC rounded:
///  - AP_WRAP with N > 0 of an unsigned type sets the top N bits for numbers below the range too (SystemC:
///  zero);
///  - AP_WRAP_SM with N = 0 takes the lost bit from the number before rounding (SystemC: after);
///  - AP_SAT_SYM in one signed bit gives -1 below the range (SystemC: 0).
class Fixed {
 public:
  Fixed(Format format, Modes modes);
  ~Fixed();

  /// What the variable holds after `variable = value`, in units of its last bit. Up to 53 significant bits.
  long long assign(double value);
  /// The same for value * 2^-fraction of any size.
  Big assign(Big value, int fraction);
  /// What it holds after the assignment of a op b, op one of + - * /, in units of its last bit.
  long long assign(double a, char op, double b);

 private:
  struct Variable;
  Format format_;
  Modes modes_;
  std::unique_ptr<Variable> variable_;
  std::unique_ptr<Variable> rounded_;  ///< The same quantisation without overflow.
};

/// a op b of sc_signed numbers; op one of + - * / % & | ^ < (shift left by b) > (shift right by b).
Big integer(Big a, char op, Big b);

/// The same for small numbers, on sc_bigint<64>.
long long integer(long long a, char op, long long b);

/// The low `width` bits of a as a number, as assignment to sc_signed or sc_unsigned of that width leaves
/// them.
Big wrapped(Big a, int width, bool is_signed);
long long wrapped(long long a, int width, bool is_signed);

}  // namespace reference

#endif
