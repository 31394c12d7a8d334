// Writes the registers of floorline_top once after reset, as a host would: a fixed camera (identity homography), upright lines every
// WIDTH / (LINES + 1) columns, each frame the reference of the next.

`default_nettype none

module register_setup #(
    parameter WIDTH  = 640,
    parameter HEIGHT = 480,
    parameter LINES  = 31
) (
    input  wire        clk,
    input  wire        rst,

    output wire [12:0] m_axil_awaddr,
    output wire        m_axil_awvalid,
    input  wire        m_axil_awready,
    output wire [31:0] m_axil_wdata,
    output wire [3:0]  m_axil_wstrb,
    output wire        m_axil_wvalid,
    input  wire        m_axil_wready,
    input  wire        m_axil_bvalid,
    output wire        m_axil_bready
);

    localparam [31:0] COLUMNS    = WIDTH;
    localparam [31:0] ROWS       = HEIGHT;
    localparam [31:0] LINE_COUNT = LINES;
    localparam [31:0] SPACING    = WIDTH / (LINES + 1);
    localparam [31:0] ONE        = 32'h0004_0000;  // Q14.18
    localparam [31:0] MIDDLE_U   = (WIDTH / 2) * ONE;
    localparam [31:0] MIDDLE_V   = (HEIGHT / 2) * ONE;
    localparam [31:0] ONE_Z      = 32'h1000_0000;  // Q4.28

    // Steps: 0 to 4 * LINES - 1 the line table, then the parameters, then UPDATE and CONTROL; numbered by
    // scripts/registers.py from the register map.
    localparam [31:0] TABLE_STEPS = 4 * LINES;
    localparam [31:0] PARAMETERS  = 39;

    reg [9:0]   step_reg;
    reg [12:0]  column_reg;  // of the line being written
    reg         started_reg;  // the first write has been asked for

    wire        in_table  = (step_reg < TABLE_STEPS[9:0]);
    wire [9:0]  parameter_step = step_reg - TABLE_STEPS[9:0];
    wire [9:0]  control_step   = parameter_step - PARAMETERS[9:0];

    // LineSetup: contact_first, leftward, first_error, divisor, remainder, slice, last_run, first_run, last_row, first_row, first_column.
    wire [127:0] line = {17'd0, 1'b0, 1'b0, 12'd0, 12'd1, 12'd0, 12'd0, 12'd1, 12'd1, ROWS[11:0] - 12'd1, 12'd0, column_reg};
    reg  [31:0]  value;

    always @* begin
        value = 32'd0;
        if (in_table)
            value = line[{step_reg[1:0], 5'd0} +: 32];
        else
            case (parameter_step)
                10'd0:  value = COLUMNS;        // WIDTH
                10'd1:  value = ROWS;           // HEIGHT
                10'd2:  value = 32'd1;          // GREY
                10'd3:  value = 32'd1;          // REPLACE_REFERENCE
                10'd6:  value = ROWS - 32'd1;   // ROI_LAST_ROW
                10'd7:  value = LINE_COUNT;     // LINE_COUNT
                10'd8:  value = 32'h0000_8000;  // CLUSTER_GAP: 0.5 m
                10'd9:  value = ONE;            // HOMOGRAPHY_XU
                10'd11: value = -MIDDLE_U;      // HOMOGRAPHY_X1
                10'd13: value = ONE;            // HOMOGRAPHY_YV
                10'd14: value = -MIDDLE_V;      // HOMOGRAPHY_Y1
                10'd17: value = ONE_Z;          // HOMOGRAPHY_Z1
                10'd18: value = 32'd2621;       // BIRDSEYE_XU: 1 cm a pixel
                10'd22: value = 32'd2621;       // BIRDSEYE_YV
                10'd26: value = ONE_Z;          // BIRDSEYE_Z1
                10'd27: value = 32'd20;         // THRESHOLD_FLOOR
                10'd29: value = 32'd12;         // THRESHOLD_LOW
                10'd30: value = 32'd255;        // DISPLACEMENT_NOISE: no foot test, since the whole box moves
                10'd33: value = 32'd1;          // RULE_RUN_RULE
                10'd34: value = 32'd12;         // RULE_MIN_ROWS
                10'd35: value = 32'd3;          // RULE_MAX_GAP
                10'd38: value = 32'd1;          // RULE_MIN_LINES
                10'd39: value = 32'd3;          // UPDATE: parameters and lines
                10'd40: value = 32'd1;          // CONTROL: enable
                default: value = 32'd0;
            endcase
    end

    assign m_axil_awaddr  = in_table ? {1'b1, step_reg, 2'b00} :
                            (parameter_step < PARAMETERS[9:0]) ? {5'd1, parameter_step[5:0], 2'b00} :
                            (control_step == 10'd0) ? 13'h010 : 13'h00c;
    assign m_axil_wdata   = value;
    assign m_axil_wstrb   = 4'b1111;
    assign m_axil_bready  = 1'b1;

    // Address and data wait for each other: one write at a time, its answer ends the step.
    reg asking_reg;
    assign m_axil_awvalid = asking_reg;
    assign m_axil_wvalid  = asking_reg;

    always @(posedge clk) begin
        if (m_axil_awready && m_axil_wready)
            asking_reg <= 1'b0;
        else if (m_axil_bvalid)
            asking_reg <= !(control_step == 10'd1);
        else if (!started_reg) begin
            asking_reg <= 1'b1;
            started_reg   <= 1'b1;
        end

        if (m_axil_bvalid) begin
            step_reg <= step_reg + 1'b1;
            if (in_table && step_reg[1:0] == 2'd3)
                column_reg <= column_reg + SPACING[12:0];
        end
        if (rst) begin
            step_reg   <= 10'd0;
            column_reg <= SPACING[12:0];
            asking_reg <= 1'b0;
            started_reg   <= 1'b0;
        end
    end

endmodule

`default_nettype wire
