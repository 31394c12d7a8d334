float float_argument(float x) { return x * 2.0f; }
