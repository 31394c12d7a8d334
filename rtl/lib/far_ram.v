// RAM of so many blocks that they lie far apart: one write port, one read port, one clock. Every way across the die has a cycle of its own.
//
// A read takes six cycles. read_enable takes the address; a stage of the reader's pipeline later, advance[1] tells that the reader moves on,
// and so on to advance[5], behind which read_data is the word. Nothing in between waits for the reader: the address goes to a register at its
// block, through the block, a register in it, one behind it and one behind the choice among the blocks into a short buffer. Where the word lies
// there goes along with the reader; a reader that drops a read just no longer asks for its word.
// Reads see writes as in ram_1r1w: from the next cycle on; a read of the address that is written in the same cycle is undefined. Contents
// start as zero, as those of block RAM do.

`default_nettype none

module far_ram #(
    parameter WIDTH         = 8,      // bits of a word, 1 or more
    parameter DEPTH         = 65536,  // words, more than one block's
    parameter ADDRESS_WIDTH = 16,     // bits of an address, the least with 2^ADDRESS_WIDTH >= DEPTH
    parameter BLOCK_ADDRESS = 14      // bits of an address within a block
) (
    input  wire                     clk,

    input  wire                     write_enable,
    input  wire [ADDRESS_WIDTH-1:0] write_address,
    input  wire [WIDTH-1:0]         write_data,

    input  wire                     read_enable,
    input  wire [ADDRESS_WIDTH-1:0] read_address,
    input  wire [5:1]               advance,
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
    localparam SLOT_WIDTH   = 3;  // more words than a read has cycles

    wire [CHOICE_WIDTH-1:0] write_choice = write_address[ADDRESS_WIDTH-1:BLOCK_ADDRESS];
    wire [CHOICE_WIDTH-1:0] read_choice  = read_address[ADDRESS_WIDTH-1:BLOCK_ADDRESS];
    wire [WIDTH-1:0]        outputs [0:BLOCKS-1];

    genvar block;
    generate
        for (block = 0; block < BLOCKS; block = block + 1) begin : blocks
            localparam [CHOICE_WIDTH-1:0] CHOICE = block;
            localparam WORDS = (block == BLOCKS - 1) ? DEPTH - block * BLOCK_DEPTH : BLOCK_DEPTH;
            localparam WORD_ADDRESS = bits_for_address(WORDS);  // the last block may be small

            (* no_rw_check *)
            reg [WIDTH-1:0]        memory [0:WORDS-1];
            reg                    write_reg;
            reg [WORD_ADDRESS-1:0] write_address_reg;
            reg [WIDTH-1:0]        write_data_reg;
            reg [WORD_ADDRESS-1:0] read_address_reg;
            reg [WIDTH-1:0]        read_reg;
            reg [WIDTH-1:0]        output_reg;
            reg [WIDTH-1:0]        behind_reg;

            assign outputs[block] = behind_reg;

            // Registers of a block stand still while another one is meant: so each block has its own, beside it.
            always @(posedge clk) begin
                write_reg <= write_enable && write_choice == CHOICE;
                if (write_choice == CHOICE) begin
                    write_address_reg <= write_address[WORD_ADDRESS-1:0];
                    write_data_reg    <= write_data;
                end
                if (write_reg)
                    memory[write_address_reg] <= write_data_reg;

                if (read_choice == CHOICE)
                    read_address_reg <= read_address[WORD_ADDRESS-1:0];
                read_reg   <= memory[read_address_reg];
                output_reg <= read_reg;
                behind_reg <= output_reg;
            end

`ifndef SYNTHESIS
            integer index;
            initial
                for (index = 0; index < WORDS; index = index + 1)
                    memory[index] = {WIDTH{1'b0}};
`endif
        end
    endgenerate

    // Beside the word, of each of its cycles: the block it comes from, and the slot of the buffer that it gets.
    reg [4*CHOICE_WIDTH-1:0] choices_reg;
    reg [5*SLOT_WIDTH-1:0]   slots_reg;
    reg [SLOT_WIDTH-1:0]     next_slot_reg = 0;
    reg [WIDTH-1:0]          chosen_reg;

    wire [CHOICE_WIDTH-1:0] choice = choices_reg[3*CHOICE_WIDTH +: CHOICE_WIDTH];
    wire [SLOT_WIDTH-1:0]   slot   = slots_reg[4*SLOT_WIDTH +: SLOT_WIDTH];

    always @(posedge clk) begin
        if (read_enable)
            next_slot_reg <= next_slot_reg + 1'b1;
        choices_reg <= {choices_reg[3*CHOICE_WIDTH-1:0], read_choice};
        slots_reg   <= {slots_reg[4*SLOT_WIDTH-1:0], next_slot_reg};
        chosen_reg  <= outputs[choice];
    end

    // What comes without having been read lies in the slot of the next word, until that one comes.
    (* ram_style = "distributed", no_rw_check *)
    reg [WIDTH-1:0]        buffer [0:(1 << SLOT_WIDTH) - 1];
    reg [6*SLOT_WIDTH-1:0] asked_reg;  // of each stage of the reader: the slot of its word
    integer                stage;

    assign read_data = buffer[asked_reg[5*SLOT_WIDTH +: SLOT_WIDTH]];

    always @(posedge clk) begin
        buffer[slot] <= chosen_reg;
        if (read_enable)
            asked_reg[0 +: SLOT_WIDTH] <= next_slot_reg;
        for (stage = 1; stage <= 5; stage = stage + 1)
            if (advance[stage])
                asked_reg[stage*SLOT_WIDTH +: SLOT_WIDTH] <= asked_reg[(stage-1)*SLOT_WIDTH +: SLOT_WIDTH];
    end

endmodule

`default_nettype wire
