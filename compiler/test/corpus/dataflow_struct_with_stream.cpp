// A struct between processes that holds a stream and scalars beside it.
// top: dataflow_struct_with_stream
// range: rows=1..8
// range: columns=1..8
#include "ap_int.h"
#include "hls_stream.h"
struct Image {
  int rows, columns;
  hls::stream<ap_uint<8>, 16> pixels;
  Image(int r, int c) : rows(r), columns(c) {}
};
static void load(const ap_uint<8>* in, Image& image) {
  for (int i = 0; i < image.rows * image.columns; ++i) image.pixels.write(in[i]);
}
static void difference(Image& from, Image& to) {
  for (int row = 0; row < from.rows; ++row) {
    ap_uint<8> left = 0;
    for (int column = 0; column < from.columns; ++column) {
      ap_uint<8> pixel = from.pixels.read();
      to.pixels.write(pixel - left);
      left = pixel;
    }
  }
}
static void store(Image& image, ap_uint<8>* out) {
  for (int i = 0; i < image.rows * image.columns; ++i) out[i] = image.pixels.read();
}
void dataflow_struct_with_stream(const ap_uint<8> in[64], ap_uint<8> out[64], int rows, int columns) {
#pragma HLS DATAFLOW
  Image image(rows, columns), differences(rows, columns);
  load(in, image);
  difference(image, differences);
  store(differences, out);
}
