// Register file of floorline_top: AXI4-Lite slave, control, status, interrupt, and the shadowed frame parameters.
// Generated from rtl/registers.yaml by scripts/registers.py; change the map, not this file.
//
// Parameters are written into a small RAM at any time. A pulse on `load` copies all of them into the registers that the core
// sees, one a cycle, and load_done tells the end; reads of the host wait meanwhile. docs/registers.md has the map.

`default_nettype none

module axil_registers (
    input  wire         clk,
    input  wire         rst,

    input  wire [12:0]  s_axil_awaddr,
    input  wire         s_axil_awvalid,
    output wire         s_axil_awready,
    input  wire [31:0]  s_axil_wdata,
    input  wire [3:0]   s_axil_wstrb,
    input  wire         s_axil_wvalid,
    output wire         s_axil_wready,
    output wire [1:0]   s_axil_bresp,
    output wire         s_axil_bvalid,
    input  wire         s_axil_bready,
    input  wire [12:0]  s_axil_araddr,
    input  wire         s_axil_arvalid,
    output wire         s_axil_arready,
    output wire [31:0]  s_axil_rdata,
    output wire [1:0]   s_axil_rresp,
    output wire         s_axil_rvalid,
    input  wire         s_axil_rready,

    output reg          irq,

    output wire         line_write,          // a word for the line table
    output wire [9:0]   line_write_address,  // line << 2 | word
    output wire [31:0]  line_write_data,

    input  wire         load,                // take the frame parameters
    output reg          load_done,
    input  wire [27:0]  limits,
    output wire         enable,
    output wire [1:0]   update,
    input  wire [1:0]   update_done,
    input  wire [6:0]   events,
    input  wire [31:0]  frames,
    input  wire [23:0]  malformed_frames,
    input  wire [23:0]  dropped_frames,
    input  wire [23:0]  frame_cycles,
    input  wire [23:0]  input_stalls,
    input  wire [23:0]  output_stalls,
    input  wire [23:0]  first_result_latency,
    input  wire [23:0]  decision_latency,
    input  wire [23:0]  null_pixels,
    input  wire [7:0]   threshold_used,
    output wire [11:0]  width,
    output wire [11:0]  height,
    output wire         grey,
    output wire         replace_reference,
    output wire         erode_high,
    output wire [11:0]  roi_first_row,
    output wire [11:0]  roi_last_row,
    output wire [8:0]   line_count,
    output wire [23:0]  cluster_gap,
    output wire [31:0]  homography_xu,
    output wire [31:0]  homography_xv,
    output wire [31:0]  homography_x1,
    output wire [31:0]  homography_yu,
    output wire [31:0]  homography_yv,
    output wire [31:0]  homography_y1,
    output wire [31:0]  homography_zu,
    output wire [31:0]  homography_zv,
    output wire [31:0]  homography_z1,
    output wire [31:0]  birdseye_xu,
    output wire [31:0]  birdseye_xv,
    output wire [31:0]  birdseye_x1,
    output wire [31:0]  birdseye_yu,
    output wire [31:0]  birdseye_yv,
    output wire [31:0]  birdseye_y1,
    output wire [31:0]  birdseye_zu,
    output wire [31:0]  birdseye_zv,
    output wire [31:0]  birdseye_z1,
    output wire [7:0]   threshold_floor,
    output wire [7:0]   threshold_override_high,
    output wire [7:0]   threshold_low,
    output wire [7:0]   displacement_noise,
    output wire [23:0]  displacement_bound,
    output wire [23:0]  displacement_bound_step,
    output wire         rule_run_rule,
    output wire [11:0]  rule_min_rows,
    output wire [11:0]  rule_max_gap,
    output wire [12:0]  rule_horizon_row,
    output wire [9:0]   rule_height_ratio,
    output wire [7:0]   rule_min_lines
);

    wire         write_strobe;
    wire [10:0]  write_address;
    wire [31:0]  write_data;
    wire [10:0]  read_address;

    // Word addresses: 10 the line table, else 9:6 = 0 registers, 9:6 = 1 frame parameters.
    wire         in_lines      = write_address[10];
    wire         in_registers  = (write_address[10:6] == 5'd0);
    wire         in_parameters = (write_address[10:6] == 5'd1);
    wire [5:0]   write_index   = write_address[5:0];
    wire         write_mapped  = in_lines || (in_parameters && write_index <= 6'd38) ||
                                 (in_registers && (write_index == 6'd3 || write_index == 6'd4 || write_index == 6'd5 || write_index == 6'd6));

    reg          loading_reg;
    reg          reading_store_reg;  // a cycle after loading_reg: a read of the host that had begun is over
    reg [5:0]    load_index_reg;
    reg [31:0]   register_word;      // what the host reads
    wire [31:0]  store_word;
    wire         read_mapped = read_address[10:7] == 4'd0 &&
                               read_address[5:0] <= (read_address[6] ? 6'd38 : 6'd16);

    axil_slave #(
        .ADDRESS_WIDTH(13)
    ) slave (
        .clk           (clk),
        .rst           (rst),
        .s_axil_awaddr (s_axil_awaddr),
        .s_axil_awvalid(s_axil_awvalid),
        .s_axil_awready(s_axil_awready),
        .s_axil_wdata  (s_axil_wdata),
        .s_axil_wstrb  (s_axil_wstrb),
        .s_axil_wvalid (s_axil_wvalid),
        .s_axil_wready (s_axil_wready),
        .s_axil_bresp  (s_axil_bresp),
        .s_axil_bvalid (s_axil_bvalid),
        .s_axil_bready (s_axil_bready),
        .s_axil_araddr (s_axil_araddr),
        .s_axil_arvalid(s_axil_arvalid),
        .s_axil_arready(s_axil_arready),
        .s_axil_rdata  (s_axil_rdata),
        .s_axil_rresp  (s_axil_rresp),
        .s_axil_rvalid (s_axil_rvalid),
        .s_axil_rready (s_axil_rready),
        .write_strobe  (write_strobe),
        .write_address (write_address),
        .write_data    (write_data),
        .write_error   (!write_mapped),
        .read_hold     (loading_reg),
        .read_address  (read_address),
        .read_data     (read_address[6] ? store_word : register_word),
        .read_error    (!read_mapped)
    );

    assign line_write         = write_strobe && in_lines;
    assign line_write_address = write_address[9:0];
    assign line_write_data    = write_data;

    // Registers.
    reg         control_reg;
    reg [1:0]   update_reg;
    reg [6:0]   interrupt_enable_reg;
    reg [6:0]   interrupt_status_reg;

    assign enable = control_reg;
    assign update = update_reg;

    always @(posedge clk) begin
        if (write_strobe && in_registers && write_index == 6'd3)
            control_reg <= write_data[0];
        update_reg <= (update_reg & ~update_done) | ({2{write_strobe && in_registers && write_index == 6'd4}} & write_data[1:0]);
        if (write_strobe && in_registers && write_index == 6'd5)
            interrupt_enable_reg <= write_data[6:0];
        interrupt_status_reg <= (interrupt_status_reg & ~({7{write_strobe && in_registers && write_index == 6'd6}} & write_data[6:0])) | events;
        irq <= |(interrupt_enable_reg & interrupt_status_reg);

        if (rst) begin
            control_reg <= 1'd0;
            update_reg <= 2'd0;
            interrupt_enable_reg <= 7'd0;
            interrupt_status_reg <= 7'd0;
            irq <= 1'b0;
        end
    end

    always @* begin
        case (read_address[5:0])
            6'd0: register_word = 32'h464c5231;
            6'd1: register_word = 32'h00000100;
            6'd2: register_word = {4'd0, limits};
            6'd3: register_word = {31'd0, control_reg};
            6'd4: register_word = {30'd0, update_reg};
            6'd5: register_word = {25'd0, interrupt_enable_reg};
            6'd6: register_word = {25'd0, interrupt_status_reg};
            6'd7: register_word = frames;
            6'd8: register_word = {8'd0, malformed_frames};
            6'd9: register_word = {8'd0, dropped_frames};
            6'd10: register_word = {8'd0, frame_cycles};
            6'd11: register_word = {8'd0, input_stalls};
            6'd12: register_word = {8'd0, output_stalls};
            6'd13: register_word = {8'd0, first_result_latency};
            6'd14: register_word = {8'd0, decision_latency};
            6'd15: register_word = {8'd0, null_pixels};
            6'd16: register_word = {24'd0, threshold_used};
            default: register_word = 32'd0;
        endcase
    end

    // Frame parameters: what the host wrote. In LUTs, from where a word is there sooner than from a block RAM.
    (* ram_style = "distributed" *)
    reg [31:0] store [0:63];

    always @(posedge clk)
        if (write_strobe && in_parameters)
            store[write_index] <= write_data;
    assign store_word = store[reading_store_reg ? load_index_reg : read_address[5:0]];

    // Loading: the word of load_index_reg is in loaded_word_reg one cycle later, when the parameter's bit of loaded_reg is 1.
    reg [38:0] loaded_reg;
    reg [31:0] loaded_word_reg;

    always @(posedge clk) begin
        reading_store_reg <= loading_reg && !(reading_store_reg && load_index_reg == 6'd38);
        load_index_reg    <= reading_store_reg ? load_index_reg + 1'b1 : 6'd0;
        loaded_reg        <= {loaded_reg[37:0], reading_store_reg && load_index_reg == 6'd0};
        loaded_word_reg   <= store_word;
        load_done         <= loaded_reg[38];
        if (load)
            loading_reg <= 1'b1;
        else if (reading_store_reg && load_index_reg == 6'd38)
            loading_reg <= 1'b0;

        if (rst) begin
            loading_reg       <= 1'b0;
            reading_store_reg <= 1'b0;
            loaded_reg        <= 39'd0;
            load_done         <= 1'b0;
        end
    end

    // Frame parameters: what the core sees.
    reg [11:0] width_reg;
    reg [11:0] height_reg;
    reg        grey_reg;
    reg        replace_reference_reg;
    reg        erode_high_reg;
    reg [11:0] roi_first_row_reg;
    reg [11:0] roi_last_row_reg;
    reg [8:0]  line_count_reg;
    reg [23:0] cluster_gap_reg;
    reg [31:0] homography_xu_reg;
    reg [31:0] homography_xv_reg;
    reg [31:0] homography_x1_reg;
    reg [31:0] homography_yu_reg;
    reg [31:0] homography_yv_reg;
    reg [31:0] homography_y1_reg;
    reg [31:0] homography_zu_reg;
    reg [31:0] homography_zv_reg;
    reg [31:0] homography_z1_reg;
    reg [31:0] birdseye_xu_reg;
    reg [31:0] birdseye_xv_reg;
    reg [31:0] birdseye_x1_reg;
    reg [31:0] birdseye_yu_reg;
    reg [31:0] birdseye_yv_reg;
    reg [31:0] birdseye_y1_reg;
    reg [31:0] birdseye_zu_reg;
    reg [31:0] birdseye_zv_reg;
    reg [31:0] birdseye_z1_reg;
    reg [7:0]  threshold_floor_reg;
    reg [7:0]  threshold_override_high_reg;
    reg [7:0]  threshold_low_reg;
    reg [7:0]  displacement_noise_reg;
    reg [23:0] displacement_bound_reg;
    reg [23:0] displacement_bound_step_reg;
    reg        rule_run_rule_reg;
    reg [11:0] rule_min_rows_reg;
    reg [11:0] rule_max_gap_reg;
    reg [12:0] rule_horizon_row_reg;
    reg [9:0]  rule_height_ratio_reg;
    reg [7:0]  rule_min_lines_reg;

    assign width = width_reg;
    assign height = height_reg;
    assign grey = grey_reg;
    assign replace_reference = replace_reference_reg;
    assign erode_high = erode_high_reg;
    assign roi_first_row = roi_first_row_reg;
    assign roi_last_row = roi_last_row_reg;
    assign line_count = line_count_reg;
    assign cluster_gap = cluster_gap_reg;
    assign homography_xu = homography_xu_reg;
    assign homography_xv = homography_xv_reg;
    assign homography_x1 = homography_x1_reg;
    assign homography_yu = homography_yu_reg;
    assign homography_yv = homography_yv_reg;
    assign homography_y1 = homography_y1_reg;
    assign homography_zu = homography_zu_reg;
    assign homography_zv = homography_zv_reg;
    assign homography_z1 = homography_z1_reg;
    assign birdseye_xu = birdseye_xu_reg;
    assign birdseye_xv = birdseye_xv_reg;
    assign birdseye_x1 = birdseye_x1_reg;
    assign birdseye_yu = birdseye_yu_reg;
    assign birdseye_yv = birdseye_yv_reg;
    assign birdseye_y1 = birdseye_y1_reg;
    assign birdseye_zu = birdseye_zu_reg;
    assign birdseye_zv = birdseye_zv_reg;
    assign birdseye_z1 = birdseye_z1_reg;
    assign threshold_floor = threshold_floor_reg;
    assign threshold_override_high = threshold_override_high_reg;
    assign threshold_low = threshold_low_reg;
    assign displacement_noise = displacement_noise_reg;
    assign displacement_bound = displacement_bound_reg;
    assign displacement_bound_step = displacement_bound_step_reg;
    assign rule_run_rule = rule_run_rule_reg;
    assign rule_min_rows = rule_min_rows_reg;
    assign rule_max_gap = rule_max_gap_reg;
    assign rule_horizon_row = rule_horizon_row_reg;
    assign rule_height_ratio = rule_height_ratio_reg;
    assign rule_min_lines = rule_min_lines_reg;

    always @(posedge clk) begin
        if (loaded_reg[0])
            width_reg <= loaded_word_reg[11:0];
        if (loaded_reg[1])
            height_reg <= loaded_word_reg[11:0];
        if (loaded_reg[2])
            grey_reg <= loaded_word_reg[0];
        if (loaded_reg[3])
            replace_reference_reg <= loaded_word_reg[0];
        if (loaded_reg[4])
            erode_high_reg <= loaded_word_reg[0];
        if (loaded_reg[5])
            roi_first_row_reg <= loaded_word_reg[11:0];
        if (loaded_reg[6])
            roi_last_row_reg <= loaded_word_reg[11:0];
        if (loaded_reg[7])
            line_count_reg <= loaded_word_reg[8:0];
        if (loaded_reg[8])
            cluster_gap_reg <= loaded_word_reg[23:0];
        if (loaded_reg[9])
            homography_xu_reg <= loaded_word_reg;
        if (loaded_reg[10])
            homography_xv_reg <= loaded_word_reg;
        if (loaded_reg[11])
            homography_x1_reg <= loaded_word_reg;
        if (loaded_reg[12])
            homography_yu_reg <= loaded_word_reg;
        if (loaded_reg[13])
            homography_yv_reg <= loaded_word_reg;
        if (loaded_reg[14])
            homography_y1_reg <= loaded_word_reg;
        if (loaded_reg[15])
            homography_zu_reg <= loaded_word_reg;
        if (loaded_reg[16])
            homography_zv_reg <= loaded_word_reg;
        if (loaded_reg[17])
            homography_z1_reg <= loaded_word_reg;
        if (loaded_reg[18])
            birdseye_xu_reg <= loaded_word_reg;
        if (loaded_reg[19])
            birdseye_xv_reg <= loaded_word_reg;
        if (loaded_reg[20])
            birdseye_x1_reg <= loaded_word_reg;
        if (loaded_reg[21])
            birdseye_yu_reg <= loaded_word_reg;
        if (loaded_reg[22])
            birdseye_yv_reg <= loaded_word_reg;
        if (loaded_reg[23])
            birdseye_y1_reg <= loaded_word_reg;
        if (loaded_reg[24])
            birdseye_zu_reg <= loaded_word_reg;
        if (loaded_reg[25])
            birdseye_zv_reg <= loaded_word_reg;
        if (loaded_reg[26])
            birdseye_z1_reg <= loaded_word_reg;
        if (loaded_reg[27])
            threshold_floor_reg <= loaded_word_reg[7:0];
        if (loaded_reg[28])
            threshold_override_high_reg <= loaded_word_reg[7:0];
        if (loaded_reg[29])
            threshold_low_reg <= loaded_word_reg[7:0];
        if (loaded_reg[30])
            displacement_noise_reg <= loaded_word_reg[7:0];
        if (loaded_reg[31])
            displacement_bound_reg <= loaded_word_reg[23:0];
        if (loaded_reg[32])
            displacement_bound_step_reg <= loaded_word_reg[23:0];
        if (loaded_reg[33])
            rule_run_rule_reg <= loaded_word_reg[0];
        if (loaded_reg[34])
            rule_min_rows_reg <= loaded_word_reg[11:0];
        if (loaded_reg[35])
            rule_max_gap_reg <= loaded_word_reg[11:0];
        if (loaded_reg[36])
            rule_horizon_row_reg <= loaded_word_reg[12:0];
        if (loaded_reg[37])
            rule_height_ratio_reg <= loaded_word_reg[9:0];
        if (loaded_reg[38])
            rule_min_lines_reg <= loaded_word_reg[7:0];
    end

endmodule

`default_nettype wire
