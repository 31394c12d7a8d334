// Results of the core as an AXI4-Stream packet a frame: TLAST on the element that ends the frame (`end`, its other fields are 0),
// TUSER on that element says that the frame was malformed and the packet is to be thrown away.
//
// The frame guard tells at the end of each input frame whether it was malformed; that may be several frames before its results
// leave, so the answers wait in a queue. `room`: one more frame may start; `empty`: no frame's results are outstanding.
// The core's outputs are registered, so nothing is buffered here.

`default_nettype none

module result_stream #(
    parameter WIDTH   = 32,  // bits of TDATA
    parameter END_BIT = 0    // position of the element's `end`
) (
    input  wire             clk,
    input  wire             rst,

    input  wire [WIDTH-1:0] s_tdata,
    input  wire             s_tvalid,
    output wire             s_tready,

    output wire [WIDTH-1:0] m_axis_tdata,
    output wire             m_axis_tuser,
    output wire             m_axis_tlast,
    output wire             m_axis_tvalid,
    input  wire             m_axis_tready,

    input  wire             frame_done,       // pulse: an input frame is complete
    input  wire             frame_malformed,  // with frame_done
    output wire             room,
    output wire             empty
);

    wire malformed, malformed_known;
    wire last    = s_tdata[END_BIT];
    wire allowed = !last || malformed_known;

    assign s_tready      = m_axis_tready && allowed;
    assign m_axis_tdata  = s_tdata;
    assign m_axis_tuser  = last && malformed;
    assign m_axis_tlast  = last;
    assign m_axis_tvalid = s_tvalid && allowed;
    assign empty         = !malformed_known;

    fifo #(
        .WIDTH(1),
        .DEPTH(4)
    ) verdicts (
        .clk    (clk),
        .rst    (rst),
        .s_data (frame_malformed),
        .s_valid(frame_done),
        .s_ready(room),
        .m_data (malformed),
        .m_valid(malformed_known),
        .m_ready(m_axis_tvalid && m_axis_tready && last)
    );

endmodule

`default_nettype wire
