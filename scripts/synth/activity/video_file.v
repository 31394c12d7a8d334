// In simulation in the place of rtl/board/video_pattern.v: grey frames, a byte a pixel, from the file frames.grey, over and over.

`default_nettype none

module video_pattern #(
    parameter WIDTH  = 640,
    parameter HEIGHT = 480
) (
    input  wire        clk,
    input  wire        rst,

    output wire [23:0] m_axis_tdata,
    output wire        m_axis_tuser,
    output wire        m_axis_tlast,
    output wire        m_axis_tvalid,
    input  wire        m_axis_tready
);

    integer file, unused_rewound, from_file;
    integer pixel, column, row;

    initial file = $fopen("frames.grey", "rb");

    assign m_axis_tdata  = {16'd0, pixel[7:0]};
    assign m_axis_tuser  = (column == 0) && (row == 0);
    assign m_axis_tlast  = (column == WIDTH - 1);
    assign m_axis_tvalid = !rst;

    always @(posedge clk)
        if (rst) begin
            column <= 0;
            row    <= 0;
            pixel  <= 0;
        end else if (m_axis_tready) begin
            from_file = $fgetc(file);
            if (from_file < 0) begin
                unused_rewound = $rewind(file);
                from_file = $fgetc(file);
            end
            pixel  <= from_file;
            column <= m_axis_tlast ? 0 : column + 1;
            if (m_axis_tlast)
                row <= (row == HEIGHT - 1) ? 0 : row + 1;
        end

endmodule

`default_nettype wire
