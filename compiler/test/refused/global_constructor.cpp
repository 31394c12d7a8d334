int measured();
struct Limits {
  int top;
  Limits() : top(measured()) {}
};
static Limits limits;
int global_constructor(int x) { return x < limits.top ? x : limits.top; }
// error: 4:18: the constructor of this global object cannot be run at compile time; make it constexpr, or move the object into the function as a static local
