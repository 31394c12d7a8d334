// Techmaps that make Yosys's carry chains for Xilinx smaller; flow.py uses them.

// An adder whose operands are to be exchanged: A + B as B + A. What subtracts stays.
(* techmap_celltype = "$alu_swapped" *)
module swap_operands (A, B, CI, BI, X, Y, CO);
    parameter A_SIGNED = 0;
    parameter B_SIGNED = 0;
    parameter A_WIDTH = 1;
    parameter B_WIDTH = 1;
    parameter Y_WIDTH = 1;
    parameter _TECHMAP_CONSTMSK_BI_ = 0;
    parameter _TECHMAP_CONSTVAL_BI_ = 0;

    input [A_WIDTH-1:0] A;
    input [B_WIDTH-1:0] B;
    input CI, BI;
    output [Y_WIDTH-1:0] X, Y, CO;

    generate
        if (_TECHMAP_CONSTMSK_BI_ && !_TECHMAP_CONSTVAL_BI_)
            \$alu #(.A_SIGNED(B_SIGNED), .B_SIGNED(A_SIGNED), .A_WIDTH(B_WIDTH), .B_WIDTH(A_WIDTH), .Y_WIDTH(Y_WIDTH))
                alu (.A(B), .B(A), .CI(CI), .BI(BI), .X(X), .Y(Y), .CO(CO));
        else
            \$alu #(.A_SIGNED(A_SIGNED), .B_SIGNED(B_SIGNED), .A_WIDTH(A_WIDTH), .B_WIDTH(B_WIDTH), .Y_WIDTH(Y_WIDTH))
                alu (.A(A), .B(B), .CI(CI), .BI(BI), .X(X), .Y(Y), .CO(CO));
    endgenerate
endmodule

// A <= B as !(B < A) and A >= B as !(A < B), which the last carry tells. Yosys's own form adds a test for equality in LUTs.
(* techmap_celltype = "$le $ge" *)
module not_less (A, B, Y);
    parameter A_SIGNED = 0;
    parameter B_SIGNED = 0;
    parameter A_WIDTH = 1;
    parameter B_WIDTH = 1;
    parameter Y_WIDTH = 1;
    parameter _TECHMAP_CELLTYPE_ = "";

    input [A_WIDTH-1:0] A;
    input [B_WIDTH-1:0] B;
    output [Y_WIDTH-1:0] Y;

    wire less;
    assign Y = !less;

    generate
        if (_TECHMAP_CELLTYPE_ == "$le")
            \$lt #(.A_SIGNED(B_SIGNED), .B_SIGNED(A_SIGNED), .A_WIDTH(B_WIDTH), .B_WIDTH(A_WIDTH), .Y_WIDTH(1)) compare (.A(B), .B(A), .Y(less));
        else
            \$lt #(.A_SIGNED(A_SIGNED), .B_SIGNED(B_SIGNED), .A_WIDTH(A_WIDTH), .B_WIDTH(B_WIDTH), .Y_WIDTH(1)) compare (.A(A), .B(B), .Y(less));
    endgenerate
endmodule
