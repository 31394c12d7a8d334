int recursion_direct(int n) { return n <= 1 ? 1 : n + recursion_direct(n / 2) + recursion_direct(n / 3); }
