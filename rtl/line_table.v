// Line table: LineSetup of each line for the polar engine, in two banks, so that the host can write a new set while the core reads.
//
// The host writes 32-bit words, four to a line; a line enters the table with its last word. The core has a line one cycle after
// its enable.

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
    wire                  unused_top = &{1'b0, write_data[31:15]};

    always @(posedge clk) begin
        if (write && write_address[1:0] == 2'd0)
            words_reg[31:0] <= write_data;
        if (write && write_address[1:0] == 2'd1)
            words_reg[63:32] <= write_data;
        if (write && write_address[1:0] == 2'd2)
            words_reg[95:64] <= write_data;
    end

    ram_1r1w #(
        .WIDTH        (111),
        .DEPTH        (2 << LOG2_LINES),
        .ADDRESS_WIDTH(LOG2_LINES + 1)
    ) ram (
        .clk          (clk),
        .write_enable (complete),
        .write_address({!read_bank, write_line}),
        .write_data   (line),
        .read_enable  (read_enable),
        .read_address ({read_bank, read_line}),
        .read_data    (read_data)
    );

endmodule

`default_nettype wire
