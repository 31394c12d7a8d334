int recursion_direct(int n) { return n <= 1 ? 1 : n + recursion_direct(n / 2) + recursion_direct(n / 3); }
// error: 1: function '_Z16recursion_directi' calls itself; hardware has no call stack, write a loop with an explicit stack array
