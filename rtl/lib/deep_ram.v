// RAM of more words than a block holds: one write port, one read port, one clock; in blocks of the powers of two that an FPGA makes of block
// RAM without logic.
//
// Ports and rules as in ram_1r1w.v. Contents start as zero, as those of block RAM do. Where the blocks are many and slow to reach: far_ram.v.

`default_nettype none

module deep_ram #(
    parameter WIDTH         = 8,      // bits of a word, 1 or more
    parameter DEPTH         = 65537,  // words, more than one block's
    parameter ADDRESS_WIDTH = 17,     // bits of an address, the least with 2^ADDRESS_WIDTH >= DEPTH
    parameter BLOCK_ADDRESS = 16      // bits of an address within a block
) (
    input  wire                     clk,

    input  wire                     write_enable,
    input  wire [ADDRESS_WIDTH-1:0] write_address,
    input  wire [WIDTH-1:0]         write_data,

    input  wire                     read_enable,
    input  wire [ADDRESS_WIDTH-1:0] read_address,
    output wire [WIDTH-1:0]         read_data
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

    localparam BLOCK_DEPTH  = 1 << BLOCK_ADDRESS;
    localparam BLOCKS       = (DEPTH + BLOCK_DEPTH - 1) / BLOCK_DEPTH;
    localparam CHOICE_WIDTH = ADDRESS_WIDTH - BLOCK_ADDRESS;

    reg  [CHOICE_WIDTH-1:0] read_choice_reg;
    wire [WIDTH-1:0]        outputs [0:BLOCKS-1];

    assign read_data = outputs[read_choice_reg];

    always @(posedge clk)
        if (read_enable)
            read_choice_reg <= read_address[ADDRESS_WIDTH-1:BLOCK_ADDRESS];

    genvar block;
    generate
        for (block = 0; block < BLOCKS; block = block + 1) begin : blocks
            localparam [CHOICE_WIDTH-1:0] CHOICE = block;
            localparam WORDS = (block == BLOCKS - 1) ? DEPTH - block * BLOCK_DEPTH : BLOCK_DEPTH;
            localparam WORD_ADDRESS = bits_for_address(WORDS);  // the last block may be small

            (* no_rw_check *)
            reg [WIDTH-1:0] memory [0:WORDS-1];
            reg [WIDTH-1:0] read_reg;

            assign outputs[block] = read_reg;

            always @(posedge clk) begin
                if (write_enable && write_address[ADDRESS_WIDTH-1:BLOCK_ADDRESS] == CHOICE)
                    memory[write_address[WORD_ADDRESS-1:0]] <= write_data;
                if (read_enable)
                    read_reg <= memory[read_address[WORD_ADDRESS-1:0]];
            end

`ifndef SYNTHESIS
            integer index;
            initial
                for (index = 0; index < WORDS; index = index + 1)
                    memory[index] = {WIDTH{1'b0}};
`endif
        end
    endgenerate

endmodule

`default_nettype wire
