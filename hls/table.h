/// Tables whose entries the compiler computes from a formula, so that a ROM needs no list of numbers.
#ifndef FLOORLINE_HLS_TABLE_H
#define FLOORLINE_HLS_TABLE_H

namespace floorline {

/// Bits of an unsigned number up to VALUE.
template <unsigned long VALUE>
struct BitWidth {
  enum { value = 1 + BitWidth<(VALUE >> 1)>::value };
};

template <>
struct BitWidth<0> {
  enum { value = 0 };
};

template <int... INDEX>
struct Indices {};

/// Indices<0, 1, .., COUNT - 1>.
template <int COUNT, int... INDEX>
struct CountedIndices : CountedIndices<COUNT - 1, COUNT - 1, INDEX...> {};

template <int... INDEX>
struct CountedIndices<0, INDEX...> {
  typedef Indices<INDEX...> type;
};

/// ROM of SIZE words, word i = Formula::at(i), a constexpr function.
template <typename Formula, int SIZE, typename Sequence = typename CountedIndices<SIZE>::type>
struct Table;

template <typename Formula, int SIZE, int... INDEX>
struct Table<Formula, SIZE, Indices<INDEX...> > {
  static constexpr unsigned word[SIZE] = {Formula::at(INDEX)...};
};

template <typename Formula, int SIZE, int... INDEX>
constexpr unsigned Table<Formula, SIZE, Indices<INDEX...> >::word[SIZE];

}  // namespace floorline

#endif
