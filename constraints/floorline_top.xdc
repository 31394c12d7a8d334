# floorline_top out of context on 7-series: one clock; everything else is timed by the design that holds it.
create_clock -name aclk -period 6.250 [get_ports aclk]
set_input_delay -clock aclk 1.0 [get_ports {aresetn s_axil_* s_axis_video_t* m_axis_points_tready m_axis_obstacles_tready m_axis_counts_tready} -filter {DIRECTION == IN}]
set_output_delay -clock aclk 1.0 [get_ports {irq s_axil_* s_axis_video_tready m_axis_points_t* m_axis_obstacles_t* m_axis_counts_t*} -filter {DIRECTION == OUT}]
