/// Two products with values from a file, against plain C.
#include <cstdio>
#include <fstream>

#include "matrix.h"

int main() {
  std::ifstream values("values.txt");
  for (int run = 0; run < 2; ++run) {
    short a[kSize][kSize], b[kSize][kSize];
    for (auto& row : a)
      for (short& value : row) values >> value;
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < kSize; ++j) b[i][j] = a[j][i] + (i == j ? run : 0);
    if (!values) {
      std::puts("values.txt is missing or too short");
      return 1;
    }
    int c[kSize][kSize], trace = 0, expected_trace = 0;
    matrix(a, b, c, &trace);
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < kSize; ++j) {
        int expected = 0;
        for (int k = 0; k < kSize; ++k) expected += a[i][k] * b[k][j];
        if (i == j) expected_trace += expected;
        if (c[i][j] != expected) {
          std::printf("run %d: c[%d][%d] is %d, not %d\n", run, i, j, c[i][j], expected);
          return 1;
        }
      }
    if (trace != expected_trace) {
      std::printf("run %d: the trace is %d, not %d\n", run, trace, expected_trace);
      return 1;
    }
  }
  return 0;
}
