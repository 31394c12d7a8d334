// Reports call a loop by its label.
// top: loop_label
#include "hls_stream.h"
void loop_label(hls::stream<int>& in, hls::stream<int>& out) {
  int value;
UNTIL_MULTIPLE:
  do {  // expect: loop II=1 depth=1 cycles=N(UNTIL_MULTIPLE)
    value = in.read();
    out.write(2 * value);
  } while (value % 8 != 0);
}
