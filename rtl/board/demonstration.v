// The whole system on a board without camera or processor: test pattern -> floorline_top -> serial line.

`default_nettype none

module demonstration #(
    parameter CYCLES_PER_BIT = 217  // of the serial line
) (
    input  wire clk,
    input  wire rst,
    output wire txd,
    output wire frame_light  // changes with each frame
);

    wire [12:0]  awaddr;
    wire         awvalid, awready, wvalid, wready, bvalid, bready;
    wire [31:0]  wdata;
    wire [3:0]   wstrb;
    wire [23:0]  video_tdata;
    wire         video_tuser, video_tlast, video_tvalid, video_tready;
    wire [95:0]  points_tdata;
    wire         points_tlast, points_tvalid;
    wire [1:0]   unused_bresp, unused_rresp;
    wire [31:0]  unused_rdata;
    wire [103:0] unused_obstacles;
    wire [23:0]  unused_counts;
    wire         unused_arready, unused_rvalid, unused_irq, unused_points_tuser;
    wire [2:0]   unused_obstacles_flags, unused_counts_flags;
    wire [7:0]   unused_difference, unused_motion, unused_blurred, unused_region, unused_taps;
    reg          frame_light_reg;

    assign frame_light = frame_light_reg;

    video_pattern pattern (
        .clk          (clk),
        .rst          (rst),
        .m_axis_tdata (video_tdata),
        .m_axis_tuser (video_tuser),
        .m_axis_tlast (video_tlast),
        .m_axis_tvalid(video_tvalid),
        .m_axis_tready(video_tready)
    );

    register_setup setup (
        .clk           (clk),
        .rst           (rst),
        .m_axil_awaddr (awaddr),
        .m_axil_awvalid(awvalid),
        .m_axil_awready(awready),
        .m_axil_wdata  (wdata),
        .m_axil_wstrb  (wstrb),
        .m_axil_wvalid (wvalid),
        .m_axil_wready (wready),
        .m_axil_bvalid (bvalid),
        .m_axil_bready (bready)
    );

    floorline_top top (
        .aclk                   (clk),
        .aresetn                (!rst),
        .s_axil_awaddr          (awaddr),
        .s_axil_awvalid         (awvalid),
        .s_axil_awready         (awready),
        .s_axil_wdata           (wdata),
        .s_axil_wstrb           (wstrb),
        .s_axil_wvalid          (wvalid),
        .s_axil_wready          (wready),
        .s_axil_bresp           (unused_bresp),
        .s_axil_bvalid          (bvalid),
        .s_axil_bready          (bready),
        .s_axil_araddr          (13'd0),
        .s_axil_arvalid         (1'b0),
        .s_axil_arready         (unused_arready),
        .s_axil_rdata           (unused_rdata),
        .s_axil_rresp           (unused_rresp),
        .s_axil_rvalid          (unused_rvalid),
        .s_axil_rready          (1'b1),
        .irq                    (unused_irq),
        .s_axis_video_tdata     (video_tdata),
        .s_axis_video_tuser     (video_tuser),
        .s_axis_video_tlast     (video_tlast),
        .s_axis_video_tvalid    (video_tvalid),
        .s_axis_video_tready    (video_tready),
        .m_axis_points_tdata    (points_tdata),
        .m_axis_points_tuser    (unused_points_tuser),
        .m_axis_points_tlast    (points_tlast),
        .m_axis_points_tvalid   (points_tvalid),
        .m_axis_points_tready   (1'b1),
        .m_axis_obstacles_tdata (unused_obstacles),
        .m_axis_obstacles_tuser (unused_obstacles_flags[0]),
        .m_axis_obstacles_tlast (unused_obstacles_flags[1]),
        .m_axis_obstacles_tvalid(unused_obstacles_flags[2]),
        .m_axis_obstacles_tready(1'b1),
        .m_axis_counts_tdata    (unused_counts),
        .m_axis_counts_tuser    (unused_counts_flags[0]),
        .m_axis_counts_tlast    (unused_counts_flags[1]),
        .m_axis_counts_tvalid   (unused_counts_flags[2]),
        .m_axis_counts_tready   (1'b1),
        .tap_difference_tdata   (unused_difference),
        .tap_difference_tvalid  (unused_taps[0]),
        .tap_difference_tready  (unused_taps[1]),
        .tap_motion_tdata       (unused_motion),
        .tap_motion_tvalid      (unused_taps[2]),
        .tap_motion_tready      (unused_taps[3]),
        .tap_blurred_tdata      (unused_blurred),
        .tap_blurred_tvalid     (unused_taps[4]),
        .tap_blurred_tready     (unused_taps[5]),
        .tap_region_tdata       (unused_region),
        .tap_region_tvalid      (unused_taps[6]),
        .tap_region_tready      (unused_taps[7])
    );

    serial_results #(
        .CYCLES_PER_BIT(CYCLES_PER_BIT)
    ) results (
        .clk      (clk),
        .rst      (rst),
        .point    (points_tvalid),
        .point_end(points_tlast),
        .point_u  (points_tdata[19:8]),
        .point_v  (points_tdata[32:21]),
        .txd      (txd)
    );

    wire unused_point_fields = &{1'b0, points_tdata[95:33], points_tdata[20], points_tdata[7:0]};

    always @(posedge clk)
        if (rst)
            frame_light_reg <= 1'b0;
        else if (points_tvalid && points_tlast)
            frame_light_reg <= !frame_light_reg;

endmodule

`default_nettype wire
