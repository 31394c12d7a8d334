// Test pattern in place of a camera: a speckled floor over which a bright box slides sideways, frame after frame without a gap.

`default_nettype none

module video_pattern #(
    parameter WIDTH  = 640,
    parameter HEIGHT = 480
) (
    input  wire        clk,
    input  wire        rst,

    output wire [23:0] m_axis_tdata,  // grey in 7:0
    output wire        m_axis_tuser,
    output wire        m_axis_tlast,
    output wire        m_axis_tvalid,
    input  wire        m_axis_tready
);

    localparam [31:0] LAST_COLUMN = WIDTH - 1;
    localparam [31:0] LAST_ROW    = HEIGHT - 1;
    localparam [31:0] BOX_TOP     = HEIGHT / 3;
    localparam [31:0] BOX_BOTTOM  = HEIGHT / 3 + HEIGHT / 4;  // where it touches the floor
    localparam [31:0] BOX_WIDTH   = WIDTH / 8;

    reg [11:0] column_reg;
    reg [11:0] row_reg;
    reg [11:0] box_left_reg;

    wire       last_column = (column_reg == LAST_COLUMN[11:0]);
    wire       last_row    = (row_reg == LAST_ROW[11:0]);
    wire       in_box      = (row_reg >= BOX_TOP[11:0]) && (row_reg <= BOX_BOTTOM[11:0]) &&
                             (column_reg - box_left_reg < BOX_WIDTH[11:0]);
    wire [3:0] speckle     = column_reg[5:2] ^ {row_reg[3], row_reg[5:3]};

    assign m_axis_tdata  = {16'd0, in_box ? 8'd200 : {4'd4, speckle}};
    assign m_axis_tuser  = (column_reg == 12'd0) && (row_reg == 12'd0);
    assign m_axis_tlast  = last_column;
    assign m_axis_tvalid = !rst;

    always @(posedge clk) begin
        if (m_axis_tready) begin
            column_reg <= last_column ? 12'd0 : column_reg + 1'b1;
            if (last_column)
                row_reg <= last_row ? 12'd0 : row_reg + 1'b1;
            if (last_column && last_row)
                box_left_reg <= (box_left_reg >= LAST_COLUMN[11:0] - BOX_WIDTH[11:0]) ? 12'd0 : box_left_reg + 12'd8;
        end
        if (rst) begin
            column_reg   <= 12'd0;
            row_reg      <= 12'd0;
            box_left_reg <= 12'd0;
        end
    end

endmodule

`default_nettype wire
