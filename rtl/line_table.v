// Line table: LineSetup of each line for the polar engine, in two banks, so that the host can write a new set while the core reads.
//
// The host writes 32-bit words, four to a line; a line enters the table with its last word. The core has a line one cycle after
// its enable.
//
// A line has 111 bits and block RAMs have 36: the top bits of first_row, last_row and first_error are not kept. They are 0, since rows of an
// image and errors (below the divisor, which is at most 2047) are below 2048; without them three RAMs hold a line.

`default_nettype none

module line_table #(
    parameter LOG2_LINES = 8  // lines of a bank
) (
    input  wire                     clk,

    input  wire                     read_bank,      // bank of the core; the host writes the other one

    input  wire                     write,
    input  wire [9:0]               write_address,  // line << 2 | word
    input  wire [31:0]              write_data,

    input  wire                     read_enable,
    input  wire [LOG2_LINES-1:0]    read_line,
    output wire [110:0]             read_data       // LineSetup, first member in the lowest bits
);

    // The words before the last one wait here.
    reg  [95:0]           words_reg;
    wire [LOG2_LINES-1:0] write_line = write_address[LOG2_LINES+1:2];
    wire                  beyond     = (write_address >> (LOG2_LINES + 2)) != 10'd0;  // a line that this build does not hold
    wire                  complete   = write && !beyond && (write_address[1:0] == 2'd3);
    wire [110:0]          line       = {write_data[14:0], words_reg};
    wire [107:0]          kept       = {line[110:109], line[107:37], line[35:25], line[23:0]};
    wire [107:0]          stored;
    wire                  unused_top = &{1'b0, write_data[31:15], line[108], line[36], line[24]};

    assign read_data = {stored[107:106], 1'b0, stored[105:35], 1'b0, stored[34:24], 1'b0, stored[23:0]};

    always @(posedge clk) begin
        if (write && write_address[1:0] == 2'd0)
            words_reg[31:0] <= write_data;
        if (write && write_address[1:0] == 2'd1)
            words_reg[63:32] <= write_data;
        if (write && write_address[1:0] == 2'd2)
            words_reg[95:64] <= write_data;
    end

    ram_1r1w #(
        .WIDTH        (108),
        .DEPTH        (2 << LOG2_LINES),
        .ADDRESS_WIDTH(LOG2_LINES + 1)
    ) ram (
        .clk          (clk),
        .write_enable (complete),
        .write_address({!read_bank, write_line}),
        .write_data   (kept),
        .read_enable  (read_enable),
        .read_address ({read_bank, read_line}),
        .read_data    (stored)
    );

endmodule

`default_nettype wire
