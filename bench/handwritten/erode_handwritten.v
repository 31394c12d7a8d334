// Erosion 3x3 of the high bit by hand: the yardstick for the compiler's hls/erode.h. Same ports, same bits, same rate.
//
// Bit 1: the AND of the window's high bits, borders replicated; bit 0: the centre's low bit. Without erode_high masks pass.
// A run is a frame: width * height masks in, as many out. Width at least 4.

`default_nettype none

module erode_handwritten #(
    parameter MAX_WIDTH     = 640,
    parameter ADDRESS_WIDTH = 10
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        ap_start,
    output wire        ap_done,
    output wire        ap_idle,
    output wire        ap_ready,

    input  wire [1:0]  in_dout,
    input  wire        in_empty_n,
    output wire        in_read,
    output wire [1:0]  out_din,
    input  wire        out_full_n,
    output wire        out_write,

    input  wire [11:0] width,
    input  wire [11:0] height,
    input  wire        erode_high
);

    wire        step;  // the pipeline moves
    wire        fetch_valid, fetch_first_row, fetch_takes, fetch_fills, fetch_left_edge, fetch_right_edge;
    wire        done;
    wire [9:0]  fetch_column;

    window_walk walk (
        .clk       (clk),
        .rst       (rst),
        .start     (ap_start && ap_idle),
        .finished  (ap_done),
        .step      (step),
        .has_window(erode_high),
        .width     (width),
        .height    (height),
        .valid     (fetch_valid),
        .column    (fetch_column),
        .first_row (fetch_first_row),
        .takes     (fetch_takes),
        .fills     (fetch_fills),
        .left_edge (fetch_left_edge),
        .right_edge(fetch_right_edge),
        .done      (done)
    );

    // Stage 1: the two rows above are read, the new mask comes.
    reg        valid1_reg, takes1_reg, first_row1_reg, fills1_reg, left_edge1_reg, right_edge1_reg;
    reg  [9:0] column1_reg;
    wire [3:0] above;  // rows v - 2 and v - 1
    wire [1:0] middle      = above[1:0];
    wire       top_high    = first_row1_reg ? middle[1] : above[3];
    wire       bottom_high = takes1_reg ? in_dout[1] : middle[1];
    wire       unused_low  = above[2];

    assign in_read = step && valid1_reg && takes1_reg;

    ram_1r1w #(
        .WIDTH        (4),
        .DEPTH        (MAX_WIDTH),
        .ADDRESS_WIDTH(ADDRESS_WIDTH)
    ) rows_above (
        .clk          (clk),
        .write_enable (in_read),
        .write_address(column1_reg),
        .write_data   ({middle, in_dout}),
        .read_enable  (step),
        .read_address (fetch_column),
        .read_data    (above)
    );

    // Stage 2: the three columns and the result.
    reg  [1:0] column2_reg, column_before_reg;  // all of a column set; its middle's low bit
    reg        all_two_before_reg;
    reg        fills2_reg, left_edge2_reg, right_edge2_reg;
    reg  [1:0] result_reg;
    reg        write_reg;
    wire       left_all  = left_edge2_reg || all_two_before_reg;
    wire       right_all = right_edge2_reg || column2_reg[1];

    assign step      = (!write_reg || out_full_n) && (!(valid1_reg && takes1_reg) || in_empty_n);
    assign out_din   = result_reg;
    assign out_write = write_reg && step;

    always @(posedge clk) begin
        if (step) begin
            valid1_reg      <= fetch_valid;
            column1_reg     <= fetch_column;
            takes1_reg      <= fetch_takes;
            first_row1_reg  <= fetch_first_row;
            fills1_reg      <= fetch_fills;
            left_edge1_reg  <= fetch_left_edge;
            right_edge1_reg <= fetch_right_edge;

            column2_reg        <= erode_high ? {top_high && middle[1] && bottom_high, middle[0]} : in_dout;
            column_before_reg  <= column2_reg;
            all_two_before_reg <= column_before_reg[1];
            fills2_reg         <= valid1_reg && fills1_reg;
            left_edge2_reg     <= left_edge1_reg;
            right_edge2_reg    <= right_edge1_reg;

            result_reg <= erode_high ? {left_all && column_before_reg[1] && right_all, column_before_reg[0]} : column2_reg;
            write_reg  <= fills2_reg;
        end
        if (rst) begin
            valid1_reg <= 1'b0;
            fills2_reg <= 1'b0;
            write_reg  <= 1'b0;
        end
    end

    assign ap_done  = done && !valid1_reg && !fills2_reg && !write_reg;
    assign ap_ready = ap_done;
    assign ap_idle  = !done && !fetch_valid;

endmodule

`default_nettype wire
