int table(int a) { return a + 1; }
// top: table
// error: 1:5: 'table' is a word of Verilog and cannot name the top; rename it
