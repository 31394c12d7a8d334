/// Horizontal plus vertical gradient of a grey picture, one pixel a cycle.
#include "ap_axi_sdata.h"
#include "hls_stream.h"

const int kMaxWidth = 128;

typedef ap_axiu<8, 1> pixel_t;  ///< user: first pixel of the picture; last: end of a row

/// |right - left| + |lower - upper| of each pixel's neighbours, 255 at most; 0 in the first two rows and
/// columns, to which the picture is shifted. width <= kMaxWidth.
void edges(hls::stream<pixel_t>& in, hls::stream<pixel_t>& out, int height, int width);
