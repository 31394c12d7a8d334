// A struct with an array that comes out of a stream and is read with a subscript; a function that returns one.
// top: stream_struct_array_subscript
#include "hls_stream.h"
struct Block {
  short values[4];
  int sum;
};
struct Pair {
  signed char bytes[8];
};
static Pair mirrored(Pair pair) {
  Pair out;
  for (int i = 0; i < 8; ++i) out.bytes[i] = pair.bytes[7 - i];
  return out;
}
void stream_struct_array_subscript(hls::stream<Block>& in, const int start[2], int out[32], signed char bytes[8]) {
  for (int i = 0; i < 8; ++i) {
    Block block = in.read();
    for (int k = 0; k < 4; ++k) out[4 * i + k] = block.values[k] + block.sum;
  }
  Pair pair;
  for (int i = 0; i < 8; ++i) pair.bytes[i] = start[i / 4] >> i;
  pair = mirrored(pair);
  for (int i = 0; i < 8; ++i) bytes[i] = pair.bytes[i];
}
