/// Parts of a word that can be read and assigned: one bit, a slice, a whole word, several of them side by
/// side.
#ifndef AP_DETAIL_REFERENCES_H
#define AP_DETAIL_REFERENCES_H

#include "operands.h"

namespace ap_detail {

/// What every part can do. D derives from it and has bits(), put(bits), length() and one conversion to a
/// native type: with two, `sum += part` would be ambiguous. Assignment copies the value, never the place.
template <class D, int W>
struct Reference {
  static const int width = W;

  AP_INLINE Unsigned<W> raw() const { return self().bits(); }
  AP_INLINE ap_uint<W> get() const { return ap_uint<W>(FromBits(), self().bits()); }

  AP_INLINE int to_int() const { return static_cast<int>(self().bits()); }
  AP_INLINE unsigned to_uint() const { return static_cast<unsigned>(self().bits()); }
  AP_INLINE long to_long() const { return static_cast<long>(self().bits()); }
  AP_INLINE unsigned long to_ulong() const { return static_cast<unsigned long>(self().bits()); }
  AP_INLINE long long to_int64() const { return static_cast<long long>(self().bits()); }
  AP_INLINE unsigned long long to_uint64() const { return static_cast<unsigned long long>(self().bits()); }
  AP_INLINE bool to_bool() const { return self().bits() != 0; }

  AP_INLINE bool or_reduce() const { return self().bits() != 0; }
  AP_INLINE bool nor_reduce() const { return !or_reduce(); }
  AP_INLINE bool and_reduce() const { return self().bits() == ones<W>(self().length()); }
  AP_INLINE bool nand_reduce() const { return !and_reduce(); }
  AP_INLINE bool xor_reduce() const { return Halves<W>::parity(self().bits()); }
  AP_INLINE bool xnor_reduce() const { return !xor_reduce(); }

 protected:
  template <class T>
  AP_INLINE D& assign(const T& x) {
    D& self = static_cast<D&>(*this);
    self.put(static_cast<Unsigned<W>>(ap_detail::raw(x)));
    return self;
  }

 private:
  AP_INLINE const D& self() const { return static_cast<const D&>(*this); }
};

}  // namespace ap_detail

/// One bit.
template <int W, bool S>
struct ap_bit_ref : ap_detail::Reference<ap_bit_ref<W, S>, 1> {
  AP_INLINE ap_bit_ref(ap_detail::Bits<W, S>& word, int index)
      : word_(word), index_(ap_detail::checked("bit", index, W)) {}
  ap_bit_ref(const ap_bit_ref&) = default;
  AP_INLINE ap_bit_ref& operator=(const ap_bit_ref& x) { return this->assign(x); }
  template <class T>
  AP_INLINE ap_bit_ref& operator=(const T& x) {
    return this->assign(x);
  }

  AP_INLINE ap_detail::Unsigned<1> bits() const {
    return static_cast<ap_detail::Unsigned<1>>(word_.V >> index_);
  }
  AP_INLINE void put(ap_detail::Unsigned<1> bit) {
    word_.V = (word_.V & ~(ap_detail::Unsigned<W>(1) << index_)) | ap_detail::Unsigned<W>(bit) << index_;
  }
  AP_INLINE int length() const { return 1; }
  AP_INLINE operator bool() const { return bits() != 0; }
  AP_INLINE bool operator~() const { return bits() == 0; }

 private:
  ap_detail::Bits<W, S>& word_;
  int index_;
};

/// A slice of `length` bits from bit lo up.
template <int W, bool S>
struct ap_range_ref : ap_detail::Reference<ap_range_ref<W, S>, W> {
  AP_INLINE ap_range_ref(ap_detail::Bits<W, S>& word, int lo, int length)
      : word_(word),
        lo_(ap_detail::checked("range", lo, W)),
        length_(ap_detail::checked("range length", length - 1, W - lo) + 1) {}
  ap_range_ref(const ap_range_ref&) = default;
  AP_INLINE ap_range_ref& operator=(const ap_range_ref& x) { return this->assign(x); }
  template <class T>
  AP_INLINE ap_range_ref& operator=(const T& x) {
    return this->assign(x);
  }

  AP_INLINE ap_detail::Unsigned<W> bits() const { return word_.V >> lo_ & ap_detail::ones<W>(length()); }
  AP_INLINE void put(ap_detail::Unsigned<W> bits) {
    ap_detail::Unsigned<W> mask = ap_detail::ones<W>(length());
    word_.V = (word_.V & ~(mask << lo_)) | (bits & mask) << lo_;
  }
  AP_INLINE int length() const { return length_; }
  AP_INLINE operator unsigned long long() const { return static_cast<unsigned long long>(bits()); }

 private:
  ap_detail::Bits<W, S>& word_;
  int lo_, length_;
};

namespace ap_detail {

/// A whole word as the target of a concatenation.
template <int W, bool S>
struct WordReference : Reference<WordReference<W, S>, W> {
  AP_INLINE explicit WordReference(Bits<W, S>& word) : word_(word) {}

  AP_INLINE Unsigned<W> bits() const { return word_.V; }
  AP_INLINE void put(Unsigned<W> bits) { word_.V = bits; }
  AP_INLINE int length() const { return W; }
  AP_INLINE operator unsigned long long() const { return static_cast<unsigned long long>(bits()); }

 private:
  Bits<W, S>& word_;
};

/// The bits of a constant or temporary as a part of a concatenation; it cannot be assigned.
template <int W>
struct Copy : Reference<Copy<W>, W> {
  AP_INLINE explicit Copy(Unsigned<W> bits) : bits_(bits) {}

  AP_INLINE Unsigned<W> bits() const { return bits_; }
  AP_INLINE int length() const { return W; }
  AP_INLINE operator unsigned long long() const { return static_cast<unsigned long long>(bits()); }

 private:
  Unsigned<W> bits_;
};

}  // namespace ap_detail

/// left and right side by side, right in the low bits.
template <class L, class R>
struct ap_concat_ref : ap_detail::Reference<ap_concat_ref<L, R>, L::width + R::width> {
  static const int width = L::width + R::width;

  AP_INLINE ap_concat_ref(const L& left, const R& right) : left_(left), right_(right) {}
  ap_concat_ref(const ap_concat_ref&) = default;
  AP_INLINE ap_concat_ref& operator=(const ap_concat_ref& x) { return this->assign(x); }
  template <class T>
  AP_INLINE ap_concat_ref& operator=(const T& x) {
    return this->assign(x);
  }

  AP_INLINE ap_detail::Unsigned<width> bits() const {
    return ap_detail::Unsigned<width>(left_.bits()) << right_.length() | right_.bits();
  }
  AP_INLINE void put(ap_detail::Unsigned<width> bits) {
    right_.put(static_cast<ap_detail::Unsigned<R::width>>(bits));
    left_.put(static_cast<ap_detail::Unsigned<L::width>>(bits >> right_.length()));
  }
  AP_INLINE int length() const { return left_.length() + right_.length(); }
  AP_INLINE operator unsigned long long() const { return static_cast<unsigned long long>(bits()); }

 private:
  L left_;
  R right_;
};

namespace ap_detail {

template <int W, bool S>
AP_INLINE WordReference<W, S> part(Bits<W, S>& word) {
  return WordReference<W, S>(word);
}
template <int W, bool S>
AP_INLINE Copy<W> part(const Bits<W, S>& word) {
  return Copy<W>(word.V);
}
template <class D, int W>
AP_INLINE D part(const Reference<D, W>& reference) {
  return static_cast<const D&>(reference);
}
template <class T, class = typename std::enable_if<IsNative<T>::value>::type>
AP_INLINE Copy<NativeWidth<T>::value> part(const T& x) {
  return Copy<NativeWidth<T>::value>(static_cast<Unsigned<NativeWidth<T>::value>>(x));
}

template <class T>
using PartOf = decltype(part(std::declval<T>()));

template <class A, class B>
using Concatenation = ap_concat_ref<PartOf<A>, PartOf<B>>;

}  // namespace ap_detail

#endif
