// Line table: LineSetup of each line for the polar engine, in two banks, so that the host can write a new set while the core reads.
//
// The host writes 32-bit words, four to a line; the core reads a whole line one cycle after read_enable.

`default_nettype none

module line_table #(
    parameter LOG2_LINES = 7,   // lines of a bank
    parameter LINE_WIDTH = 111  // bits of a LineSetup, at most 128
) (
    input  wire                  clk,

    input  wire                  read_bank,      // bank of the core; the host writes the other one

    input  wire                  write,
    input  wire [9:0]            write_address,  // line << 2 | word
    input  wire [31:0]           write_data,

    input  wire                  read_enable,
    input  wire [LOG2_LINES-1:0] read_line,
    output wire [LINE_WIDTH-1:0] read_data
);

    wire [LOG2_LINES-1:0] write_line = write_address[LOG2_LINES+1:2];
    wire                  beyond     = (write_address >> (LOG2_LINES + 2)) != 10'd0;  // a line that this build does not hold

    genvar word;
    generate
        for (word = 0; word < 4; word = word + 1) begin : words
            localparam LEFT  = LINE_WIDTH - 32 * word;
            localparam WIDTH = LEFT > 32 ? 32 : LEFT;

            ram_1r1w #(
                .WIDTH        (WIDTH),
                .DEPTH        (2 << LOG2_LINES),
                .ADDRESS_WIDTH(LOG2_LINES + 1)
            ) ram (
                .clk          (clk),
                .write_enable (write && !beyond && write_address[1:0] == word),
                .write_address({!read_bank, write_line}),
                .write_data   (write_data[WIDTH-1:0]),
                .read_enable  (read_enable),
                .read_address ({read_bank, read_line}),
                .read_data    (read_data[32*word +: WIDTH])
            );
        end
    endgenerate

endmodule

`default_nettype wire
