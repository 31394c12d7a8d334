#include <cstdarg>
static int sum(int n, ...) {
  va_list list;
  va_start(list, n);
  int s = 0;
  for (int i = 0; i < n; ++i) s += va_arg(list, int);
  va_end(list);
  return s;
}
int variadic_call(int a, int b) { return sum(2, a, b); }
// error: 10:42: the call of 'sum(int, ...)' cannot be inlined; give the function's source among the files
