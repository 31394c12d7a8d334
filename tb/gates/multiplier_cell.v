// A multiplier of a netlist (scripts/gate_level.sh): Yosys has no open model of the DSP blocks.

`default_nettype none

module multiplier_cell #(
    parameter IS_SIGNED = 0,
    parameter A_WIDTH   = 1,
    parameter B_WIDTH   = 1,
    parameter Y_WIDTH   = 1
) (
    input  wire [A_WIDTH-1:0] A,
    input  wire [B_WIDTH-1:0] B,
    output wire [Y_WIDTH-1:0] Y
);

    generate
        if (IS_SIGNED) begin : signed_product
            wire signed [Y_WIDTH-1:0] product = $signed(A) * $signed(B);
            assign Y = product;
        end else begin : unsigned_product
            assign Y = A * B;
        end
    endgenerate

endmodule

`default_nettype wire
