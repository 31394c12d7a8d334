#include "matrix.h"

#include "hls_stream.h"

static void transpose(const short b[kSize][kSize], short columns[kSize][kSize]) {
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j) columns[j][i] = b[i][j];
}

static void multiply(const short a[kSize][kSize], const short columns[kSize][kSize],
                     hls::stream<int>& products) {
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j) {
      int sum = 0;
      for (int k = 0; k < kSize; ++k) {
#pragma HLS PIPELINE II = 1
        sum += a[i][k] * columns[j][k];
      }
      products.write(sum);
    }
}

static void collect(hls::stream<int>& products, int c[kSize][kSize], int* trace) {
  int sum = 0;
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j) {
      int product = products.read();
      c[i][j] = product;
      if (i == j) sum += product;
    }
  *trace = sum;
}

void matrix(const short a[kSize][kSize], const short b[kSize][kSize], int c[kSize][kSize], int* trace) {
#pragma HLS DATAFLOW
  short columns[kSize][kSize];
  hls::stream<int> products("products");
#pragma HLS STREAM variable = products depth = 4
  transpose(b, columns);
  multiply(a, columns, products);
  collect(products, c, trace);
}
