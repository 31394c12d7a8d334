int pointer_to_pointer(int** table, int i) { return table[i & 3][i & 7]; }
