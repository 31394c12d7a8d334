// Techmap for $alu_swapped, the adders whose operands flow.py (XILINX_OPERANDS) wants exchanged: A + B as B + A. What subtracts stays.

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
