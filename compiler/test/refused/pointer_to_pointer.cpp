int pointer_to_pointer(int** table, int i) { return table[i & 3][i & 7]; }
// error: the parameters of 'pointer_to_pointer' have no hardware form; use integers, ap types, structs, arrays of known size and hls::stream references
