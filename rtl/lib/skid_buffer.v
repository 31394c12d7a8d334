// Skid buffer: two registers that cut the combinational paths of a valid/ready stream in both directions.
//
// A word taken on s_ is offered on m_ one cycle later; one word a cycle passes without a gap. s_ready, m_valid and m_data come
// straight from registers, so that long chains of stages keep short paths. Holds two words.
// Reset is synchronous and clears the handshake only; data registers have none.

`default_nettype none

module skid_buffer #(
    parameter WIDTH = 8  // bits of a word, 1 or more
) (
    input  wire             clk,
    input  wire             rst,

    input  wire [WIDTH-1:0] s_data,
    input  wire             s_valid,
    output wire             s_ready,

    output wire [WIDTH-1:0] m_data,
    output wire             m_valid,
    input  wire             m_ready
);

    reg [WIDTH-1:0] output_reg;
    reg [WIDTH-1:0] spare_reg;         // holds the word that came while the output was stalled
    reg             output_valid_reg;
    reg             spare_free_reg;

    wire output_moves = m_ready || !output_valid_reg;

    assign s_ready = spare_free_reg;
    assign m_valid = output_valid_reg;
    assign m_data  = output_reg;

    always @(posedge clk) begin
        if (output_moves)
            output_reg <= spare_free_reg ? s_data : spare_reg;
        if (spare_free_reg)
            spare_reg <= s_data;

        if (output_moves) begin
            output_valid_reg <= s_valid || !spare_free_reg;
            spare_free_reg   <= 1'b1;
        end else if (s_valid) begin
            spare_free_reg   <= 1'b0;
        end

        if (rst) begin
            output_valid_reg <= 1'b0;
            spare_free_reg   <= 1'b1;
        end
    end

endmodule

`default_nettype wire
