// A word that was just stored is not read again: a line buffer that shifts a column and then looks at it.
// top: array_read_after_store
#include "ap_int.h"
#include "hls_stream.h"
template <class T, int ROWS, int COLUMNS>
struct LineBuffer {
  T rows[ROWS][COLUMNS];
  void shift_up(int column) {
    for (int i = 0; i < ROWS - 1; ++i) rows[i][column] = rows[i + 1][column];
  }
  void insert_bottom(T value, int column) { rows[ROWS - 1][column] = value; }
};
void array_read_after_store(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<12> >& out) {
  static LineBuffer<ap_uint<8>, 3, 12> lines;
#pragma HLS ARRAY_PARTITION variable = lines.rows dim = 1 complete
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 12; ++x) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_FLATTEN off
      lines.shift_up(x);
      lines.insert_bottom(in.read(), x);
      out.write(lines.rows[0][x] + 2 * lines.rows[1][x] + lines.rows[2][x]);
    }
  }
}
