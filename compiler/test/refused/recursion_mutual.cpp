static int odd(int n);
static int even(int n) { return n == 0 ? 1 : odd(n - 1) + odd(n / 2); }
static int odd(int n) { return n == 0 ? 0 : even(n - 1) + even(n / 3); }
int recursion_mutual(int n) { return even(n); }
// error: 3: function '_ZL3oddi' calls itself; hardware has no call stack, write a loop with an explicit stack array
