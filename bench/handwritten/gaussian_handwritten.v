// Gaussian 3x3 by hand: the yardstick for the compiler's hls/gaussian.h. Same ports, same bits, same rate.
//
// One RAM word a column holds the two rows above. Weights 245, 534, 245 / 1024, columns first, to 4 fraction bits, then rows:
// 1024 * centre + 245 * curvature, each in one DSP block: multiplier, adder and three registers.
// A run is a frame: width * height pixels in, as many out, width * height + width + 1 steps. Width at least 4.

`default_nettype none

module gaussian_handwritten #(
    parameter MAX_WIDTH     = 640,
    parameter ADDRESS_WIDTH = 10
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        ap_start,
    output wire        ap_done,
    output wire        ap_idle,
    output wire        ap_ready,

    input  wire [7:0]  in_dout,
    input  wire        in_empty_n,
    output wire        in_read,
    output wire [7:0]  out_din,
    input  wire        out_full_n,
    output wire        out_write,

    input  wire [11:0] width,
    input  wire [11:0] height
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
        .has_window(1'b1),
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

    // Stage 1: the two rows above are read, the new pixel comes.
    reg         valid1_reg, takes1_reg, first_row1_reg, fills1_reg, left_edge1_reg, right_edge1_reg;
    reg  [9:0]  column1_reg;
    wire [15:0] above;
    wire [7:0]  middle = above[7:0];
    wire [7:0]  top    = first_row1_reg ? middle : above[15:8];
    wire [7:0]  bottom = takes1_reg ? in_dout : middle;

    assign in_read = step && valid1_reg && takes1_reg;

    ram_1r1w #(
        .WIDTH        (16),
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

    // Stages 2 to 4: the column value, Q8.8.
    reg signed [9:0]   curvature2_reg;
    reg        [7:0]   middle2_reg, middle3_reg;
    reg signed [18:0]  product3_reg;
    reg        [17:0]  sum4_reg;
    wire       [15:0]  column4 = sum4_reg[17:2];

    // Stages 5 to 7: the row value.
    reg        [15:0]  left_reg, middle4_reg;
    reg signed [17:0]  curvature5_reg;
    reg        [15:0]  centre5_reg, centre6_reg;
    reg signed [26:0]  product6_reg;
    reg        [25:0]  sum7_reg;
    reg  [6:2]         fills_reg;
    reg  [4:2]         left_edge_reg, right_edge_reg;
    reg                write_reg;
    wire        [15:0] left  = left_edge_reg[4] ? middle4_reg : left_reg;
    wire        [15:0] right = right_edge_reg[4] ? middle4_reg : column4;
    wire               unused_fraction = &{1'b0, sum4_reg[1:0], sum7_reg[17:0], product3_reg[18], product6_reg[26]};

    assign step      = (!write_reg || out_full_n) && (!(valid1_reg && takes1_reg) || in_empty_n);
    assign out_din   = sum7_reg[25:18];
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

            curvature2_reg <= {2'b00, top} + {2'b00, bottom} - {1'b0, middle, 1'b0};
            middle2_reg    <= middle;
            middle3_reg    <= middle2_reg;
            product3_reg   <= {{9{curvature2_reg[9]}}, curvature2_reg} * 19'sd245;
            sum4_reg       <= product3_reg[17:0] + {middle3_reg, 10'd2};

            middle4_reg    <= column4;
            left_reg       <= middle4_reg;
            curvature5_reg <= {2'b00, left} + {2'b00, right} - {1'b0, middle4_reg, 1'b0};
            centre5_reg    <= middle4_reg;
            centre6_reg    <= centre5_reg;
            product6_reg   <= {{9{curvature5_reg[17]}}, curvature5_reg} * 27'sd245;
            sum7_reg       <= product6_reg[25:0] + {centre6_reg, 10'd0} + 26'd131072;

            fills_reg      <= {fills_reg[5:2], valid1_reg && fills1_reg};
            left_edge_reg  <= {left_edge_reg[3:2], left_edge1_reg};
            right_edge_reg <= {right_edge_reg[3:2], right_edge1_reg};
            write_reg      <= fills_reg[6];
        end
        if (rst) begin
            valid1_reg <= 1'b0;
            fills_reg  <= 5'd0;
            write_reg  <= 1'b0;
        end
    end

    wire empty = !valid1_reg && fills_reg == 5'd0 && !write_reg;

    assign ap_done  = done && empty;
    assign ap_ready = ap_done;
    assign ap_idle  = !done && !fetch_valid;

endmodule

`default_nettype wire
