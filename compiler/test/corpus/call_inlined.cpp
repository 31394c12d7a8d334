// A small function called many times, inlined.
// top: call_inlined
static int clamp(int v, int low, int high) { return v < low ? low : (v > high ? high : v); }
int call_inlined(int a, int b) { return clamp(a, -100, 100) + clamp(b, 0, 255) + clamp(a + b, -7, 7); }
