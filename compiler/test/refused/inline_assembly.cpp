int inline_assembly(int x) {
  asm volatile("nop");
  return x;
}
// error: 2:3: the call of 'a function pointer' cannot be inlined; give the function's source among the files
