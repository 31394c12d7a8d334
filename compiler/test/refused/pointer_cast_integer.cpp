int pointer_cast_integer(unsigned long address) { return *reinterpret_cast<int*>(address); }
