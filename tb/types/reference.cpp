#include "reference.h"

#define SC_INCLUDE_FX
#include <cmath>
#include <systemc>

/// libsystemc brings a main() that calls this; the tests have their own.
int sc_main(int, char**) { return 0; }

namespace reference {
namespace {

constexpr int kBits = 640;
constexpr int kWordBits = 32;
constexpr int kSpareBits = 24;  // above a small format: every source of the exhaustive tests fits
enum { kSatSym = 2, kWrap = 3, kWrapSm = 4 };  // as in ap_o_mode

sc_dt::sc_signed to_systemc(Big a) {
  sc_dt::sc_signed result(kBits);
  for (int low = 0; low < kBits; low += kWordBits)
    result.range(low + kWordBits - 1, low) = static_cast<unsigned>(a >> low);
  return result;
}

Big from_systemc(const sc_dt::sc_signed& a) {
  const sc_dt::sc_signed extended = [&] {
    sc_dt::sc_signed wide(kBits);
    wide = a;
    return wide;
  }();
  unsigned _BitInt(kBits) result = 0;
  for (int low = 0; low < kBits; low += kWordBits)
    result |= static_cast<unsigned _BitInt(kBits)>(extended.range(low + kWordBits - 1, low).to_uint()) << low;
  return static_cast<Big>(result);
}

sc_dt::sc_q_mode quantisation(int q) {
  const sc_dt::sc_q_mode modes[] = {sc_dt::SC_RND,     sc_dt::SC_RND_ZERO, sc_dt::SC_RND_MIN_INF,
                                    sc_dt::SC_RND_INF, sc_dt::SC_RND_CONV, sc_dt::SC_TRN,
                                    sc_dt::SC_TRN_ZERO};
  return modes[q];
}

sc_dt::sc_o_mode overflow(int o) {
  const sc_dt::sc_o_mode modes[] = {sc_dt::SC_SAT, sc_dt::SC_SAT_ZERO, sc_dt::SC_SAT_SYM, sc_dt::SC_WRAP,
                                    sc_dt::SC_WRAP_SM};
  return modes[o];
}

}  // namespace

struct Fixed::Variable {
  virtual ~Variable() = default;
  virtual sc_dt::sc_fxnum& number() = 0;

  static std::unique_ptr<Variable> create(Format format, Modes modes);
};

namespace {

template <class Base, class T>
struct Holder : Base {
  Holder(Format f, Modes m) : value(f.width, f.integer, quantisation(m.q), overflow(m.o), m.n) {}
  sc_dt::sc_fxnum& number() override { return value; }
  T value;
};

}  // namespace

std::unique_ptr<Fixed::Variable> Fixed::Variable::create(Format format, Modes modes) {
  if (format.is_signed) return std::make_unique<Holder<Variable, sc_dt::sc_fix>>(format, modes);
  return std::make_unique<Holder<Variable, sc_dt::sc_ufix>>(format, modes);
}

Fixed::Fixed(Format format, Modes modes)
    : format_(format),
      modes_(modes),
      variable_(Variable::create(format, modes)),
      rounded_(Variable::create({format.width + kSpareBits, format.integer + kSpareBits, true}, modes)) {}

Fixed::~Fixed() = default;

long long Fixed::assign(double value) {
  const int fraction = format_.width - format_.integer;
  variable_->number() = sc_dt::sc_fxval(value);
  const long long systemc = static_cast<long long>(std::ldexp(variable_->number().to_double(), fraction));
  rounded_->number() = sc_dt::sc_fxval(value);
  const long long rounded = static_cast<long long>(std::ldexp(rounded_->number().to_double(), fraction));

  const long long span = 1LL << format_.width;
  if (modes_.o == kWrap && modes_.n > 0 && !format_.is_signed && rounded < 0) {
    const long long top = span - (span >> modes_.n);
    return (rounded & (span - 1)) | top;
  }
  const bool outside = rounded < -span / 2 || rounded >= span / 2;
  if (modes_.o == kWrapSm && modes_.n == 0 && outside) {
    const bool lost = static_cast<long long>(std::floor(std::ldexp(value, fraction))) & span,
               top = rounded & (span >> 1);
    const long long low = (lost == top ? rounded : ~rounded) & ((span >> 1) - 1);
    return lost ? low - span / 2 : low;
  }
  if (modes_.o == kSatSym && format_.is_signed && format_.width == 1 && rounded < 0) return -1;
  return systemc;
}

Big Fixed::assign(Big value, int fraction) {
  variable_->number() = sc_dt::sc_fxval(to_systemc(value)) >> fraction;
  unsigned _BitInt(kBits) bits = 0;
  for (int i = 0; i < format_.width; ++i)
    bits |= static_cast<unsigned _BitInt(kBits)>(bool(variable_->number()[i])) << i;
  return wrapped(static_cast<Big>(bits), format_.width, format_.is_signed);
}

long long Fixed::assign(double a, char op, double b) {
  const sc_dt::sc_fxval left(a), right(b);
  variable_->number() = op == '+'   ? left + right
                        : op == '-' ? left - right
                        : op == '*' ? left * right
                                    : left / right;
  return static_cast<long long>(std::ldexp(variable_->number().to_double(), format_.width - format_.integer));
}

namespace {

/// T: sc_signed or sc_bigint, whose results keep every bit.
template <class T>
sc_dt::sc_signed apply(const T& left, char op, const T& right) {
  switch (op) {
    case '+':
      return left + right;
    case '-':
      return left - right;
    case '*':
      return left * right;
    case '/':
      return left / right;
    case '%':
      return left % right;
    case '&':
      return left & right;
    case '|':
      return left | right;
    case '^':
      return left ^ right;
    case '<':
      return left << right.to_int();
    default:
      return left >> right.to_int();
  }
}

}  // namespace

Big integer(Big a, char op, Big b) { return from_systemc(apply(to_systemc(a), op, to_systemc(b))); }

long long integer(long long a, char op, long long b) {
  return apply(sc_dt::sc_bigint<64>(a), op, sc_dt::sc_bigint<64>(b)).to_int64();
}

Big wrapped(Big a, int width, bool is_signed) {
  if (is_signed) {
    sc_dt::sc_signed narrow(width);
    narrow = to_systemc(a);
    return from_systemc(narrow);
  }
  sc_dt::sc_unsigned narrow(width);
  narrow = to_systemc(a);
  sc_dt::sc_signed wide(kBits);
  wide = narrow;
  return from_systemc(wide);
}

long long wrapped(long long a, int width, bool is_signed) {
  if (!is_signed) {
    sc_dt::sc_unsigned narrow(width);
    narrow = a;
    return narrow.to_int64();
  }
  sc_dt::sc_signed narrow(width);
  narrow = a;
  return narrow.to_int64();
}

}  // namespace reference
