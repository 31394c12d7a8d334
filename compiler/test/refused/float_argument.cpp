float float_argument(float x) { return x * 2.0f; }
// error: 1:28: 'float' has no operators in hardware yet; use ap_fixed<W, I>
