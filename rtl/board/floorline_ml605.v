// The demonstration on the ML605 (xc6vlx240t): 66 MHz user clock, 115200 baud on the USB serial line, CPU_RESET resets.

`default_nettype none

module floorline_ml605 (
    input  wire USER_CLOCK,
    input  wire CPU_RESET,
    output wire USB_1_RX,    // towards the USB bridge
    output wire GPIO_LED_0
);

    reg [1:0] rst_reg;

    always @(posedge USER_CLOCK)
        rst_reg <= {rst_reg[0], CPU_RESET};

    demonstration #(
        .CYCLES_PER_BIT(573)
    ) demo (
        .clk        (USER_CLOCK),
        .rst        (rst_reg[1]),
        .txd        (USB_1_RX),
        .frame_light(GPIO_LED_0)
    );

endmodule

`default_nettype wire
