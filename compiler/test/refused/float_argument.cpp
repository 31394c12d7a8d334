float float_argument(float x) { return x * 2.0f; }
// error: the parameters of 'float_argument' have no hardware form; use integers, ap types, structs, arrays of known size and hls::stream references
