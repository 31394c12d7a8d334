// FIFO with a valid/ready stream on both sides; the oldest word waits on m_data (first-word fall-through).
//
// Holds DEPTH words. A word taken on s_ is offered on m_ two cycles later (one cycle when DEPTH is 1 or 2); one word a cycle passes
// without a gap. s_ready, m_valid and m_data come straight from registers, but s_ready of DEPTH = 1 follows m_ready.
// DEPTH = 1 is a register, DEPTH = 2 a skid buffer. Otherwise DEPTH - 1 words lie in a RAM (LUT RAM when small, block RAM when large) and one in its
// read register; DEPTH = 2^n + 1 fills that RAM, DEPTH = 3 is the least that costs a RAM.
// Reset is synchronous and clears addresses and handshake only.

`default_nettype none

module fifo #(
    parameter WIDTH = 8,  // bits of a word, 1 or more
    parameter DEPTH = 17  // words, 1 or more
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

    function integer bits_for_address;  // the least number of bits that addresses this many words, at least 1
        input integer words;
        integer remaining;
        begin
            bits_for_address = 1;
            for (remaining = (words - 1) >> 1; remaining > 0; remaining = remaining >> 1)
                bits_for_address = bits_for_address + 1;
        end
    endfunction

    generate
        if (WIDTH < 1 || DEPTH < 1) begin : illegal
            fifo_needs_WIDTH_and_DEPTH_of_1_or_more stop ();
        end else if (DEPTH == 1) begin : register
            reg [WIDTH-1:0] word_reg;
            reg             valid_reg;

            assign s_ready = m_ready || !valid_reg;
            assign m_valid = valid_reg;
            assign m_data  = word_reg;

            always @(posedge clk) begin
                if (s_ready) begin
                    word_reg  <= s_data;
                    valid_reg <= s_valid;
                end
                if (rst)
                    valid_reg <= 1'b0;
            end
        end else if (DEPTH == 2) begin : registers
            skid_buffer #(
                .WIDTH(WIDTH)
            ) pair (
                .clk    (clk),
                .rst    (rst),
                .s_data (s_data),
                .s_valid(s_valid),
                .s_ready(s_ready),
                .m_data (m_data),
                .m_valid(m_valid),
                .m_ready(m_ready)
            );
        end else begin : ram
            localparam        ADDRESS_WIDTH = bits_for_address(DEPTH - 1);
            localparam [31:0] LAST_FREE = DEPTH - 2;  // words stored when one more fills the RAM

            reg [ADDRESS_WIDTH-1:0] write_address_reg;
            reg [ADDRESS_WIDTH-1:0] read_address_reg;
            reg [ADDRESS_WIDTH:0]   stored_reg;        // words in the RAM
            reg                     not_full_reg;
            reg                     not_empty_reg;
            reg                     output_valid_reg;

            wire write = s_valid && not_full_reg;
            wire read  = not_empty_reg && (m_ready || !output_valid_reg);

            assign s_ready = not_full_reg;
            assign m_valid = output_valid_reg;

            ram_1r1w #(
                .WIDTH        (WIDTH),
                .DEPTH        (1 << ADDRESS_WIDTH),
                .ADDRESS_WIDTH(ADDRESS_WIDTH)
            ) words (
                .clk          (clk),
                .write_enable (write),
                .write_address(write_address_reg),
                .write_data   (s_data),
                .read_enable  (read),
                .read_address (read_address_reg),
                .read_data    (m_data)
            );

            always @(posedge clk) begin
                if (write)
                    write_address_reg <= write_address_reg + 1'b1;
                if (read)
                    read_address_reg <= read_address_reg + 1'b1;

                if (write && !read) begin
                    stored_reg    <= stored_reg + 1'b1;
                    not_full_reg  <= (stored_reg != LAST_FREE[ADDRESS_WIDTH:0]);
                    not_empty_reg <= 1'b1;
                end else if (read && !write) begin
                    stored_reg    <= stored_reg - 1'b1;
                    not_full_reg  <= 1'b1;
                    not_empty_reg <= (stored_reg != 1);
                end

                if (read)
                    output_valid_reg <= 1'b1;
                else if (m_ready)
                    output_valid_reg <= 1'b0;

                if (rst) begin
                    write_address_reg <= 0;
                    read_address_reg  <= 0;
                    stored_reg        <= 0;
                    not_full_reg      <= 1'b1;
                    not_empty_reg     <= 1'b0;
                    output_valid_reg  <= 1'b0;
                end
            end
        end
    endgenerate

endmodule

`default_nettype wire
