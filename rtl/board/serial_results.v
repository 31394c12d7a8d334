// Floor points on a serial line, readable in any terminal: "uuu vvv" in hexadecimal, a line each, "-" after each frame.
//
// The line is slow: what comes while its queue is full is left out, so that the core never waits.

`default_nettype none

module serial_results #(
    parameter CYCLES_PER_BIT = 217  // clock over baud rate, at most 65535
) (
    input  wire        clk,
    input  wire        rst,

    input  wire        point,       // one leaves the core
    input  wire        point_end,   // it is the end of a frame
    input  wire [11:0] point_u,
    input  wire [11:0] point_v,

    output wire        txd
);

    localparam [31:0] LAST_CYCLE = CYCLES_PER_BIT - 1;

    wire        queued_end, queued, unused_room;
    wire [11:0] u, v;
    reg         take_reg;

    fifo #(
        .WIDTH(25),
        .DEPTH(33)
    ) queue (
        .clk    (clk),
        .rst    (rst),
        .s_data ({point_end, point_u, point_v}),
        .s_valid(point),
        .s_ready(unused_room),
        .m_data ({queued_end, u, v}),
        .m_valid(queued),
        .m_ready(take_reg)
    );

    // Letter `letter_reg` of the line, then its ten bits, start bit first.
    reg  [3:0]  letter_reg;
    reg  [9:0]  bits_reg;
    reg  [3:0]  bits_left_reg;
    reg  [15:0] cycle_reg;
    reg  [7:0]  letter;
    wire        last_letter = queued_end ? (letter_reg == 4'd2) : (letter_reg == 4'd8);
    wire        sending     = (bits_left_reg != 4'd0);

    function [7:0] hexadecimal;
        input [3:0] digit;
        hexadecimal = (digit < 4'd10) ? 8'h30 + {4'd0, digit} : 8'h57 + {4'd0, digit};
    endfunction

    always @*
        if (queued_end)
            case (letter_reg)
                4'd0:    letter = "-";
                4'd1:    letter = 8'h0d;
                default: letter = 8'h0a;
            endcase
        else
            case (letter_reg)
                4'd0:    letter = hexadecimal(u[11:8]);
                4'd1:    letter = hexadecimal(u[7:4]);
                4'd2:    letter = hexadecimal(u[3:0]);
                4'd3:    letter = " ";
                4'd4:    letter = hexadecimal(v[11:8]);
                4'd5:    letter = hexadecimal(v[7:4]);
                4'd6:    letter = hexadecimal(v[3:0]);
                4'd7:    letter = 8'h0d;
                default: letter = 8'h0a;
            endcase

    assign txd = !sending || bits_reg[0];

    always @(posedge clk) begin
        take_reg <= 1'b0;
        if (sending) begin
            cycle_reg <= (cycle_reg == LAST_CYCLE[15:0]) ? 16'd0 : cycle_reg + 1'b1;
            if (cycle_reg == LAST_CYCLE[15:0]) begin
                bits_reg      <= {1'b1, bits_reg[9:1]};
                bits_left_reg <= bits_left_reg - 1'b1;
            end
        end else if (queued && !take_reg) begin
            bits_reg      <= {1'b1, letter, 1'b0};
            bits_left_reg <= 4'd10;
            letter_reg    <= last_letter ? 4'd0 : letter_reg + 1'b1;
            take_reg      <= last_letter;
        end
        if (rst) begin
            letter_reg    <= 4'd0;
            bits_left_reg <= 4'd0;
            cycle_reg     <= 16'd0;
            take_reg      <= 1'b0;
        end
    end

endmodule

`default_nettype wire
