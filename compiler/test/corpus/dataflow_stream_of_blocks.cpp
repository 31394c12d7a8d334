// Blocks of an array go from process to process while others are filled: each process locks one.
// top: dataflow_stream_of_blocks
// range: blocks=1..6
#include "ap_fixed.h"
#include "hls_streamofblocks.h"
struct Point {
  ap_int<9> x;
  ap_fixed<12, 4> weight;
};
typedef Point Tile[3][4];
static void make(const int in[72], hls::stream_of_blocks<Tile, 3>& tiles, int blocks) {
  for (int block = 0; block < blocks; ++block) {
    hls::write_lock<Tile> tile(tiles);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
        int word = in[block * 12 + i * 4 + j];
        tile[2 - i][j].x = word;
        tile[2 - i][j].weight = (word >> 9) & 7;
      }
  }
}
static int column_sum(const Tile& tile, int column) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) sum = 3 * sum + int(tile[i][column].x) + int(tile[i][column].weight);
  return sum;
}
static void use(hls::stream_of_blocks<Tile, 3>& tiles, int out[24], int blocks) {
  for (int block = 0; block < blocks; ++block) {
    hls::read_lock<Tile> tile(tiles);
    for (int j = 0; j < 4; ++j) out[block * 4 + j] = column_sum(tile, j);
  }
}
void dataflow_stream_of_blocks(const int in[72], int out[24], int blocks) {
#pragma HLS DATAFLOW
  hls::stream_of_blocks<Tile, 3> tiles("tiles");
  make(in, tiles, blocks);
  use(tiles, out, blocks);
}
