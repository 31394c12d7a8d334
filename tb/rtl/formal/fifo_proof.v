// Proof bench of rtl/lib/fifo.v; DEPTH is set by the proof.

`default_nettype none

module fifo_proof #(
    parameter DEPTH = 3
) (
    input wire       clk,
    input wire       rst,
    input wire [1:0] s_data,
    input wire       s_valid,
    input wire       m_ready,
    input wire       mark
);

    wire [1:0] m_data;
    wire       s_ready, m_valid;

    fifo #(.WIDTH(2), .DEPTH(DEPTH)) buffer (
        .clk(clk), .rst(rst), .s_data(s_data), .s_valid(s_valid), .s_ready(s_ready), .m_data(m_data), .m_valid(m_valid), .m_ready(m_ready)
    );

    stream_buffer_properties #(.WIDTH(2), .DEPTH(DEPTH), .LATENCY(DEPTH <= 2 ? 1 : 2)) properties (
        .clk(clk), .rst(rst), .s_data(s_data), .s_valid(s_valid), .s_ready(s_ready), .m_data(m_data), .m_valid(m_valid), .m_ready(m_ready),
        .mark(mark)
    );

endmodule

`default_nettype wire
