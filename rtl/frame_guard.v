// Frame guard: whatever comes on the video input, the core gets exactly width * height pixels for each frame that starts.
//
// Policy, by what is wrong with the input (SOF: TUSER on the first pixel of a frame, EOL: TLAST on the last pixel of a line):
//   early SOF      the frame in progress is filled up with black pixels while the input waits; the new frame then starts
//   late SOF       pixels outside a frame are dropped until the next SOF; also what a frame has too many lines of
//   short line     the line is filled up with black pixels while the input waits; the next line is in its place again
//   long line      pixels beyond the width are dropped up to and including the EOL; so is what follows a missing EOL
//   disabled       a frame in progress is filled up with black pixels; until enabled again every pixel is dropped
//   refused        a frame that starts while `refuse` is 1 (a size beyond the core's) is dropped
// A frame that was filled up or cut ends with frame_malformed; each event is a pulse of one cycle. A right frame passes
// unchanged. Nothing waits for the source but the pixels themselves: a source that stops in mid-frame is resolved by its next
// SOF, or by clearing `enable`.
//
// A start takes a handshake: start_request rises when a frame's first pixel waits, and the pixel moves after start_grant. The
// guard counts with width and height, which must not change from the cycle before the grant until the frame's end.

`default_nettype none

module frame_guard #(
    parameter PIXEL_WIDTH = 24,  // bits of a pixel
    parameter SIZE_WIDTH  = 12   // bits of width and height
) (
    input  wire                   clk,
    input  wire                   rst,

    // Video in: AXI4-Stream as video cores speak it.
    input  wire [PIXEL_WIDTH-1:0] s_axis_video_tdata,
    input  wire                   s_axis_video_tuser,
    input  wire                   s_axis_video_tlast,
    input  wire                   s_axis_video_tvalid,
    output wire                   s_axis_video_tready,

    // Pixels to the core, width * height of them a frame.
    output wire [PIXEL_WIDTH-1:0] m_data,
    output wire                   m_valid,
    input  wire                   m_ready,

    // Start of a frame.
    output wire                   start_request,
    input  wire                   start_grant,
    input  wire                   refuse,           // with start_grant: drop this frame
    input  wire                   enable,
    input  wire [SIZE_WIDTH-1:0]  width,            // pixels of a line, 1 or more
    input  wire [SIZE_WIDTH-1:0]  height,           // lines of a frame, 1 or more

    // End of a line, and of a frame: with the last pixel of it that the core takes.
    output wire                   line_done,
    output wire                   frame_done,
    output wire                   frame_malformed,  // valid with frame_done

    // Events.
    output wire                   early_sof,
    output wire                   late_sof,
    output wire                   short_line,
    output wire                   long_line,
    output wire                   disabled_in_frame,
    output wire                   frame_dropped
);

    localparam [2:0] WAIT      = 3'd0;  // for the first pixel of a frame
    localparam [2:0] PASS      = 3'd1;  // pixels go to the core
    localparam [2:0] FILL_LINE = 3'd2;  // black pixels up to the end of the line
    localparam [2:0] FILL      = 3'd3;  // black pixels up to the end of the frame
    localparam [2:0] SKIP      = 3'd4;  // drop up to the end of the line

    reg [2:0]            state_reg;
    reg [SIZE_WIDTH-1:0] columns_left_reg;  // of the line, this pixel included
    reg [SIZE_WIDTH-1:0] rows_left_reg;     // of the frame, this line included
    reg                  first_reg;         // no pixel of the frame has passed yet
    reg                  malformed_reg;
    reg                  stray_reg;         // the pixels outside a frame have been told already

    wire filling     = (state_reg == FILL_LINE) || (state_reg == FILL);
    wire sof_waits   = s_axis_video_tvalid && s_axis_video_tuser;
    wire interrupted = (sof_waits && !first_reg) || !enable;  // the frame in progress ends here
    wire last_column = (columns_left_reg == 1);
    wire last_row    = (rows_left_reg == 1);

    assign m_data  = filling ? {PIXEL_WIDTH{1'b0}} : s_axis_video_tdata;
    assign m_valid = filling || (state_reg == PASS && s_axis_video_tvalid && !interrupted);

    wire pass = m_valid && m_ready;      // a pixel goes to the core
    wire drop = s_axis_video_tvalid &&   // a pixel of the input goes nowhere
                ((state_reg == WAIT && (!s_axis_video_tuser || !enable || (start_grant && refuse))) ||
                 (state_reg == SKIP && !interrupted));

    assign s_axis_video_tready = drop || (state_reg == PASS && !interrupted && m_ready);

    assign start_request = (state_reg == WAIT) && sof_waits && enable;

    assign line_done         = pass && last_column;
    assign frame_done        = line_done && last_row;
    assign frame_malformed   = malformed_reg || filling || long_line;
    assign early_sof         = (state_reg == PASS || state_reg == SKIP) && enable && interrupted;
    assign disabled_in_frame = (state_reg == PASS || state_reg == SKIP) && !enable;
    assign short_line        = (state_reg == PASS) && pass && s_axis_video_tlast && !last_column;
    assign long_line         = (state_reg == PASS) && pass && !s_axis_video_tlast && last_column;
    assign late_sof          = (state_reg == WAIT) && enable && s_axis_video_tvalid && !s_axis_video_tuser && !stray_reg;
    assign frame_dropped     = (state_reg == WAIT) && drop && s_axis_video_tuser;

    always @(posedge clk) begin
        case (state_reg)
            WAIT:
                if (start_request && start_grant && !refuse)
                    state_reg <= PASS;
            PASS:
                if (interrupted)
                    state_reg <= FILL;
                else if (frame_done)
                    state_reg <= WAIT;
                else if (short_line)
                    state_reg <= FILL_LINE;
                else if (long_line)
                    state_reg <= SKIP;
            FILL_LINE:
                if (line_done)
                    state_reg <= last_row ? WAIT : PASS;
            FILL:
                if (frame_done)
                    state_reg <= WAIT;
            default:  // SKIP
                if (interrupted)
                    state_reg <= FILL;
                else if (drop && s_axis_video_tlast)
                    state_reg <= PASS;
        endcase

        if (state_reg == WAIT) begin
            columns_left_reg <= width;
            rows_left_reg    <= height;
        end else if (pass) begin
            columns_left_reg <= last_column ? width : columns_left_reg - 1'b1;
            if (last_column)
                rows_left_reg <= rows_left_reg - 1'b1;
        end

        if (state_reg == WAIT)
            first_reg <= 1'b1;
        else if (pass)
            first_reg <= 1'b0;

        if (state_reg == WAIT)
            malformed_reg <= 1'b0;
        else if (short_line || long_line || filling)
            malformed_reg <= 1'b1;

        if (state_reg != WAIT)
            stray_reg <= 1'b0;
        else if (drop)
            stray_reg <= 1'b1;

        if (rst)
            state_reg <= WAIT;
    end

endmodule

`default_nettype wire
