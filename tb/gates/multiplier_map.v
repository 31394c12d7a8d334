// In a netlist, what Yosys has for a product ($mul) becomes a multiplier_cell.

module \$mul (A, B, Y);
    parameter A_SIGNED = 0, B_SIGNED = 0, A_WIDTH = 1, B_WIDTH = 1, Y_WIDTH = 1;
    input  [A_WIDTH-1:0] A;
    input  [B_WIDTH-1:0] B;
    output [Y_WIDTH-1:0] Y;

    multiplier_cell #(
        .IS_SIGNED(A_SIGNED && B_SIGNED),
        .A_WIDTH  (A_WIDTH),
        .B_WIDTH  (B_WIDTH),
        .Y_WIDTH  (Y_WIDTH)
    ) _TECHMAP_REPLACE_ (
        .A(A),
        .B(B),
        .Y(Y)
    );
endmodule
