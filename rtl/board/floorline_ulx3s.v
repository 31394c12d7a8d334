// The demonstration on the ULX3S (LFE5U-85F): 25 MHz oscillator, 115200 baud on the USB serial line, button FIRE1 resets.

`default_nettype none

module floorline_ulx3s (
    input  wire       clk_25mhz,
    input  wire [6:0] btn,
    output wire       ftdi_rxd,
    output wire [7:0] led
);

    reg  [1:0] rst_reg;
    wire       frame_light;
    wire       unused_buttons = &{1'b0, btn[6:2], btn[0]};

    always @(posedge clk_25mhz)
        rst_reg <= {rst_reg[0], btn[1]};

    assign led = {7'd0, frame_light};

    demonstration #(
        .CYCLES_PER_BIT(217)
    ) demo (
        .clk        (clk_25mhz),
        .rst        (rst_reg[1]),
        .txd        (ftdi_rxd),
        .frame_light(frame_light)
    );

endmodule

`default_nettype wire
