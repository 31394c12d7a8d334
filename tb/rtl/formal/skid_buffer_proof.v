// Proof bench of rtl/lib/skid_buffer.v.

`default_nettype none

module skid_buffer_proof (
    input wire       clk,
    input wire       rst,
    input wire [1:0] s_data,
    input wire       s_valid,
    input wire       m_ready,
    input wire       mark
);

    wire [1:0] m_data;
    wire       s_ready, m_valid;

    skid_buffer #(.WIDTH(2)) buffer (
        .clk(clk), .rst(rst), .s_data(s_data), .s_valid(s_valid), .s_ready(s_ready), .m_data(m_data), .m_valid(m_valid), .m_ready(m_ready)
    );

    stream_buffer_properties #(.WIDTH(2), .DEPTH(2), .LATENCY(1)) properties (
        .clk(clk), .rst(rst), .s_data(s_data), .s_valid(s_valid), .s_ready(s_ready), .m_data(m_data), .m_valid(m_valid), .m_ready(m_ready),
        .mark(mark)
    );

endmodule

`default_nettype wire
