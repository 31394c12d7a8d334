int pointer_to_pointer(int** table, int i) { return table[i & 3][i & 7]; }
// error: 1:30: type 'int *' cannot be a value in hardware; use integers, bool, ap_int, ap_fixed or structs of them
