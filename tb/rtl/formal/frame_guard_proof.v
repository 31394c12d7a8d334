// Proof bench of rtl/frame_guard.v: any input whatsoever that keeps a waiting beat (the skid buffer before the guard does), sizes
// 1x1 to 3x3, chosen by the solver.
//
// Safety: a started frame gives the core exactly width * height pixels; a frame that ends without frame_malformed is the input,
// pixel by pixel, with SOF and EOL in their places, and such an input never ends malformed; each malformed frame has its event.
// Bounded liveness: with a core that takes a pixel a cycle, the input waits at most one frame of black pixels, and so does a
// cleared enable for the end of the frame.

`default_nettype none

module frame_guard_proof (
    input wire       clk,
    input wire       rst,
    input wire [1:0] tdata,
    input wire       tuser,
    input wire       tlast,
    input wire       tvalid,
    input wire       m_ready,
    input wire       grant,
    input wire       refuse,
    input wire       enable
);

    (* anyconst *) wire [1:0] width;
    (* anyconst *) wire [1:0] height;

    wire       tready, m_valid, request, line_done, done, malformed;
    wire [1:0] m_data;
    wire       early_sof, late_sof, short_line, long_line, disabled_in_frame, frame_dropped;

    frame_guard #(.PIXEL_WIDTH(2), .SIZE_WIDTH(2)) guard (
        .clk(clk), .rst(rst),
        .s_axis_video_tdata(tdata), .s_axis_video_tuser(tuser), .s_axis_video_tlast(tlast), .s_axis_video_tvalid(tvalid),
        .s_axis_video_tready(tready), .m_data(m_data), .m_valid(m_valid), .m_ready(m_ready),
        .start_request(request), .start_grant(grant), .refuse(refuse), .enable(enable), .width(width), .height(height),
        .line_done(line_done), .frame_done(done), .frame_malformed(malformed), .early_sof(early_sof), .late_sof(late_sof), .short_line(short_line),
        .long_line(long_line), .disabled_in_frame(disabled_in_frame), .frame_dropped(frame_dropped)
    );

    wire       start    = request && grant && !refuse;
    wire       transfer = tvalid && tready;
    wire       pass     = m_valid && m_ready;
    wire       event_in_frame = early_sof || short_line || long_line || disabled_in_frame;

    reg       started = 1'b0;        // a reset came first
    reg       in_frame;
    reg [3:0] passed;                // pixels of the frame
    reg [1:0] column;
    reg       faithful;              // so far the frame is the input
    reg       told;                  // the frame had an event
    reg       past_stalled;
    reg [1:0] past_data;
    reg [3:0] held;                  // cycles that the input has waited for the guard alone
    reg [3:0] ending;                // cycles since enable was cleared in a frame
    reg       recovered;             // the last frame was malformed

    wire last_of_line  = (column == width - 2'd1);
    wire last_of_frame = (passed == width * height - 4'd1);
    wire in_place      = transfer && m_data == tdata && tuser == (passed == 0) && tlast == last_of_line;

    always @(posedge clk) begin
        started <= 1'b1;
        if (rst) begin
            in_frame     <= 1'b0;
            past_stalled <= 1'b0;
            held         <= 0;
            ending       <= 0;
            recovered    <= 1'b0;
        end else begin
            if (start) begin
                in_frame <= 1'b1;
                passed   <= 0;
                column   <= 0;
                faithful <= 1'b1;
                told     <= 1'b0;
            end else if (in_frame) begin
                if (pass) begin
                    passed   <= passed + 1'b1;
                    column   <= last_of_line ? 2'd0 : column + 1'b1;
                end
                faithful <= faithful && (!transfer || pass) && (!pass || in_place);
                told     <= told || event_in_frame;
                if (done) begin
                    in_frame  <= 1'b0;
                    recovered <= malformed;
                end
            end
            past_stalled    <= m_valid && !m_ready && enable;
            past_data       <= m_data;
            held            <= (transfer || !tvalid || request) ? 0 : held + (m_ready ? 1'b1 : 1'b0);
            ending          <= (enable || !in_frame || done) ? 0 : ending + (m_ready ? 1'b1 : 1'b0);
        end
    end

    // The source keeps a beat until it is taken.
    reg       past_waiting;
    reg [3:0] past_beat;
    always @(posedge clk) begin
        past_waiting <= !rst && tvalid && !tready;
        past_beat    <= {tdata, tuser, tlast};
    end

    always @* begin
        assume (width != 0 && height != 0);
        assume (!past_waiting || (tvalid && past_beat == {tdata, tuser, tlast}));
        if (!started)
            assume (rst);
        if (started && !rst) begin
            assert (!pass || in_frame);
            assert (!start || !in_frame);
            assert (line_done == (pass && last_of_line));
            assert (done == (pass && last_of_frame));
            if (done) begin
                assert (malformed || (faithful && in_place));
                assert (!malformed || !(faithful && in_place));
                assert (malformed == (told || event_in_frame));
            end
            assert (!(transfer && tuser && !pass) || frame_dropped);
            assert (!(request && transfer) || (grant && refuse));
            assert (held <= 4'd11);
            assert (ending <= 4'd10);
            if (past_stalled && enable)
                assert (m_valid && m_data == past_data);
            cover (done && !malformed && recovered && passed == 5);
        end
    end

endmodule

`default_nettype wire
