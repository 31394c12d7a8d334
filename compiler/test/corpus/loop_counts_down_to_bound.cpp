// Column and row of a raster that only tell where it ends: they count down from the scalars, which need no register.
// top: loop_counts_down_to_bound
// range: width=1..9
// range: height=1..5
// expect: operators subtract=2
#include "ap_int.h"
#include "hls_stream.h"
void loop_counts_down_to_bound(hls::stream<unsigned char>& in, hls::stream<unsigned char>& out, ap_uint<6> width,
                               ap_uint<6> height) {
  const ap_uint<4> last_column = width - 1;
  const ap_uint<5> last_row = height - 1;
  ap_uint<4> column = 0;
  ap_uint<5> row = 0;
  for (bool inside = true; inside;) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    out.write(in.read() ^ 0x5A);
    if (column == last_column) {
      inside = row != last_row;
      column = 0;
      row = row + 1;
    } else {
      column = column + 1;
    }
  }
}
