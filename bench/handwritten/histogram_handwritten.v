// Histogram by hand: the yardstick for the compiler's hls/histogram.h (bench/kernels/histogram.cpp). Same ports, same bits, same rate.
//
// A run clears the 256 bins, counts a frame of width * height pixels while they pass, and sends the counts: width * height + 515 steps. A
// bin is read when its pixel comes and written one step later; the count of the last pixel is kept for the next one of the same level.

`default_nettype none

module histogram_handwritten (
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
    output wire [18:0] counts_din,
    input  wire        counts_full_n,
    output wire        counts_write,

    input  wire [11:0] width,
    input  wire [11:0] height
);

    reg        clearing_reg, counting_reg, sending_reg, done_reg;
    reg  [7:0] level_reg;  // that is cleared or read to be sent
    wire       last_level = &level_reg;

    // What is left of the row and of the frame, this pixel and this row included.
    reg  [9:0] columns_left_reg;
    reg  [8:0] rows_left_reg;
    wire       row_ends = columns_left_reg == 10'd1;

    // Stage 1: the bin has been read.
    reg         counted_reg, repeats_reg, sent_reg;
    reg  [7:0]  pixel_reg;
    reg  [18:0] count_reg;
    wire [18:0] bin;
    wire [18:0] count = (repeats_reg ? count_reg : bin) + 19'd1;

    wire step      = counting_reg && in_empty_n && out_full_n;
    wire send_step = sending_reg && !counted_reg && (!sent_reg || counts_full_n);  // the last pixel's count is written first

    assign in_read      = step;
    assign out_din      = in_dout;
    assign out_write    = step;
    assign counts_din   = bin;
    assign counts_write = sent_reg && counts_full_n;

    ram_1r1w #(
        .WIDTH        (19),
        .DEPTH        (256),
        .ADDRESS_WIDTH(8)
    ) bin_ram (
        .clk          (clk),
        .write_enable (clearing_reg || counted_reg),
        .write_address(clearing_reg ? level_reg : pixel_reg),
        .write_data   (clearing_reg ? 19'd0 : count),
        .read_enable  (step || send_step),
        .read_address (counting_reg ? in_dout : level_reg),
        .read_data    (bin)
    );

    always @(posedge clk) begin
        counted_reg <= step;
        if (step) begin
            pixel_reg        <= in_dout;
            repeats_reg      <= in_dout == pixel_reg;
            columns_left_reg <= row_ends ? width[9:0] : columns_left_reg - 10'd1;
            if (row_ends) rows_left_reg <= rows_left_reg - 9'd1;
        end
        if (counted_reg) count_reg <= count;
        if (clearing_reg || send_step) level_reg <= level_reg + 8'd1;
        if (sending_reg || counts_full_n) sent_reg <= send_step || (sent_reg && !counts_full_n);

        // A cleared bin 0 holds no count, so that pixel 0 with count 0 is a true start.
        if (clearing_reg) begin
            pixel_reg        <= 8'd0;
            count_reg        <= 19'd0;
            columns_left_reg <= width[9:0];
            rows_left_reg    <= height[8:0];
        end

        if (clearing_reg && last_level) {clearing_reg, counting_reg} <= 2'b01;
        if (step && row_ends && rows_left_reg == 9'd1) {counting_reg, sending_reg} <= 2'b01;
        if (send_step && last_level) sending_reg <= 1'b0;
        if (ap_start && ap_idle) clearing_reg <= 1'b1;
        done_reg <= counts_write && !sending_reg;
        if (rst) begin
            {clearing_reg, counting_reg, sending_reg, sent_reg, counted_reg, done_reg} <= 6'd0;
            level_reg <= 8'd0;
        end
    end

    assign ap_done  = done_reg;
    assign ap_ready = done_reg;
    assign ap_idle  = !clearing_reg && !counting_reg && !sending_reg && !sent_reg && !done_reg;

    wire unused = &{1'b0, width[11:10], height[11:9]};

endmodule

`default_nettype wire
