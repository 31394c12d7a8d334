// A variadic template.
// top: language_variadic_template
static int sum() { return 0; }
template <class First, class... Rest>
static int sum(First first, Rest... rest) {
  return first + sum(rest...);
}
int language_variadic_template(int a, short b, signed char c) { return sum(a, b, c, 7); }
