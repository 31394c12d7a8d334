// A pointer to a scalar, read and written.
// top: call_pointer_scalar
void call_pointer_scalar(int* total, int add) { *total += add; }
