int inline_assembly(int x) {
  asm volatile("nop");
  return x;
}
// error: 2:3: inline assembly has no hardware form; write it in C++
