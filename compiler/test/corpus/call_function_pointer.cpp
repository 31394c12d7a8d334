// Function pointers whose targets are known once the functions that take them are inlined.
// top: call_function_pointer
typedef int (*operation)(int, int);
static int add(int a, int b) { return a + b; }
static int subtract(int a, int b) { return a - b; }
static int apply(operation f, int a, int b) { return f(a, b); }
int call_function_pointer(bool down, int a, int b) { return down ? apply(subtract, a, b) : apply(&add, a, b); }
