// Proof bench of rtl/axil_slave.v: the rules of AXI4-Lite for a slave, and that each transaction acts and is answered once.
//
// The master keeps its channels as AXI4-Lite demands; the register file behind answers anything.

`default_nettype none

module axil_slave_proof (
    input wire       clk,
    input wire       rst,
    input wire [3:0] awaddr,
    input wire       awvalid,
    input wire [1:0] wdata,
    input wire [3:0] wstrb,
    input wire       wvalid,
    input wire       bready,
    input wire [3:0] araddr,
    input wire       arvalid,
    input wire       rready,
    input wire       write_error,
    input wire [1:0] read_data,
    input wire       read_error,
    input wire       read_hold
);

    wire        awready, wready, bvalid, arready, rvalid, write_strobe;
    wire [1:0]  bresp, rresp, write_address, read_address;
    wire [31:0] rdata, write_data;

    axil_slave #(.ADDRESS_WIDTH(4)) slave (
        .clk(clk), .rst(rst),
        .s_axil_awaddr(awaddr), .s_axil_awvalid(awvalid), .s_axil_awready(awready),
        .s_axil_wdata({30'd0, wdata}), .s_axil_wstrb(wstrb), .s_axil_wvalid(wvalid), .s_axil_wready(wready),
        .s_axil_bresp(bresp), .s_axil_bvalid(bvalid), .s_axil_bready(bready),
        .s_axil_araddr(araddr), .s_axil_arvalid(arvalid), .s_axil_arready(arready),
        .s_axil_rdata(rdata), .s_axil_rresp(rresp), .s_axil_rvalid(rvalid), .s_axil_rready(rready),
        .write_strobe(write_strobe), .write_address(write_address), .write_data(write_data), .write_error(write_error),
        .read_hold(read_hold), .read_address(read_address), .read_data({30'd0, read_data}),
        .read_error(read_error)
    );

    wire good_write = (wstrb == 4'b1111) && (awaddr[1:0] == 2'b00);

    reg started = 1'b0;             // a reset came first
    reg past_reset;
    reg [9:0] past_write;           // address, data and strobes that wait
    reg       past_awaits, past_wwaits, past_arwaits, past_bwaits, past_rwaits;
    reg [3:0] past_araddr;
    reg [1:0] past_bresp, past_rresp, past_rdata;
    reg       owed_b, owed_r;       // transactions taken and not yet answered
    reg       expected_bresp, expected_rresp;
    reg [1:0] expected_rdata;
    reg [2:0] write_wait, read_wait;

    always @(posedge clk) begin
        started      <= 1'b1;
        past_reset   <= rst;
        past_awaits  <= awvalid && !awready;
        past_wwaits  <= wvalid && !wready;
        past_arwaits <= arvalid && !arready;
        past_bwaits  <= bvalid && !bready;
        past_rwaits  <= rvalid && !rready;
        past_write   <= {awaddr, wdata, wstrb};
        past_araddr  <= araddr;
        past_bresp   <= bresp;
        past_rresp   <= rresp;
        past_rdata   <= rdata[1:0];

        owed_b <= !rst && ((awvalid && awready) || (owed_b && !(bvalid && bready)));
        owed_r <= !rst && ((arvalid && arready) || (owed_r && !(rvalid && rready)));
        if (awvalid && awready)
            expected_bresp <= !good_write || write_error;
        if (arvalid && arready) begin
            expected_rdata <= read_data;
            expected_rresp <= read_error || (araddr[1:0] != 2'b00);
        end
        write_wait <= (!rst && awvalid && wvalid && !awready && !past_bwaits) ? write_wait + 1'b1 : 3'd0;
        read_wait  <= (!rst && arvalid && !arready && !past_rwaits && !read_hold) ? read_wait + 1'b1 : 3'd0;
    end

    always @* begin
        if (!started)
            assume (rst);
        if (started && !past_reset) begin
            assume (!past_awaits || (awvalid && awaddr == past_write[9:6]));
            assume (!past_wwaits || (wvalid && wdata == past_write[5:4] && wstrb == past_write[3:0]));
            assume (!past_arwaits || (arvalid && araddr == past_araddr));
        end
        if (started && !rst && !past_reset) begin
            assert (!past_bwaits || (bvalid && bresp == past_bresp));
            assert (!past_rwaits || (rvalid && rresp == past_rresp && rdata[1:0] == past_rdata));
        end
        if (started && !rst) begin
            assert (awready == wready);
            assert (!awready || (awvalid && wvalid));
            assert (!arready || arvalid);
            assert (!(awvalid && awready) || !owed_b || (bvalid && bready));
            assert (!(arvalid && arready) || !owed_r || (rvalid && rready));
            assert (bvalid == owed_b);
            assert (rvalid == owed_r);
            assert (write_strobe == (awvalid && awready && good_write));
            assert (!write_strobe || (write_address == awaddr[3:2] && write_data == {30'd0, wdata}));
            assert (!(arvalid && arready) || read_address == araddr[3:2]);
            assert (!bvalid || bresp == {expected_bresp, 1'b0});
            assert (!rvalid || (rresp == {expected_rresp, 1'b0} && rdata == {30'd0, expected_rdata}));
            assert (write_wait < 3'd4);
            assert (read_wait < 3'd4);
            cover (rvalid && rready && past_rwaits && bvalid && bready && bresp == 2'b00);
        end
    end

endmodule

`default_nettype wire
