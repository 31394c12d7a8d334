#include <csetjmp>
static jmp_buf buffer;
int setjmp_longjmp(int x) {
  if (setjmp(buffer)) return -1;
  if (x > 3) longjmp(buffer, 1);
  return x;
}
