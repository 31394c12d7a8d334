// FIFO for the scalars of a process: wide, few words, and each word stays at the output for the whole run of a process.
//
// Ports and rules as in fifo.v, but m_data comes straight from LUT RAM: no output register, which for some hundred bits costs more
// than it gives. Holds DEPTH words. A word taken on s_ is offered on m_ one cycle later. s_ready and m_valid are registers.

`default_nettype none

module scalar_fifo #(
    parameter WIDTH = 64,  // bits of a word, 1 or more
    parameter DEPTH = 4    // words, a power of two, 2 to 32
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

    localparam ADDRESS_WIDTH = (DEPTH == 2) ? 1 : (DEPTH == 4) ? 2 : (DEPTH == 8) ? 3 : (DEPTH == 16) ? 4 : 5;

    generate
        if (WIDTH < 1 || DEPTH != (1 << ADDRESS_WIDTH)) begin : illegal
            scalar_fifo_needs_WIDTH_of_1_or_more_and_DEPTH_of_2_4_8_16_or_32 stop ();
        end
    endgenerate

    (* ram_style = "distributed" *)
    reg [WIDTH-1:0]         words [0:DEPTH-1];
    reg [ADDRESS_WIDTH-1:0] write_address_reg;
    reg [ADDRESS_WIDTH-1:0] read_address_reg;
    reg                     not_full_reg;
    reg                     not_empty_reg;

    wire [ADDRESS_WIDTH-1:0] next_write = write_address_reg + 1'b1;
    wire [ADDRESS_WIDTH-1:0] next_read  = read_address_reg + 1'b1;
    wire                     write      = s_valid && not_full_reg;
    wire                     read       = m_ready && not_empty_reg;

    assign s_ready = not_full_reg;
    assign m_valid = not_empty_reg;
    assign m_data  = words[read_address_reg];

    always @(posedge clk) begin
        if (write) begin
            words[write_address_reg] <= s_data;
            write_address_reg        <= next_write;
        end
        if (read)
            read_address_reg <= next_read;

        if (write && !read) begin
            not_empty_reg <= 1'b1;
            not_full_reg  <= (next_write != read_address_reg);
        end else if (read && !write) begin
            not_full_reg  <= 1'b1;
            not_empty_reg <= (next_read != write_address_reg);
        end

        if (rst) begin
            write_address_reg <= {ADDRESS_WIDTH{1'b0}};
            read_address_reg  <= {ADDRESS_WIDTH{1'b0}};
            not_full_reg      <= 1'b1;
            not_empty_reg     <= 1'b0;
        end
    end

endmodule

`default_nettype wire
