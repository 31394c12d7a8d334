"""Feeds check_kernels.py with kernels that hold one forbidden construct each, and with one that is good.

usage: check_kernels_test.py INCLUDE_DIR"""

import pathlib
import sys
import tempfile

import check_kernels

GOOD = """
template <int N> struct Table {
  typedef int Value;
  static constexpr int at(int i) { return i * N; }
};
enum Mode { PLAIN, TOLERANT };
static_assert(sizeof(int) == 4, "int");
template <typename T, int N = 4> T sum(const T (&values)[N]) {
#pragma HLS INLINE
  T total = 0;
  for (int i = 0; i < N; ++i) {
#pragma HLS UNROLL
    total += values[i] + Table<N>::at(i);
  }
  return total;
}
int top(const int values[4]) {
  int copy[4] = {values[0], values[1], values[2], values[3]};
  return sum<int, 4>(copy);
}
"""

REFUSED = {  # kernel: a part of the sentence
    "int f(int a) { auto g = [a](int b) { return a + b; }; return g(1); }": "lambda",
    "int* f() { return new int(1); }": "'new'",
    "void f(int* p) { delete p; }": "'delete'",
    "void f() { throw 1; }": "'throw'",
    "int f(int a) { try { return a; } catch (...) { return 0; } }": "'try'",
    "float f(int* p) { return *reinterpret_cast<float*>(p); }": "'reinterpret_cast'",
    "int f(int a) { again: if (a < 9) { ++a; goto again; } return a; }": "'goto'",
    "union Both { int i; float f; };": "union",
    "using Word = int;": "'using'",
    "template <typename T> using Pointer = T*;": "alias",
    "int operator\"\" _px(unsigned long long v) { return int(v); } int f() { return 3_px; }": "user-defined literal",
    "struct S { int a = 1; };": "initialiser in the class",
    "struct alignas(16) S { int a; };": "'alignas'",
    "struct S { virtual int f() { return 1; } };": "virtual",
    "int f(int (*g)(int)) { return g(1); }": "pointer to a function",
    "thread_local int counter;": "'thread_local'",
    "int f(int a) { return a < 2 ? a : f(a - 1) + f(a - 2); }": "recursion of 'f'",
    "int g(int); int f(int a) { return g(a); } int g(int a) { return a ? f(a - 1) : 0; }": "recursion of 'f'",
    "extern \"C\" int printf(const char*, ...); void f() { printf(\"\"); }": "call of the system, 'printf'",
    "template <typename T> struct Box { T value = 1; };": "initialiser in the class",
    "int f() {\n#pragma HLS BIND_STORAGE variable=x\n return 1; }": "BIND_STORAGE",
}
LIBRARY = "#include <vector>\nnamespace floorline { void f(std::vector<int>& v) { v[0] = 1; } }"


def faults(text, include):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "kernel.h"
        file.write_text(text)
        return check_kernels.faults(include, [str(file)])


def expect(text, part, include):
    found = faults(text, include)
    if not any(part in sentence for sentence in found):
        sys.exit(f"error: this was to be refused with '{part}' and gave {found}:\n{text}")
    if not part.startswith("recursion") and "kernel.h:" not in found[0]:
        sys.exit(f"error: {found[0]} does not tell the place.")


def main():
    include = sys.argv[1]
    good = faults(f"namespace floorline {{{GOOD}}}", include)
    if good:
        sys.exit(f"error: a good kernel is refused: {good}")
    for kernel, part in REFUSED.items():
        expect(f"namespace floorline {{\n{kernel}\n}}", part, include)
    expect(LIBRARY, "standard library", include)


if __name__ == "__main__":
    main()
