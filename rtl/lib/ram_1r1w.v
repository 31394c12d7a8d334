// Simple dual-port RAM: one write port, one read port, one clock.
//
// read_data belongs to the read_address of the cycle before in which read_enable was 1, and stays until the next such cycle.
// A read of the address that is written in the same cycle is undefined, as in the block RAM of every target family; the
// simulation gives X (where SIMULATION is defined), so that a design that depends on it is found.
// Maps to block RAM, or to LUT RAM and a register where DEPTH is small. Contents are undefined until written.

`default_nettype none

module ram_1r1w #(
    parameter WIDTH         = 8,   // bits of a word, 1 or more
    parameter DEPTH         = 512, // words, 2 or more
    parameter ADDRESS_WIDTH = 9    // bits of an address, the least with 2^ADDRESS_WIDTH >= DEPTH
) (
    input  wire                     clk,

    input  wire                     write_enable,
    input  wire [ADDRESS_WIDTH-1:0] write_address,
    input  wire [WIDTH-1:0]         write_data,

    input  wire                     read_enable,
    input  wire [ADDRESS_WIDTH-1:0] read_address,
    output wire [WIDTH-1:0]         read_data
);

    (* no_rw_check *)
    reg [WIDTH-1:0] memory [0:DEPTH-1];
    reg [WIDTH-1:0] read_reg;

    assign read_data = read_reg;

    always @(posedge clk) begin
        if (write_enable)
            memory[write_address] <= write_data;
        if (read_enable)
            read_reg <= memory[read_address];
`ifdef SIMULATION
        if (read_enable && write_enable && read_address == write_address)
            read_reg <= {WIDTH{1'bx}};
`endif
    end

endmodule

`default_nettype wire
