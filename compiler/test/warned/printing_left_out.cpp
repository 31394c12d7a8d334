// printf and std::cout are left out.
// top: printing_left_out
#include <cstdio>
#include <iostream>
int printing_left_out(int a) {
  printf("a is %d\n", a);
  std::cout << "a + 1 is " << a + 1 << std::endl;
  return a + 1;
}
// warning: 6:3: 'printf' is left out of the hardware; put it between #ifndef __SYNTHESIS__ and #endif
// warning: 7:13: 'std::ostream' is left out of the hardware; put it between #ifndef __SYNTHESIS__ and #endif
