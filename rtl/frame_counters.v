// Hardware counters of floorline_top: cycles of a frame, stalls, latencies, faults. docs/registers.md says what each means.
//
// Counters of a frame are copied to their registers when the next frame starts (FRAME_CYCLES and stalls) or when its last floor
// point has left (latencies), so that a read always gives a whole frame. All wrap.

`default_nettype none

module frame_counters #(
    parameter WIDTH      = 24,  // bits of a counter
    parameter SIZE_WIDTH = 12   // bits of a row
) (
    input  wire                  clk,
    input  wire                  rst,

    // Input side.
    input  wire                  frame_start,      // pulse: the core starts
    input  wire                  frame_done,       // pulse: its last pixel was taken
    input  wire                  frame_malformed,  // with frame_done
    input  wire                  frame_dropped,    // pulse
    input  wire                  pixel,            // the core takes a pixel
    input  wire                  line_done,        // with pixel: the last one of a line
    input  wire                  input_stalled,
    input  wire                  output_stalled,

    // Floor points, as they leave.
    input  wire                  point,            // one leaves
    input  wire                  point_end,        // with point: the end of the frame
    input  wire [SIZE_WIDTH-1:0] point_row,        // its contact row
    input  wire [SIZE_WIDTH-1:0] rows_to_decide,   // rows below a contact that decide it
    input  wire [SIZE_WIDTH-1:0] height,           // lines of the frame

    output reg  [31:0]           frames,
    output reg  [WIDTH-1:0]      malformed_frames,
    output reg  [WIDTH-1:0]      dropped_frames,
    output reg  [WIDTH-1:0]      frame_cycles,
    output reg  [WIDTH-1:0]      input_stalls,
    output reg  [WIDTH-1:0]      output_stalls,
    output reg  [WIDTH-1:0]      first_result_latency,
    output reg  [WIDTH-1:0]      decision_latency
);

    // Faults and frames.
    always @(posedge clk) begin
        if (frame_start)
            frames <= frames + 1'b1;
        if (frame_done && frame_malformed)
            malformed_frames <= malformed_frames + 1'b1;
        if (frame_dropped)
            dropped_frames <= dropped_frames + 1'b1;
        if (rst) begin
            frames           <= 32'd0;
            malformed_frames <= {WIDTH{1'b0}};
            dropped_frames   <= {WIDTH{1'b0}};
        end
    end

    // Cycles and stalls from start to start. A stall is counted one cycle later, so that counters start at 0.
    reg [WIDTH-1:0]  cycles_reg;
    reg              input_stalled_reg;
    reg              output_stalled_reg;
    reg [WIDTH-1:0]  input_stalls_reg;   // but for input_stalled_reg
    reg [WIDTH-1:0]  output_stalls_reg;
    wire [WIDTH-1:0] all_input_stalls  = input_stalls_reg + {{WIDTH-1{1'b0}}, input_stalled_reg};
    wire [WIDTH-1:0] all_output_stalls = output_stalls_reg + {{WIDTH-1{1'b0}}, output_stalled_reg};

    always @(posedge clk) begin
        cycles_reg         <= cycles_reg + 1'b1;
        input_stalled_reg  <= input_stalled;
        output_stalled_reg <= output_stalled;
        input_stalls_reg   <= all_input_stalls;
        output_stalls_reg  <= all_output_stalls;
        if (frame_start) begin
            cycles_reg        <= {{WIDTH-1{1'b0}}, 1'b1};
            input_stalls_reg  <= {WIDTH{1'b0}};
            output_stalls_reg <= {WIDTH{1'b0}};
            frame_cycles      <= cycles_reg;
            input_stalls      <= all_input_stalls;
            output_stalls     <= all_output_stalls;
        end
        if (rst) begin
            cycles_reg         <= {WIDTH{1'b0}};
            input_stalled_reg  <= 1'b0;
            output_stalled_reg <= 1'b0;
            input_stalls_reg   <= {WIDTH{1'b0}};
            output_stalls_reg  <= {WIDTH{1'b0}};
            frame_cycles       <= {WIDTH{1'b0}};
            input_stalls       <= {WIDTH{1'b0}};
            output_stalls      <= {WIDTH{1'b0}};
        end
    end

    // Latencies. Up to four frames are between input and points; time_reg runs on, and what belongs to a frame waits in a queue.
    reg  [WIDTH-1:0]    time_reg;
    reg  [SIZE_WIDTH:0] lines_reg;      // lines taken, modulo 2^(SIZE_WIDTH + 1)
    reg                 first_reg;      // the next pixel is the first of its frame
    reg                 answered_reg;   // the frame whose points leave has had its first point
    reg  [WIDTH-1:0]    decision_reg;   // greatest latency so far
    wire [WIDTH-1:0]    first_time;     // when the first pixel of that frame was taken
    wire [SIZE_WIDTH:0] first_line;     // lines_reg then

    // frame_start waits for room in queues no deeper than this, so its handshake needs no look.
    wire [1:0]          unused_handshake;

    fifo #(
        .WIDTH(WIDTH + SIZE_WIDTH + 1),
        .DEPTH(5)
    ) first_pixels (
        .clk    (clk),
        .rst    (rst),
        .s_data ({time_reg, lines_reg}),
        .s_valid(pixel && first_reg),
        .s_ready(unused_handshake[0]),
        .m_data ({first_time, first_line}),
        .m_valid(unused_handshake[1]),
        .m_ready(point && point_end)
    );

    // From a point to its latency in steps of one sum each, with the lines taken then:
    //   wanted_row_reg   the row that decides, lines_back_reg: lines taken since the start of its frame;
    //   deciding_row_reg the same row, at most the frame's last;
    //   lines_ago_reg    lines taken since that row was complete: 1 is the last complete one;
    //   line_time_reg    when it was complete;
    //   latency_reg.
    localparam STEPS = 4;  // from a point to line_time_reg

    reg [SIZE_WIDTH-1:0] last_row_reg;
    reg [SIZE_WIDTH:0]   wanted_row_reg;
    reg [SIZE_WIDTH:0]   lines_back_reg;
    reg [SIZE_WIDTH:0]   lines_back_2_reg;
    reg [SIZE_WIDTH:0]   deciding_row_reg;
    reg [SIZE_WIDTH:0]   lines_ago_reg;
    reg [3:0]            newest_reg;      // of line_times, at each step
    reg [3:0]            newest_2_reg;
    reg [3:0]            newest_3_reg;
    reg [WIDTH-1:0]      line_times [0:15];  // when each of the last 16 lines was complete
    reg [WIDTH-1:0]      line_time_reg;
    reg [WIDTH-1:0]      point_time_reg;  // time_reg, STEPS cycles ago
    reg [WIDTH-1:0]      latency_reg;
    reg [STEPS-2:0]      point_reg;       // a point is at this step
    reg [STEPS:0]        ended_reg;       // the end of a frame is
    reg                  known_reg;       // line_time_reg is a point's
    reg                  measure_reg;     // latency_reg is

    // The oldest of the 16 may be overwritten on the way.
    wire                 remembered = (lines_ago_reg != 0) && (lines_ago_reg < 16);

    always @(posedge clk) begin
        time_reg <= time_reg + 1'b1;
        if (pixel && line_done) begin
            line_times[lines_reg[3:0]] <= time_reg;
            lines_reg <= lines_reg + 1'b1;
        end
        if (frame_start)
            first_reg <= 1'b1;
        else if (pixel)
            first_reg <= 1'b0;

        if (point) begin
            answered_reg <= !point_end;
            if (!answered_reg)
                first_result_latency <= time_reg - first_time;
        end

        last_row_reg     <= height - 1'b1;
        wanted_row_reg   <= {1'b0, point_row} + {1'b0, rows_to_decide};
        lines_back_reg   <= lines_reg - first_line;
        newest_reg       <= lines_reg[3:0];
        deciding_row_reg <= (wanted_row_reg > {1'b0, last_row_reg}) ? {1'b0, last_row_reg} : wanted_row_reg;
        lines_back_2_reg <= lines_back_reg;
        newest_2_reg     <= newest_reg;
        lines_ago_reg    <= lines_back_2_reg - deciding_row_reg;
        newest_3_reg     <= newest_2_reg;
        line_time_reg    <= line_times[newest_3_reg - lines_ago_reg[3:0]];
        latency_reg      <= point_time_reg - line_time_reg;

        point_time_reg   <= point_time_reg + 1'b1;
        point_reg        <= {point_reg[STEPS-3:0], point && !point_end};
        ended_reg        <= {ended_reg[STEPS-1:0], point && point_end};
        known_reg        <= point_reg[STEPS-2] && remembered;
        measure_reg      <= known_reg;
        // The end of a frame is no point, so that both do not meet.
        if (measure_reg && latency_reg > decision_reg)
            decision_reg <= latency_reg;
        if (ended_reg[STEPS]) begin
            decision_reg     <= {WIDTH{1'b0}};
            decision_latency <= decision_reg;
        end

        if (rst) begin
            time_reg       <= {WIDTH{1'b0}};
            point_time_reg <= {WIDTH{1'b0}} - STEPS[WIDTH-1:0];
            lines_reg      <= {SIZE_WIDTH+1{1'b0}};
            decision_reg   <= {WIDTH{1'b0}};
            answered_reg   <= 1'b0;
            point_reg      <= {STEPS-1{1'b0}};
            ended_reg      <= {STEPS+1{1'b0}};
            known_reg      <= 1'b0;
            measure_reg    <= 1'b0;
            first_result_latency <= {WIDTH{1'b0}};
            decision_latency     <= {WIDTH{1'b0}};
        end
    end

endmodule

`default_nettype wire
