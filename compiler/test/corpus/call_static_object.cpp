// A static object keeps state across calls.
// top: call_static_object
// calls: 10
// expect: memory filter registers 3x32
struct Filter {
  int history[3];
  int step(int x) {
    int y = x + history[0] - history[2];
    history[2] = history[1];
    history[1] = history[0];
    history[0] = x;
    return y;
  }
};
int call_static_object(int x) {
  static Filter filter = {{0, 0, 0}};
  return filter.step(x);
}
