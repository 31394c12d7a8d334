// Proof bench of rtl/frame_counters.v, with counters of 4 bits: each counter is what its line in docs/registers.md says, counted again
// here in the plainest way, whatever the inputs do.

`default_nettype none

module frame_counters_proof (
    input wire       clk,
    input wire       rst,
    input wire       frame_start,
    input wire       frame_done,
    input wire       frame_malformed,
    input wire       frame_dropped,
    input wire       pixel,
    input wire       line_done,
    input wire       input_stalled,
    input wire       output_stalled,
    input wire       point,
    input wire       point_end,
    input wire [2:0] point_row,
    input wire [2:0] rows_to_decide,
    input wire [2:0] height
);

    wire [31:0] frames;
    wire [3:0]  malformed_frames, dropped_frames, frame_cycles, input_stalls, output_stalls;
    wire [3:0]  unused_first_result_latency, decision_latency;

    frame_counters #(.WIDTH(4), .SIZE_WIDTH(3)) counters (
        .clk(clk), .rst(rst), .frame_start(frame_start), .frame_done(frame_done), .frame_malformed(frame_malformed),
        .frame_dropped(frame_dropped), .pixel(pixel), .line_done(line_done), .input_stalled(input_stalled),
        .output_stalled(output_stalled), .point(point), .point_end(point_end), .point_row(point_row),
        .rows_to_decide(rows_to_decide), .height(height), .frames(frames), .malformed_frames(malformed_frames),
        .dropped_frames(dropped_frames), .frame_cycles(frame_cycles), .input_stalls(input_stalls), .output_stalls(output_stalls),
        .first_result_latency(unused_first_result_latency), .decision_latency(decision_latency)
    );

    reg        started = 1'b0;
    reg [31:0] starts;
    reg [3:0]  malformed, dropped;
    reg        counting, whole;        // since a start; a whole frame has been counted
    reg [3:0]  cycles, in_stalls, out_stalls;
    reg [3:0]  last_cycles, last_in_stalls, last_out_stalls;
    reg        no_point;               // no point but ends since reset

    always @(posedge clk) begin
        started <= 1'b1;
        if (rst) begin
            starts    <= 0;
            malformed <= 0;
            dropped   <= 0;
            counting  <= 1'b0;
            whole     <= 1'b0;
            no_point  <= 1'b1;
        end else begin
            starts    <= starts + frame_start;
            malformed <= malformed + (frame_done && frame_malformed);
            dropped   <= dropped + frame_dropped;
            no_point  <= no_point && !(point && !point_end);
            if (frame_start) begin
                counting        <= 1'b1;
                whole           <= counting;
                last_cycles     <= cycles;
                last_in_stalls  <= in_stalls;
                last_out_stalls <= out_stalls;
                cycles          <= 4'd1;
                in_stalls       <= {3'd0, input_stalled};
                out_stalls      <= {3'd0, output_stalled};
            end else begin
                cycles     <= cycles + 1'b1;
                in_stalls  <= in_stalls + input_stalled;
                out_stalls <= out_stalls + output_stalled;
            end
        end
    end

    reg ended = 1'b0;                  // a frame of points has ended and been written down
    reg ended_now;
    always @(posedge clk) begin
        ended_now <= !rst && point && point_end;
        ended     <= !rst && (ended || ended_now);
    end

    always @* begin
        if (!started)
            assume (rst);
        if (started && !rst) begin
            assert (frames == starts);
            assert (malformed_frames == malformed);
            assert (dropped_frames == dropped);
            if (whole) begin
                assert (frame_cycles == last_cycles);
                assert (input_stalls == last_in_stalls);
                assert (output_stalls == last_out_stalls);
            end
            // Without points no decision is measured.
            assert (!(no_point && ended) || decision_latency == 0);
        end
    end

endmodule

`default_nettype wire
