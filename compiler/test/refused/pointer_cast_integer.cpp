int pointer_cast_integer(unsigned long address) { return *reinterpret_cast<int*>(address); }
// error: 1:59: this pointer may point to several objects; access each array by its own name with a subscript
