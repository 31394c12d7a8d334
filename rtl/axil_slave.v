// AXI4-Lite slave: turns the five channels into a write strobe and a read address for a register file whose reads have no effect.
//
// Writes: write_strobe is 1 for one cycle with address and data; write_error is looked at in that cycle. A write whose WSTRB is
// not 1111, or whose address is not that of a word, is answered with SLVERR and gives no strobe: registers are written whole.
// Reads: read_data and read_error are looked at while the address is there. An address that is not that of a word is answered with
// SLVERR, too.
// One transaction of each kind at a time, three cycles each. Every output comes from a register.

`default_nettype none

module axil_slave #(
    parameter ADDRESS_WIDTH = 13  // bits of a byte address
) (
    input  wire                     clk,
    input  wire                     rst,

    input  wire [ADDRESS_WIDTH-1:0] s_axil_awaddr,
    input  wire                     s_axil_awvalid,
    output wire                     s_axil_awready,
    input  wire [31:0]              s_axil_wdata,
    input  wire [3:0]               s_axil_wstrb,
    input  wire                     s_axil_wvalid,
    output wire                     s_axil_wready,
    output wire [1:0]               s_axil_bresp,
    output wire                     s_axil_bvalid,
    input  wire                     s_axil_bready,
    input  wire [ADDRESS_WIDTH-1:0] s_axil_araddr,
    input  wire                     s_axil_arvalid,
    output wire                     s_axil_arready,
    output wire [31:0]              s_axil_rdata,
    output wire [1:0]               s_axil_rresp,
    output wire                     s_axil_rvalid,
    input  wire                     s_axil_rready,

    output wire                     write_strobe,
    output wire [ADDRESS_WIDTH-3:0] write_address,  // of a word
    output wire [31:0]              write_data,
    input  wire                     write_error,
    input  wire                     read_hold,      // no read is answered in the cycle after
    output wire [ADDRESS_WIDTH-3:0] read_address,   // of a word
    input  wire [31:0]              read_data,
    input  wire                     read_error
);

    localparam [1:0] OKAY   = 2'b00;
    localparam [1:0] SLVERR = 2'b10;

    reg        write_ready_reg;  // address and data are both there and are taken in this cycle
    reg        whole_word_reg;   // of the cycle before; a master keeps address and data until they are taken
    reg        write_failed_reg;
    reg        bvalid_reg;
    reg        read_ready_reg;   // the address is taken in this cycle
    reg        read_failed_reg;
    reg        rvalid_reg;
    reg [31:0] rdata_reg;

    wire whole_word = (s_axil_wstrb == 4'b1111) && (s_axil_awaddr[1:0] == 2'b00);

    assign s_axil_awready = write_ready_reg;
    assign s_axil_wready  = write_ready_reg;
    assign s_axil_bresp   = write_failed_reg ? SLVERR : OKAY;
    assign s_axil_bvalid  = bvalid_reg;
    assign s_axil_arready = read_ready_reg;
    assign s_axil_rdata   = rdata_reg;
    assign s_axil_rresp   = read_failed_reg ? SLVERR : OKAY;
    assign s_axil_rvalid  = rvalid_reg;

    assign write_strobe  = write_ready_reg && whole_word_reg;
    assign write_address = s_axil_awaddr[ADDRESS_WIDTH-1:2];
    assign write_data    = s_axil_wdata;
    assign read_address  = s_axil_araddr[ADDRESS_WIDTH-1:2];

    always @(posedge clk) begin
        whole_word_reg  <= whole_word;
        write_ready_reg <= s_axil_awvalid && s_axil_wvalid && !write_ready_reg && !bvalid_reg;
        if (write_ready_reg) begin
            write_failed_reg <= write_error || !whole_word_reg;
            bvalid_reg       <= 1'b1;
        end else if (s_axil_bready) begin
            bvalid_reg       <= 1'b0;
        end

        read_ready_reg <= s_axil_arvalid && !read_hold && !read_ready_reg && !rvalid_reg;
        if (read_ready_reg) begin
            rdata_reg       <= read_data;
            read_failed_reg <= read_error || (s_axil_araddr[1:0] != 2'b00);
            rvalid_reg      <= 1'b1;
        end else if (s_axil_rready) begin
            rvalid_reg      <= 1'b0;
        end

        if (rst) begin
            write_ready_reg <= 1'b0;
            bvalid_reg      <= 1'b0;
            read_ready_reg  <= 1'b0;
            rvalid_reg      <= 1'b0;
        end
    end

endmodule

`default_nettype wire
