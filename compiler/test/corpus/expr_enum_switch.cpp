// enum and switch with fall-through and default.
// top: expr_enum_switch
enum Operation { ADD, SUBTRACT, DOUBLE, NEGATE };
int expr_enum_switch(unsigned char code, int a, int b) {
  int result = 0;
  switch (static_cast<Operation>(code & 7)) {
    case ADD: result = a + b; break;
    case SUBTRACT: result = a - b; break;
    case DOUBLE: result = a;  // fall through
    case NEGATE: result -= 2 * a; break;
    default: result = b; break;
  }
  return result;
}
