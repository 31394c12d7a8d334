/// ap_shift_reg<T, SIZE>: a shift register that one place is read from each time it shifts (an SRL in the
/// FPGA).
#ifndef AP_SHIFT_REG_H
#define AP_SHIFT_REG_H

template <class T, unsigned SIZE = 32>
class ap_shift_reg {
 public:
  ap_shift_reg() = default;
  ap_shift_reg(const ap_shift_reg&) = delete;
  ap_shift_reg& operator=(const ap_shift_reg&) = delete;

  /// Returns what place `address` holds, then moves all by one place and takes `in` into place 0 when
  /// `enable`.
  T shift(T in, unsigned address = SIZE - 1, bool enable = true) {
    const T out = places_[address];
    if (enable) {
    SHIFT:
      for (unsigned i = SIZE - 1; i > 0; --i) {
#pragma HLS UNROLL
        places_[i] = places_[i - 1];
      }
      places_[0] = in;
    }
    return out;
  }
  T read(unsigned address = SIZE - 1) const { return places_[address]; }

 private:
  T places_[SIZE];
};

#endif
