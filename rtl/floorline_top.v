// Floorline: video in, obstacle positions on the floor out. The generated core with what makes it a peripheral.
//
//   video -> skid buffer -> frame guard -> core (floorline_accelerator) -> result streams -> points, obstacles, line counts
//   AXI4-Lite -> registers -> frame start, line table; counters and interrupt
//
// One clock, synchronous active-low reset (AXI's). Video: RGB with G in 7:0, B in 15:8, R in 23:16; grey in 7:0 when the register
// GREY is 1. Results: one packet a frame, elements as in hls/types.h with their fields packed from bit 0; TLAST on the frame's
// end element, TUSER there: the frame was malformed. Registers: docs/registers.md. Malformed input: rtl/frame_guard.v.
// The core is floorline_accelerator, or the one that FLOORLINE_CORE names, whose maxima the parameters must then be.
// The tap_ outputs show what passes between stages of the core, each a stream of width * height elements a frame: difference image
// (8 bits), motions (2), the difference's Gaussian (8), masks in the region of interest (2: high, low). An element passes in a cycle in which
// TVALID and TREADY are 1; both are outputs, so nothing waits for who looks. Left open they cost nothing.
// After a malformed frame that was to become the reference, no pixel is valid until a good frame has replaced it, so that a
// broken reference gives no false obstacle.

`default_nettype none

`ifndef FLOORLINE_CORE
`define FLOORLINE_CORE floorline_accelerator
`endif

module floorline_top #(
    parameter MAX_WIDTH  = 640,  // as generated; here for LIMITS and for refusing what the core cannot hold
    parameter MAX_HEIGHT = 480,
    parameter LOG2_LINES = 8     // lines of the table
) (
    input  wire         aclk,
    input  wire         aresetn,

    input  wire [12:0]   s_axil_awaddr,
    input  wire          s_axil_awvalid,
    output wire          s_axil_awready,
    input  wire [31:0]   s_axil_wdata,
    input  wire [3:0]    s_axil_wstrb,
    input  wire          s_axil_wvalid,
    output wire          s_axil_wready,
    output wire [1:0]    s_axil_bresp,
    output wire          s_axil_bvalid,
    input  wire          s_axil_bready,
    input  wire [12:0]   s_axil_araddr,
    input  wire          s_axil_arvalid,
    output wire          s_axil_arready,
    output wire [31:0]   s_axil_rdata,
    output wire [1:0]    s_axil_rresp,
    output wire          s_axil_rvalid,
    input  wire          s_axil_rready,
    output wire          irq,

    input  wire [23:0]   s_axis_video_tdata,
    input  wire          s_axis_video_tuser,
    input  wire          s_axis_video_tlast,
    input  wire          s_axis_video_tvalid,
    output wire          s_axis_video_tready,

    output wire [95:0]   m_axis_points_tdata,
    output wire          m_axis_points_tuser,
    output wire          m_axis_points_tlast,
    output wire          m_axis_points_tvalid,
    input  wire          m_axis_points_tready,

    output wire [103:0]  m_axis_obstacles_tdata,
    output wire          m_axis_obstacles_tuser,
    output wire          m_axis_obstacles_tlast,
    output wire          m_axis_obstacles_tvalid,
    input  wire          m_axis_obstacles_tready,

    output wire [23:0]   m_axis_counts_tdata,
    output wire          m_axis_counts_tuser,
    output wire          m_axis_counts_tlast,
    output wire          m_axis_counts_tvalid,
    input  wire          m_axis_counts_tready,

    output wire [7:0]    tap_difference_tdata,
    output wire          tap_difference_tvalid,
    output wire          tap_difference_tready,

    output wire [7:0]    tap_motion_tdata,
    output wire          tap_motion_tvalid,
    output wire          tap_motion_tready,

    output wire [7:0]    tap_blurred_tdata,
    output wire          tap_blurred_tvalid,
    output wire          tap_blurred_tready,

    output wire [7:0]    tap_region_tdata,
    output wire          tap_region_tvalid,
    output wire          tap_region_tready
);

    reg rst;
    always @(posedge aclk)
        rst <= !aresetn;

    // Registers.
    wire         load, load_done, lines_done, line_bank;
    wire [1:0]   update;
    wire         enable;
    wire [6:0]   events;
    wire         line_write;
    wire [9:0]   line_write_address;
    wire [31:0]  line_write_data;
    wire [31:0]  frames;
    wire [23:0]  malformed_frames, dropped_frames, frame_cycles, input_stalls, output_stalls;
    wire [23:0]  first_result_latency, decision_latency;
    reg  [23:0]  null_pixels_reg;
    reg  [7:0]   threshold_used_reg;
    wire [11:0]  width;
    wire [11:0]  height;
    wire         grey;
    wire         replace_reference;
    wire         erode_high;
    wire [11:0]  roi_first_row;
    wire [11:0]  roi_last_row;
    wire [8:0]   line_count;
    wire [23:0]  cluster_gap;
    wire [31:0]  homography_xu;
    wire [31:0]  homography_xv;
    wire [31:0]  homography_x1;
    wire [31:0]  homography_yu;
    wire [31:0]  homography_yv;
    wire [31:0]  homography_y1;
    wire [31:0]  homography_zu;
    wire [31:0]  homography_zv;
    wire [31:0]  homography_z1;
    wire [31:0]  birdseye_xu;
    wire [31:0]  birdseye_xv;
    wire [31:0]  birdseye_x1;
    wire [31:0]  birdseye_yu;
    wire [31:0]  birdseye_yv;
    wire [31:0]  birdseye_y1;
    wire [31:0]  birdseye_zu;
    wire [31:0]  birdseye_zv;
    wire [31:0]  birdseye_z1;
    wire [7:0]   threshold_floor;
    wire [7:0]   threshold_override_high;
    wire [7:0]   threshold_low;
    wire [7:0]   displacement_noise;
    wire [23:0]  displacement_bound;
    wire [23:0]  displacement_bound_step;
    wire         rule_run_rule;
    wire [11:0]  rule_min_rows;
    wire [11:0]  rule_max_gap;
    wire [12:0]  rule_horizon_row;
    wire [9:0]   rule_height_ratio;
    wire [7:0]   rule_min_lines;

    localparam [31:0] LIMIT_WIDTH  = MAX_WIDTH;
    localparam [31:0] LIMIT_HEIGHT = MAX_HEIGHT;
    localparam [31:0] LIMIT_LINES  = LOG2_LINES;

    axil_registers registers (
        .clk                 (aclk),
        .rst                 (rst),
        .s_axil_awaddr       (s_axil_awaddr),
        .s_axil_awvalid      (s_axil_awvalid),
        .s_axil_awready      (s_axil_awready),
        .s_axil_wdata        (s_axil_wdata),
        .s_axil_wstrb        (s_axil_wstrb),
        .s_axil_wvalid       (s_axil_wvalid),
        .s_axil_wready       (s_axil_wready),
        .s_axil_bresp        (s_axil_bresp),
        .s_axil_bvalid       (s_axil_bvalid),
        .s_axil_bready       (s_axil_bready),
        .s_axil_araddr       (s_axil_araddr),
        .s_axil_arvalid      (s_axil_arvalid),
        .s_axil_arready      (s_axil_arready),
        .s_axil_rdata        (s_axil_rdata),
        .s_axil_rresp        (s_axil_rresp),
        .s_axil_rvalid       (s_axil_rvalid),
        .s_axil_rready       (s_axil_rready),
        .irq                 (irq),
        .line_write          (line_write),
        .line_write_address  (line_write_address),
        .line_write_data     (line_write_data),
        .load                (load),
        .load_done           (load_done),
        .limits              ({LIMIT_LINES[3:0], LIMIT_HEIGHT[11:0], LIMIT_WIDTH[11:0]}),
        .enable              (enable),
        .update              (update),
        .update_done         ({lines_done, load_done}),
        .events              (events),
        .frames              (frames),
        .malformed_frames    (malformed_frames),
        .dropped_frames      (dropped_frames),
        .frame_cycles        (frame_cycles),
        .input_stalls        (input_stalls),
        .output_stalls       (output_stalls),
        .first_result_latency (first_result_latency),
        .decision_latency    (decision_latency),
        .null_pixels         (null_pixels_reg),
        .threshold_used      (threshold_used_reg),
        .width               (width),
        .height              (height),
        .grey                (grey),
        .replace_reference   (replace_reference),
        .erode_high          (erode_high),
        .roi_first_row       (roi_first_row),
        .roi_last_row        (roi_last_row),
        .line_count          (line_count),
        .cluster_gap         (cluster_gap),
        .homography_xu       (homography_xu),
        .homography_xv       (homography_xv),
        .homography_x1       (homography_x1),
        .homography_yu       (homography_yu),
        .homography_yv       (homography_yv),
        .homography_y1       (homography_y1),
        .homography_zu       (homography_zu),
        .homography_zv       (homography_zv),
        .homography_z1       (homography_z1),
        .birdseye_xu         (birdseye_xu),
        .birdseye_xv         (birdseye_xv),
        .birdseye_x1         (birdseye_x1),
        .birdseye_yu         (birdseye_yu),
        .birdseye_yv         (birdseye_yv),
        .birdseye_y1         (birdseye_y1),
        .birdseye_zu         (birdseye_zu),
        .birdseye_zv         (birdseye_zv),
        .birdseye_z1         (birdseye_z1),
        .threshold_floor     (threshold_floor),
        .threshold_override_high (threshold_override_high),
        .threshold_low       (threshold_low),
        .displacement_noise  (displacement_noise),
        .displacement_bound  (displacement_bound),
        .displacement_bound_step (displacement_bound_step),
        .rule_run_rule       (rule_run_rule),
        .rule_min_rows       (rule_min_rows),
        .rule_max_gap        (rule_max_gap),
        .rule_horizon_row    (rule_horizon_row),
        .rule_height_ratio   (rule_height_ratio),
        .rule_min_lines      (rule_min_lines)
    );

    // Video in: buffered, so that no path runs from TVALID to TREADY, then guarded. The core buffers its inputs itself.
    wire [25:0]  video;
    wire         video_valid, video_ready;
    wire [23:0]  pixel;
    wire         pixel_valid, pixel_ready;
    wire         start_request, start_grant, refuse;
    wire         frame_done, frame_malformed, early_sof, late_sof, short_line, long_line, disabled_in_frame, frame_dropped;
    wire         line_done;

    skid_buffer #(
        .WIDTH(26)
    ) video_buffer (
        .clk    (aclk),
        .rst    (rst),
        .s_data ({s_axis_video_tlast, s_axis_video_tuser, s_axis_video_tdata}),
        .s_valid(s_axis_video_tvalid),
        .s_ready(s_axis_video_tready),
        .m_data (video),
        .m_valid(video_valid),
        .m_ready(video_ready)
    );

    frame_guard guard (
        .clk                (aclk),
        .rst                (rst),
        .s_axis_video_tdata (video[23:0]),
        .s_axis_video_tuser (video[24]),
        .s_axis_video_tlast (video[25]),
        .s_axis_video_tvalid(video_valid),
        .s_axis_video_tready(video_ready),
        .m_data             (pixel),
        .m_valid            (pixel_valid),
        .m_ready            (pixel_ready),
        .start_request      (start_request),
        .start_grant        (start_grant),
        .refuse             (refuse),
        .enable             (enable),
        .width              (width),
        .height             (height),
        .line_done          (line_done),
        .frame_done         (frame_done),
        .frame_malformed    (frame_malformed),
        .early_sof          (early_sof),
        .late_sof           (late_sof),
        .short_line         (short_line),
        .long_line          (long_line),
        .disabled_in_frame  (disabled_in_frame),
        .frame_dropped      (frame_dropped)
    );

    // Start of frame.
    wire core_ready;
    wire points_room, obstacles_room, counts_room;
    wire points_empty, obstacles_empty, counts_empty;
    reg  core_start_reg;
    reg  reference_lost_reg;  // a malformed frame was to become the reference

    wire frame_start = start_grant && !refuse;

    frame_start #(
        .MAX_WIDTH (MAX_WIDTH),
        .MAX_HEIGHT(MAX_HEIGHT)
    ) start (
        .clk              (aclk),
        .rst              (rst),
        .start_request    (start_request),
        .start_grant      (start_grant),
        .refuse           (refuse),
        .update_parameters(update[0]),
        .update_lines     (update[1]),
        .load             (load),
        .load_done        (load_done),
        .lines_done       (lines_done),
        .line_bank        (line_bank),
        .width            (width),
        .height           (height),
        .core_ready       (!core_start_reg),
        .core_empty       (points_empty && obstacles_empty && counts_empty),
        .results_room     (points_room && obstacles_room && counts_room)
    );

    always @(posedge aclk) begin
        if (frame_start)
            core_start_reg <= 1'b1;
        else if (core_ready)
            core_start_reg <= 1'b0;

        if (frame_done && replace_reference)
            reference_lost_reg <= frame_malformed;

        if (rst) begin
            core_start_reg     <= 1'b0;
            reference_lost_reg <= 1'b0;
        end
    end

    // Core.
    wire [95:0]           points_tdata;
    wire                  points_tvalid, points_tready;
    wire [103:0]          obstacles_tdata;
    wire                  obstacles_tvalid, obstacles_tready;
    wire [23:0]           counts_tdata;
    wire                  counts_tvalid, counts_tready;
    wire [23:0]           null_pixels_tdata;
    wire                  null_pixels_tvalid;
    wire [7:0]            threshold_used_tdata;
    wire                  threshold_used_tvalid;
    wire [LOG2_LINES-1:0] lines_address;
    wire                  lines_enable;
    wire [110:0]          lines_data;
    wire                  unused_done, unused_idle;

    `FLOORLINE_CORE core (
        .ap_clk                                  (aclk),
        .ap_rst_n                                (!rst),
        .ap_start                                (core_start_reg),
        .ap_ready                                (core_ready),
        .ap_done                                 (unused_done),
        .ap_idle                                 (unused_idle),
        .pixels_TDATA                            (pixel),
        .pixels_TVALID                           (pixel_valid),
        .pixels_TREADY                           (pixel_ready),
        .points_TDATA                            (points_tdata),
        .points_TVALID                           (points_tvalid),
        .points_TREADY                           (points_tready),
        .obstacles_TDATA                         (obstacles_tdata),
        .obstacles_TVALID                        (obstacles_tvalid),
        .obstacles_TREADY                        (obstacles_tready),
        .counts_TDATA                            (counts_tdata),
        .counts_TVALID                           (counts_tvalid),
        .counts_TREADY                           (counts_tready),
        .null_pixels_TDATA                       (null_pixels_tdata),
        .null_pixels_TVALID                      (null_pixels_tvalid),
        .null_pixels_TREADY                      (1'b1),
        .threshold_used_TDATA                    (threshold_used_tdata),
        .threshold_used_TVALID                   (threshold_used_tvalid),
        .threshold_used_TREADY                   (1'b1),
        .difference_out_tap_TDATA                (tap_difference_tdata),
        .difference_out_tap_TVALID               (tap_difference_tvalid),
        .difference_out_tap_TREADY               (tap_difference_tready),
        .motions_tap_TDATA                       (tap_motion_tdata),
        .motions_tap_TVALID                      (tap_motion_tvalid),
        .motions_tap_TREADY                      (tap_motion_tready),
        .blurred_tap_TDATA                       (tap_blurred_tdata),
        .blurred_tap_TVALID                      (tap_blurred_tvalid),
        .blurred_tap_TREADY                      (tap_blurred_tready),
        .region_tap_TDATA                        (tap_region_tdata),
        .region_tap_TVALID                       (tap_region_tvalid),
        .region_tap_TREADY                       (tap_region_tready),
        .lines_address0                          (lines_address),
        .lines_ce0                               (lines_enable),
        .lines_q0                                (lines_data),
        .parameters_width_V                      (width),
        .parameters_height_V                     (height),
        .parameters_grey_V                       (grey),
        .parameters_replace_reference_V          (replace_reference),
        .parameters_erode_high_V                 (erode_high),
        .parameters_roi_first_row_V              (roi_first_row),
        .parameters_roi_last_row_V               (roi_last_row),
        .parameters_line_count_V                 (line_count),
        .parameters_cluster_gap_V                (cluster_gap),
        .parameters_homography_xu_V              (homography_xu),
        .parameters_homography_xv_V              (homography_xv),
        .parameters_homography_x1_V              (homography_x1),
        .parameters_homography_yu_V              (homography_yu),
        .parameters_homography_yv_V              (homography_yv),
        .parameters_homography_y1_V              (homography_y1),
        // Z = 0: no pixel of the reference is valid. A choice of 0, as it becomes the reset of the core's registers.
        .parameters_homography_zu_V              (reference_lost_reg ? 32'd0 : homography_zu),
        .parameters_homography_zv_V              (reference_lost_reg ? 32'd0 : homography_zv),
        .parameters_homography_z1_V              (reference_lost_reg ? 32'd0 : homography_z1),
        .parameters_birdseye_xu_V                (birdseye_xu),
        .parameters_birdseye_xv_V                (birdseye_xv),
        .parameters_birdseye_x1_V                (birdseye_x1),
        .parameters_birdseye_yu_V                (birdseye_yu),
        .parameters_birdseye_yv_V                (birdseye_yv),
        .parameters_birdseye_y1_V                (birdseye_y1),
        .parameters_birdseye_zu_V                (birdseye_zu),
        .parameters_birdseye_zv_V                (birdseye_zv),
        .parameters_birdseye_z1_V                (birdseye_z1),
        .parameters_threshold_floor_V            (threshold_floor),
        .parameters_threshold_override_high_V    (threshold_override_high),
        .parameters_threshold_low_V              (threshold_low),
        .parameters_displacement_noise_V         (displacement_noise),
        .parameters_displacement_bound_V         (displacement_bound),
        .parameters_displacement_bound_step_V    (displacement_bound_step),
        .parameters_rule_run_rule_V              (rule_run_rule),
        .parameters_rule_min_rows_V              (rule_min_rows),
        .parameters_rule_max_gap_V               (rule_max_gap),
        .parameters_rule_horizon_row_V           (rule_horizon_row),
        .parameters_rule_height_ratio_V          (rule_height_ratio),
        .parameters_rule_min_lines_V             (rule_min_lines)
    );

    always @(posedge aclk) begin
        if (null_pixels_tvalid)
            null_pixels_reg <= null_pixels_tdata;
        if (threshold_used_tvalid)
            threshold_used_reg <= threshold_used_tdata;
        if (rst) begin
            null_pixels_reg    <= 24'd0;
            threshold_used_reg <= 8'd0;
        end
    end

    line_table #(
        .LOG2_LINES(LOG2_LINES)
    ) lines (
        .clk          (aclk),
        .read_bank    (line_bank),
        .write        (line_write),
        .write_address(line_write_address),
        .write_data   (line_write_data),
        .read_enable  (lines_enable),
        .read_line    (lines_address),
        .read_data    (lines_data)
    );

    // Results.
    result_stream #(
        .WIDTH  (96),
        .END_BIT(94)
    ) points_stream (
        .clk            (aclk),
        .rst            (rst),
        .s_tdata        (points_tdata),
        .s_tvalid       (points_tvalid),
        .s_tready       (points_tready),
        .m_axis_tdata   (m_axis_points_tdata),
        .m_axis_tuser   (m_axis_points_tuser),
        .m_axis_tlast   (m_axis_points_tlast),
        .m_axis_tvalid  (m_axis_points_tvalid),
        .m_axis_tready  (m_axis_points_tready),
        .frame_done     (frame_done),
        .frame_malformed(frame_malformed),
        .room           (points_room),
        .empty          (points_empty)
    );

    result_stream #(
        .WIDTH  (104),
        .END_BIT(102)
    ) obstacles_stream (
        .clk            (aclk),
        .rst            (rst),
        .s_tdata        (obstacles_tdata),
        .s_tvalid       (obstacles_tvalid),
        .s_tready       (obstacles_tready),
        .m_axis_tdata   (m_axis_obstacles_tdata),
        .m_axis_tuser   (m_axis_obstacles_tuser),
        .m_axis_tlast   (m_axis_obstacles_tlast),
        .m_axis_tvalid  (m_axis_obstacles_tvalid),
        .m_axis_tready  (m_axis_obstacles_tready),
        .frame_done     (frame_done),
        .frame_malformed(frame_malformed),
        .room           (obstacles_room),
        .empty          (obstacles_empty)
    );

    result_stream #(
        .WIDTH  (24),
        .END_BIT(20)
    ) counts_stream (
        .clk            (aclk),
        .rst            (rst),
        .s_tdata        (counts_tdata),
        .s_tvalid       (counts_tvalid),
        .s_tready       (counts_tready),
        .m_axis_tdata   (m_axis_counts_tdata),
        .m_axis_tuser   (m_axis_counts_tuser),
        .m_axis_tlast   (m_axis_counts_tlast),
        .m_axis_tvalid  (m_axis_counts_tvalid),
        .m_axis_tready  (m_axis_counts_tready),
        .frame_done     (frame_done),
        .frame_malformed(frame_malformed),
        .room           (counts_room),
        .empty          (counts_empty)
    );

    // Counters and interrupt.
    wire results_done = m_axis_obstacles_tvalid && m_axis_obstacles_tready && m_axis_obstacles_tlast;

    assign events = {frame_dropped, disabled_in_frame, long_line, short_line, late_sof, early_sof, results_done};

    // The counters see everything one cycle later, so that no path runs through them from the input to the results.
    wire point = m_axis_points_tvalid && m_axis_points_tready;
    reg  counted_start_reg, counted_done_reg, counted_malformed_reg, counted_dropped_reg, counted_pixel_reg, counted_line_reg;
    reg  input_stalled_reg, output_stalled_reg, point_reg, point_end_reg;
    reg  [11:0] point_row_reg;

    always @(posedge aclk) begin
        counted_start_reg     <= frame_start && !rst;
        counted_done_reg      <= frame_done && !rst;
        counted_malformed_reg <= frame_malformed;
        counted_dropped_reg   <= frame_dropped && !rst;
        counted_pixel_reg     <= pixel_valid && pixel_ready && !rst;
        counted_line_reg      <= line_done;
        input_stalled_reg     <= s_axis_video_tvalid && !s_axis_video_tready && !rst;
        output_stalled_reg    <= ((m_axis_points_tvalid && !m_axis_points_tready) ||
                                  (m_axis_obstacles_tvalid && !m_axis_obstacles_tready) ||
                                  (m_axis_counts_tvalid && !m_axis_counts_tready)) && !rst;
        point_reg             <= point && !rst;
        point_end_reg         <= m_axis_points_tlast;
        point_row_reg         <= m_axis_points_tdata[32:21];
    end

    frame_counters counters (
        .clk                 (aclk),
        .rst                 (rst),
        .frame_start         (counted_start_reg),
        .frame_done          (counted_done_reg),
        .frame_malformed     (counted_malformed_reg),
        .frame_dropped       (counted_dropped_reg),
        .pixel               (counted_pixel_reg),
        .line_done           (counted_line_reg),
        .input_stalled       (input_stalled_reg),
        .output_stalled      (output_stalled_reg),
        .point               (point_reg),
        .point_end           (point_end_reg),
        .point_row           (point_row_reg),
        .rows_to_decide      (rule_run_rule ? rule_max_gap + 1'b1 : 12'd1),
        .height              (height),
        .frames              (frames),
        .malformed_frames    (malformed_frames),
        .dropped_frames      (dropped_frames),
        .frame_cycles        (frame_cycles),
        .input_stalls        (input_stalls),
        .output_stalls       (output_stalls),
        .first_result_latency(first_result_latency),
        .decision_latency    (decision_latency)
    );

endmodule

`default_nettype wire
