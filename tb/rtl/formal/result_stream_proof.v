// Proof bench of rtl/result_stream.v: the rules of AXI4-Stream at its output, nothing lost or added, and the verdict of each frame on
// its own end element. The core keeps an element until it is taken; no more frames are begun than `room` allows.

`default_nettype none

module result_stream_proof (
    input wire       clk,
    input wire       rst,
    input wire [2:0] tdata,
    input wire       tvalid,
    input wire       m_ready,
    input wire       frame_done,
    input wire       frame_malformed,
    input wire       mark  // the solver picks one frame
);

    wire       tready, tuser, tlast, m_valid, room, empty;
    wire [2:0] m_data;

    result_stream #(.WIDTH(3), .END_BIT(2)) stream (
        .clk(clk), .rst(rst), .s_tdata(tdata), .s_tvalid(tvalid), .s_tready(tready),
        .m_axis_tdata(m_data), .m_axis_tuser(tuser), .m_axis_tlast(tlast), .m_axis_tvalid(m_valid), .m_axis_tready(m_ready),
        .frame_done(frame_done), .frame_malformed(frame_malformed), .room(room), .empty(empty)
    );

    reg       started = 1'b0;
    reg       past_waits, past_stalled, past_user, past_last;
    reg [2:0] past_tdata, past_data;
    reg [2:0] outstanding;       // frames done whose end has not left
    reg       marked, verdict;
    reg [2:0] ahead;             // ends that leave before the marked frame's
    reg [3:0] blocked;           // cycles in which an element waits though nothing stalls it

    wire end_leaves = m_valid && m_ready && tlast;

    always @(posedge clk) begin
        started      <= 1'b1;
        past_waits   <= !rst && tvalid && !tready;
        past_tdata   <= tdata;
        past_stalled <= !rst && m_valid && !m_ready;
        past_data    <= m_data;
        past_user    <= tuser;
        past_last    <= tlast;
        if (rst) begin
            outstanding <= 0;
            marked      <= 1'b0;
            blocked     <= 0;
        end else begin
            outstanding <= outstanding + frame_done - end_leaves;
            blocked     <= (tvalid && !m_valid && outstanding != 0) ? blocked + 1'b1 : 0;
            if (frame_done && mark && !marked) begin
                marked  <= 1'b1;
                verdict <= frame_malformed;
                ahead   <= outstanding - end_leaves;
            end else if (marked && end_leaves) begin
                marked <= (ahead != 0);
                ahead  <= ahead - 1'b1;
            end
        end
    end

    always @* begin
        if (!started)
            assume (rst);
        assume (!frame_done || room);
        assume (!past_waits || (tvalid && tdata == past_tdata));
        if (started && !rst) begin
            assert (!past_stalled || (m_valid && m_data == past_data && tuser == past_user && tlast == past_last));
            assert ((m_valid && m_ready) == (tvalid && tready));
            assert (!m_valid || (m_data == tdata && tlast == tdata[2]));
            assert (!m_valid || tlast || !tuser);
            assert (!end_leaves || outstanding != 0);
            assert (!(marked && end_leaves && ahead == 0) || tuser == verdict);
            assert (blocked < 3);
            assert (!empty || !end_leaves);
            cover (marked && verdict && end_leaves && ahead == 0 && past_stalled);
        end
    end

endmodule

`default_nettype wire
