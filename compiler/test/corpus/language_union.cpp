// A union whose bytes are taken at places known at run time.
// top: language_union
#include <stdint.h>
typedef union {
  uint64_t word;
  uint16_t halves[4];
  uint8_t bytes[8];
} Word;
uint64_t language_union(uint64_t x, uint8_t place, uint8_t value) {
  Word word;
  word.word = x;
  word.bytes[place & 7] = value;
  word.halves[(place >> 3) & 3] ^= 0x55aa;
  uint32_t sum = 0;
  for (int i = 0; i < 8; ++i) sum = 3 * sum + word.bytes[i];
  Word other = word;
  return word.word ^ sum ^ other.halves[place & 3];
}
