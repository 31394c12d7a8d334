int inline_assembly(int x) {
  asm volatile("nop");
  return x;
}
