// Raster walk of a 3x3 window, shared by the filters written by hand: one step a clock over width * height + width + 1 positions,
// or over width * height ones without a window. Flags are registered with the column they belong to.

`default_nettype none

module window_walk (
    input  wire        clk,
    input  wire        rst,
    input  wire        start,       // begins a frame; not while one runs
    input  wire        finished,    // ends `done`
    input  wire        step,
    input  wire        has_window,  // 1: one row and one position more, to empty the window
    input  wire [11:0] width,
    input  wire [11:0] height,

    output reg         valid,
    output reg  [9:0]  column,
    output reg         first_row,   // the row above is the image's first
    output reg         takes,       // a pixel comes in
    output wire        fills,       // the window gives a pixel
    output wire        left_edge,   // of the window's centre
    output wire        right_edge,
    output reg         done         // all positions are behind, until `finished`
);

    reg  [11:0] rows_left_reg;      // that come in, this one included
    reg         below_first_reg;    // row 1 or later
    reg         below_second_reg;   // row 2 or later
    reg         flushing_reg;       // the row after the last
    wire [11:0] last_column = width - 1'b1;
    wire        row_end     = ({2'b00, column} == last_column);
    wire        last_row    = (rows_left_reg == 12'd1);

    assign left_edge  = (column == 10'd1);
    assign right_edge = (column == 10'd0);
    assign fills      = !has_window || below_second_reg || (below_first_reg && !right_edge);

    // After the flushing row comes the single position of the last corner.
    reg  corner_reg;
    wire last_position = corner_reg || (row_end && !has_window && last_row);

    always @(posedge clk) begin
        if (start) begin
            valid            <= 1'b1;
            column           <= 10'd0;
            first_row        <= 1'b0;
            takes            <= 1'b1;
            rows_left_reg    <= height;
            below_first_reg  <= 1'b0;
            below_second_reg <= 1'b0;
            flushing_reg     <= 1'b0;
            corner_reg       <= 1'b0;
        end else if (valid && step) begin
            column <= row_end ? 10'd0 : column + 1'b1;
            valid  <= !last_position;
            if (row_end) begin
                rows_left_reg    <= rows_left_reg - 1'b1;
                first_row        <= !below_first_reg;
                below_first_reg  <= 1'b1;
                below_second_reg <= below_first_reg;
                takes            <= takes && !last_row;
                flushing_reg     <= takes && last_row;
                corner_reg       <= flushing_reg;
            end
        end

        if (valid && step && last_position)
            done <= 1'b1;
        else if (finished)
            done <= 1'b0;

        if (rst) begin
            valid <= 1'b0;
            done  <= 1'b0;
        end
    end

endmodule

`default_nettype wire
