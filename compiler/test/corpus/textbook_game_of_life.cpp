// One step of the game of life on bits of ap_uint words.
// top: textbook_game_of_life
#include "ap_int.h"
void textbook_game_of_life(const ap_uint<10> in[10], ap_uint<10> out[10]) {
  for (int r = 0; r < 10; ++r) {
    ap_uint<10> row = 0;
    for (int c = 0; c < 10; ++c) {
      int n = 0;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          int y = r + dr, x = c + dc;
          if ((dr || dc) && y >= 0 && y < 10 && x >= 0 && x < 10) n += in[y][x];
        }
      row[c] = n == 3 || (n == 2 && in[r][c]);
    }
    out[r] = row;
  }
}
