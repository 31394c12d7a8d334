// Polar engine by hand: the yardstick for the compiler's hls/polar.h, whose head says what it computes. Same ports, same bits, same
// rate; streams carry the elements of hls/types.h, fields packed from bit 0.
//
// One step a column. Two pipelines share it: pixels (stages 1, 2) leave a summary of every column of the row that comes in; lines
// (stages 1 to 12), one a step from column 5 on, walk the row before it. A line is past stage 8 before the row ends, so that row
// number and half of the buffer need no pipeline of their own.

`default_nettype none

module polar_handwritten #(
    parameter MAX_WIDTH     = 640,
    parameter ADDRESS_WIDTH = 10,  // of a column
    parameter LOG2_LINES    = 8
) (
    input  wire                  clk,
    input  wire                  rst,
    input  wire                  ap_start,
    output wire                  ap_done,
    output wire                  ap_idle,
    output wire                  ap_ready,

    input  wire [1:0]            mask_dout,
    input  wire                  mask_empty_n,
    output wire                  mask_read,
    input  wire [1:0]            motions_dout,  // 0 rests, 1 stirs, 2 unknown, 3 moves
    input  wire                  motions_empty_n,
    output wire                  motions_read,
    output wire [46:0]           contacts_din,
    input  wire                  contacts_full_n,
    output wire                  contacts_write,
    output wire [20:0]           counts_din,
    input  wire                  counts_full_n,
    output wire                  counts_write,

    output wire [LOG2_LINES-1:0] lines_address0,
    output wire                  lines_ce0,
    input  wire [110:0]          lines_q0,

    input  wire [11:0]           width,
    input  wire [11:0]           height,
    input  wire [8:0]            line_count,
    input  wire                  rule_run_rule,
    input  wire [11:0]           rule_min_rows,
    input  wire [11:0]           rule_max_gap,
    input  wire [12:0]           rule_horizon_row,
    input  wire [9:0]            rule_height_ratio
);

    localparam [1:0] IDLE  = 2'd0;
    localparam [1:0] START = 2'd1;  // without lines: their lone count
    localparam [1:0] WALK  = 2'd2;
    localparam [1:0] END   = 2'd3;  // the pipeline runs empty, then the end element

    localparam [31:0] FIRST_LINE = 5;

    wire step;

    // ---- Stage 0: the walk ----
    reg  [1:0]  state_reg;
    reg  [11:0] column_reg;
    reg  [11:0] row_reg;         // that the lines walk: the row before the one that comes in
    reg         streaming_reg;   // pixels come in
    reg         first_row_reg;   // there is no row before
    reg  [12:1] lines_in_reg;    // a line is in this stage
    reg  [8:0]  walked_reg;      // lines walked
    wire [11:0] tail      = {3'd0, walked_reg} + FIRST_LINE[11:0];
    wire        walking   = (state_reg == WALK);
    wire        row_end   = (column_reg == width - 1'b1);
    wire        last_step = !streaming_reg && (column_reg == tail - 1'b1);
    wire        in_lines  = walking && !first_row_reg && column_reg >= FIRST_LINE[11:0] && column_reg < tail;
    wire [LOG2_LINES-1:0] index = column_reg[LOG2_LINES-1:0] - FIRST_LINE[LOG2_LINES-1:0];
    wire        half      = row_reg[0];
    wire [11:0] free      = width - 12'd16;
    reg         takes1_reg;      // stage 1 takes a pixel
    reg         contact_valid_reg, count_valid_reg;
    wire        drained   = (lines_in_reg == 12'd0) && !takes1_reg && !contact_valid_reg && !count_valid_reg;
    wire        end_written = (state_reg == END) && drained && contacts_full_n;

    always @(posedge clk) begin
        case (state_reg)
            IDLE: begin
                column_reg    <= 12'd0;
                row_reg       <= 12'hfff;
                streaming_reg <= 1'b1;
                first_row_reg <= 1'b1;
                walked_reg    <= (width < 12'd16) ? 9'd0 : ({3'd0, line_count} < free) ? line_count : free[8:0];
                if (ap_start)
                    state_reg <= START;
            end
            START:
                if (walked_reg != 9'd0 || counts_full_n)
                    state_reg <= WALK;
            WALK:
                if (step) begin
                    column_reg <= row_end ? 12'd0 : column_reg + 1'b1;
                    if (row_end) begin
                        row_reg       <= row_reg + 1'b1;
                        first_row_reg <= 1'b0;
                        streaming_reg <= (row_reg + 12'd2 != height);
                    end
                    if (last_step)
                        state_reg <= END;
                end
            default:  // END
                if (end_written)
                    state_reg <= IDLE;
        endcase
        if (rst)
            state_reg <= IDLE;
    end

    assign ap_idle  = (state_reg == IDLE);
    assign ap_done  = end_written;
    assign ap_ready = ap_done;

    // ---- Pixels ----
    // Stage 1 takes the pixel, stage 2 sees it in taps_reg[1:0]; the window's centre is the pixel three steps older.
    reg  [5:0]  column_is1_reg, column_is2_reg;  // column 0 to 5
    reg         step1_reg, step2_reg;
    reg  [13:0] taps_reg;                        // seven masks, newest low
    reg  [7:0]  motion_taps_reg;                 // as far as the centre
    reg  [11:0] high_before_reg;
    reg  [ADDRESS_WIDTH-1:0] column1_reg, column2_reg, column3_reg, column4_reg, centre_reg;
    reg  [5:1]  half_reg;

    assign mask_read    = step && takes1_reg;
    assign motions_read = mask_read;

    wire [1:0]  right3 = (column_is2_reg[2:0] != 3'd0) ? 2'd0 : taps_reg[1:0];
    wire [1:0]  right2 = (column_is2_reg[2:1] != 2'd0) ? 2'd0 : taps_reg[3:2];
    wire [1:0]  right1 = column_is2_reg[2] ? 2'd0 : taps_reg[5:4];
    wire [1:0]  centre = taps_reg[7:6];
    wire [1:0]  left1  = column_is2_reg[3] ? 2'd0 : taps_reg[9:8];
    wire [1:0]  left2  = (column_is2_reg[4:3] != 2'd0) ? 2'd0 : taps_reg[11:10];
    wire [1:0]  left3  = (column_is2_reg[5:3] != 3'd0) ? 2'd0 : taps_reg[13:12];
    wire [1:0]  any    = right3 | right2 | right1 | centre | left1 | left2 | left3;
    wire [1:0]  sum    = {1'b0, right1[1]} + {1'b0, centre[1]} + {1'b0, left1[1]};
    wire [16:0] summary = {motion_taps_reg[7:6], rule_run_rule ? any : sum, centre[1], high_before_reg};

    always @(posedge clk) begin
        if (step) begin
            step1_reg      <= walking;
            step2_reg      <= step1_reg;
            takes1_reg     <= walking && streaming_reg;
            column_is1_reg <= {column_reg == 12'd5, column_reg == 12'd4, column_reg == 12'd3, column_reg == 12'd2, column_reg == 12'd1,
                               column_reg == 12'd0};
            column_is2_reg <= column_is1_reg;
            column1_reg    <= column_reg[ADDRESS_WIDTH-1:0];
            column2_reg    <= column1_reg;
            column3_reg    <= column2_reg;
            column4_reg    <= column3_reg;
            centre_reg     <= column4_reg;
            half_reg       <= {half_reg[4:1], !half};
            if (step1_reg) begin
                taps_reg        <= {taps_reg[11:0], takes1_reg ? mask_dout : 2'd0};
                motion_taps_reg <= {motion_taps_reg[5:0], takes1_reg ? motions_dout : 2'd0};
            end
            if (step2_reg)
                high_before_reg <= column_is2_reg[2] ? 12'd0 : high_before_reg + {11'd0, centre[1]};
        end
        if (state_reg == START) begin
            taps_reg        <= 14'd0;
            motion_taps_reg <= 8'd0;
            high_before_reg <= 12'd0;
        end
        if (rst) begin
            step1_reg  <= 1'b0;
            step2_reg  <= 1'b0;
            takes1_reg <= 1'b0;
        end
    end

    wire [ADDRESS_WIDTH-1:0] left_address, right_address;
    wire [16:0]              left_summary, right_summary;

    ram_1r1w #(.WIDTH(17), .DEPTH(2 * MAX_WIDTH), .ADDRESS_WIDTH(ADDRESS_WIDTH + 1)) left_columns (
        .clk(clk), .write_enable(step && step2_reg), .write_address({centre_reg, half_reg[5]}), .write_data(summary),
        .read_enable(step), .read_address({left_address, half}), .read_data(left_summary)
    );

    ram_1r1w #(.WIDTH(17), .DEPTH(2 * MAX_WIDTH), .ADDRESS_WIDTH(ADDRESS_WIDTH + 1)) right_columns (
        .clk(clk), .write_enable(step && step2_reg), .write_address({centre_reg, half_reg[5]}), .write_data(summary),
        .read_enable(step), .read_address({right_address, half}), .read_data(right_summary)
    );

    // ---- Lines ----
    // Stage 1: setup and state of the line.
    wire [12:0] line_first_column  = lines_q0[12:0];
    wire [11:0] line_first_row     = lines_q0[24:13];
    wire [11:0] line_last_row      = lines_q0[36:25];
    wire [11:0] line_first_run     = lines_q0[48:37];
    wire [11:0] line_last_run      = lines_q0[60:49];
    wire [11:0] line_slice         = lines_q0[72:61];
    wire [11:0] line_remainder     = lines_q0[84:73];
    wire [11:0] line_divisor       = lines_q0[96:85];
    wire [11:0] line_first_error   = lines_q0[108:97];
    wire        line_leftward      = lines_q0[109];
    wire        line_contact_first = lines_q0[110];

    wire [95:0] state_now;
    wire [95:0] state_next;
    wire [12:0] state_column;
    wire [11:0] state_error, state_count, state_first_row, state_last_row, state_score;
    wire        state_carry;
    wire [1:0]  state_present;
    wire [12:0] state_contact_column;
    wire [6:0]  state_motion;
    assign {state_motion, state_contact_column, state_score, state_last_row, state_first_row, state_present, state_count, state_carry,
            state_error, state_column} = state_now;

    reg [11*LOG2_LINES-1:0] index_reg;  // stages 1 to 11
    wire [LOG2_LINES-1:0] index8 = index_reg[8*LOG2_LINES-1 -: LOG2_LINES];
    reg                   state_write_reg;

    assign lines_address0 = index;
    assign lines_ce0      = step;

    ram_1r1w #(.WIDTH(96), .DEPTH(1 << LOG2_LINES), .ADDRESS_WIDTH(LOG2_LINES)) states (
        .clk(clk), .write_enable(step && state_write_reg), .write_address(index8), .write_data(state_next),
        .read_enable(step), .read_address(index), .read_data(state_now)
    );

    wire starts   = (row_reg == line_first_row);
    wire ends     = (row_reg == line_last_row);
    wire early    = (row_reg < line_first_row);
    wire late     = (row_reg > line_last_row);
    wire steep    = (line_slice == 12'd0);
    wire [11:0] plain_run = steep ? 12'd1 : line_slice + {11'd0, state_carry};

    // Stage 2.
    reg        active2, active3, active4, active5, active6, active7;
    reg        ends2, ends3, ends4, ends5, ends6, ends7;
    reg        early2, early3, early4, early5, early6;
    reg        steep2, steep3, steep4;
    reg        leftward2, leftward3, leftward4, leftward5, leftward6;
    reg        first_counts2, first_counts3, first_counts4, first_counts5, first_counts6, first_counts7, first_counts8;
    reg signed [12:0] column2, column3, column4, column5, column6, column7;
    reg [11:0] run2, remainder2, divisor2, divisor3, error2;
    reg [11:0] count2, count3, count4, count5, count6;
    reg [1:0]  present2, present3, present4, present5, present6, present7, present8;
    reg [11:0] first_row2, first_row3, first_row4, first_row5, first_row6, first_row7, first_row8;
    reg [11:0] last_row2, last_row3, last_row4, last_row5, last_row6, last_row7, last_row8;
    reg [6:0]  motion2, motion3, motion4, motion5, motion6, motion7, motion8;  // last row rests; stirring rows; still rows
    reg [11:0] score2, score3, score4, score5, score6, score7, score8;
    reg [12:0] contact_column2, contact_column3, contact_column4, contact_column5, contact_column6, contact_column7, contact_column8;

    // Stage 3: one run further, which is also where the next run of a shallow line begins.
    reg signed [12:0] further3, further4;
    reg [12:0] error_sum3;

    // Stage 4: the other end of the run; the error of the next row.
    reg signed [12:0] other_end4;
    reg        carry4, carry5, carry6, carry7, carry8;
    reg [11:0] error4, error5, error6, error7, error8;
    wire        reaches = (error_sum3 >= {1'b0, divisor3});

    // Stage 5: addresses.
    reg [ADDRESS_WIDTH-1:0] left_address5, right_address5;
    reg        in_image5, in_image6, first_inside5, first_inside6;
    reg [12:0] next_column5, next_column6, next_column7, next_column8;
    wire signed [12:0] left_end  = leftward4 ? other_end4 : column4;
    wire signed [12:0] right_end = leftward4 ? column4 : other_end4;
    wire signed [12:0] end_bound = {1'b0, width};
    wire [ADDRESS_WIDTH-1:0] last_address = width[ADDRESS_WIDTH-1:0] - 1'b1;
    assign left_address  = left_address5;
    assign right_address = right_address5;

    // Stage 6: the summaries of both ends.
    wire [11:0] high_between = right_summary[11:0] + {11'd0, right_summary[12]} - left_summary[11:0];
    wire [1:0]  end_window   = leftward6 ? right_summary[14:13] : left_summary[14:13];
    wire [1:0]  end_motion   = leftward6 ? right_summary[16:15] : left_summary[16:15];

    // Stage 7: the rule.
    reg [11:0] count7, count8;
    reg [1:0]  window7;
    reg [1:0]  end_motion7;
    wire       in_run7    = (present7 != 2'd0);
    wire [1:0] present_now7 = rule_run_rule ? {1'b0, window7[0]} : window7;
    wire       set7       = (present_now7 != 2'd0);
    wire [11:0] high_rows7 = (in_run7 ? score7 : 12'd0) + {11'd0, window7[1]};
    wire [2:0]  still_before7    = in_run7 ? motion7[2:0] : 3'd0;
    wire [2:0]  stirring_before7 = in_run7 ? motion7[5:3] : 3'd0;
    wire [2:0]  still_rows7      = (end_motion7 == 2'd3) ? 3'd0 : (still_before7 == 3'd7) ? 3'd7 : still_before7 + 1'b1;
    wire [2:0]  stirring_rows7   = (end_motion7 == 2'd0) ? stirring_before7 : (stirring_before7 == 3'd7) ? 3'd7 : stirring_before7 + 1'b1;
    wire [11:0] triangle7  = (window7 <= present7) ? score7 + 1'b1 : 12'd0;

    // Stage 8: does the run end?
    reg        set8, in_run8, line_ends8;
    reg [1:0]  present_now8;
    reg [11:0] gap8;
    wire       gap_ends8 = (gap8 > (rule_run_rule ? rule_max_gap : 12'd0));
    wire       ended8    = (in_run8 || set8) && (gap_ends8 || line_ends8);
    wire [1:0] present_next = ended8 ? 2'd0 : set8 ? present_now8 : present8;
    assign state_next = {motion8, contact_column8, score8, last_row8, first_row8, present_next, count8, carry8, error8, next_column8};

    // Stages 9 to 12: is it a contact?
    reg        ended9, ended10, ended11, clipped9, clipped10, clipped11, stands9, stands10, stands11;
    reg [12:0] contact_column9, contact_column10, contact_column11;
    reg [11:0] contact_row9, contact_row10, contact_row11;
    reg [11:0] rows9, rows10, rows11, score9, score10, score11;
    reg signed [13:0] above_horizon10;
    reg signed [24:0] least11;        // Q.8 rows
    reg [13:0] triple10, triple11;
    reg [46:0] contact_reg;
    reg [20:0] count_reg;
    wire signed [17:0] rows_signed = {6'd0, rows11};
    wire       tall11 = rows11 >= rule_min_rows && rows_signed >= $signed({least11[24], least11[24:8]}) && triple11 >= {2'd0, rows11};
    wire       unused_bits = &{1'b0, left_summary[12], least11[7:0]};
    wire       contact11 = ended11 && (rule_run_rule ? tall11 && stands11 : score11 > 12'd4);

    assign step = (!takes1_reg || (mask_empty_n && motions_empty_n)) && (!contact_valid_reg || contacts_full_n) && (!count_valid_reg || counts_full_n);

    assign contacts_write = (contact_valid_reg && step) || end_written;
    assign contacts_din   = contact_valid_reg ? contact_reg : {1'b1, 46'd0};
    assign counts_write   = (count_valid_reg && step) || (state_reg == START && walked_reg == 9'd0 && counts_full_n);
    assign counts_din     = count_valid_reg ? count_reg : {1'b1, 20'd0};

    always @(posedge clk) begin
        if (step) begin
            lines_in_reg <= {lines_in_reg[11:1], in_lines};
            index_reg    <= {index_reg[10*LOG2_LINES-1:0], index};

            active2 <= lines_in_reg[1] && !early && !late;
            ends2   <= ends;
            early2  <= early;
            steep2  <= steep;
            leftward2     <= line_leftward;
            first_counts2 <= rule_run_rule && line_contact_first;
            column2       <= starts ? line_first_column : state_column;
            error2        <= starts ? line_first_error : state_error;
            count2        <= starts ? 12'd0 : state_count;
            present2      <= starts ? 2'd0 : state_present;
            run2          <= ends ? line_last_run : starts ? line_first_run : plain_run;
            remainder2    <= line_remainder;
            divisor2      <= line_divisor;
            first_row2    <= state_first_row;
            last_row2     <= state_last_row;
            score2        <= state_score;
            motion2       <= state_motion;
            contact_column2 <= state_contact_column;

            {active3, ends3, early3, steep3, leftward3, first_counts3} <= {active2, ends2, early2, steep2, leftward2, first_counts2};
            {column3, count3, present3, first_row3} <= {column2, count2, present2, first_row2};
            {last_row3, score3, contact_column3, divisor3} <= {last_row2, score2, contact_column2, divisor2};
            motion3    <= motion2;
            further3   <= leftward2 ? column2 - {1'b0, run2} : column2 + {1'b0, run2};
            error_sum3 <= {1'b0, error2} + {1'b0, remainder2};

            {active4, ends4, early4, steep4, leftward4, first_counts4} <= {active3, ends3, early3, steep3, leftward3, first_counts3};
            {column4, count4, present4, first_row4} <= {column3, count3, present3, first_row3};
            {last_row4, score4, contact_column4, further4} <= {last_row3, score3, contact_column3, further3};
            motion4    <= motion3;
            other_end4 <= leftward3 ? further3 + 13'sd1 : further3 - 13'sd1;
            carry4     <= reaches;
            error4     <= reaches ? error_sum3[11:0] - divisor3 : error_sum3[11:0];

            {active5, ends5, early5, leftward5, first_counts5} <= {active4, ends4, early4, leftward4, first_counts4};
            {column5, count5, present5, first_row5} <= {column4, count4, present4, first_row4};
            {last_row5, score5, contact_column5, carry5, error5} <= {last_row4, score4, contact_column4, carry4, error4};
            motion5        <= motion4;
            left_address5  <= left_end[12] ? {ADDRESS_WIDTH{1'b0}} : (left_end < end_bound) ? left_end[ADDRESS_WIDTH-1:0] : last_address;
            right_address5 <= right_end[12] ? {ADDRESS_WIDTH{1'b0}} : (right_end < end_bound) ? right_end[ADDRESS_WIDTH-1:0] : last_address;
            in_image5      <= (left_end < end_bound) && !right_end[12];
            first_inside5  <= (column4 < end_bound) && !column4[12];
            next_column5   <= !steep4 ? further4 : leftward4 ? column4 - {12'd0, carry4} : column4 + {12'd0, carry4};

            {active6, ends6, early6, leftward6, first_counts6} <= {active5, ends5, early5, leftward5, first_counts5};
            {column6, count6, present6, first_row6} <= {column5, count5, present5, first_row5};
            {last_row6, score6, contact_column6, carry6, error6} <= {last_row5, score5, contact_column5, carry5, error5};
            {motion6, in_image6, first_inside6, next_column6} <= {motion5, in_image5, first_inside5, next_column5};

            {active7, ends7, first_counts7} <= {active6, ends6, first_counts6};
            {column7, present7, first_row7} <= {column6, present6, first_row6};
            {last_row7, score7, contact_column7, carry7, error7, next_column7} <= {last_row6, score6, contact_column6, carry6, error6, next_column6};
            count7  <= count6 + ((active6 && in_image6) ? high_between : 12'd0);
            window7 <= first_inside6 ? end_window : 2'd0;
            motion7 <= motion6;
            end_motion7 <= end_motion;

            {carry8, error8, next_column8, count8, present8, first_counts8} <= {carry7, error7, next_column7, count7, present7, first_counts7};
            state_write_reg <= active7;
            set8            <= set7 && active7;
            in_run8         <= in_run7 && active7;
            line_ends8      <= ends7 || !streaming_reg;
            present_now8    <= present_now7;
            score8          <= !set7 ? score7 : rule_run_rule ? high_rows7 : triangle7;
            motion8         <= set7 ? {!end_motion7[0], stirring_rows7, still_rows7} : motion7;
            first_row8      <= (set7 && !in_run7) ? row_reg : first_row7;
            contact_column8 <= (set7 && (!in_run7 || !first_counts7)) ? column7 : contact_column7;
            last_row8       <= set7 ? row_reg : last_row7;
            gap8            <= set7 ? 12'd0 : row_reg - last_row7;

            ended9          <= ended8;
            clipped9        <= !gap_ends8;
            stands9         <= (motion8[5:3] == 3'd7) && ((motion8[6] && motion8[2:0] == 3'd7) || first_counts8 || !gap_ends8);
            contact_column9 <= contact_column8;
            contact_row9    <= first_counts8 ? first_row8 : last_row8;
            rows9           <= last_row8 - first_row8 + 1'b1;
            score9          <= score8;

            {ended10, clipped10, stands10, contact_column10, contact_row10, rows10, score10} <=
                {ended9, clipped9, stands9, contact_column9, contact_row9, rows9, score9};
            above_horizon10 <= {2'b00, contact_row9} - {rule_horizon_row[12], rule_horizon_row};
            triple10        <= {1'b0, score9, 1'b0} + {2'b00, score9};

            {ended11, clipped11, stands11, contact_column11, contact_row11, rows11, score11, triple11} <=
                {ended10, clipped10, stands10, contact_column10, contact_row10, rows10, score10, triple10};
            least11 <= {{11{above_horizon10[13]}}, above_horizon10} * {15'd0, rule_height_ratio};

            contact_valid_reg <= contact11;
            contact_reg       <= {1'b0, clipped11, rule_run_rule ? rows11 : score11, contact_row11, contact_column11,
                                  index_reg[11*LOG2_LINES-1 -: LOG2_LINES]};

            count_valid_reg <= lines_in_reg[6] && !streaming_reg;
            count_reg       <= {{1'b0, index_reg[6*LOG2_LINES-1 -: LOG2_LINES]} == walked_reg - 1'b1,
                                early6 ? 12'd0 : count6 + ((active6 && in_image6) ? high_between : 12'd0),
                                index_reg[6*LOG2_LINES-1 -: LOG2_LINES]};
        end
        if (rst) begin
            lines_in_reg      <= 12'd0;
            contact_valid_reg <= 1'b0;
            count_valid_reg   <= 1'b0;
            state_write_reg   <= 1'b0;
        end
    end

endmodule

`default_nettype wire
