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

    // Verdicts wait with the newest in bit 0; waiting_reg has as many ones from bit 0 on as there are.
    localparam FRAMES = 4;  // whose results may be outstanding

    reg [FRAMES-1:0] malformed_reg;
    reg [FRAMES-1:0] waiting_reg;

    wire malformed = waiting_reg[3] ? malformed_reg[3] : waiting_reg[2] ? malformed_reg[2] : waiting_reg[1] ? malformed_reg[1] : malformed_reg[0];
    wire malformed_known = waiting_reg[0];
    wire last    = s_tdata[END_BIT];
    wire allowed = !last || malformed_known;

    assign s_tready      = m_axis_tready && allowed;
    assign m_axis_tdata  = s_tdata;
    assign m_axis_tuser  = last && malformed;
    assign m_axis_tlast  = last;
    assign m_axis_tvalid = s_tvalid && allowed;
    assign empty         = !waiting_reg[0];
    assign room          = !waiting_reg[FRAMES-1];

    wire ends = m_axis_tvalid && m_axis_tready && last;

    always @(posedge clk) begin
        if (frame_done)
            malformed_reg <= {malformed_reg[FRAMES-2:0], frame_malformed};
        if (frame_done && !ends)
            waiting_reg <= {waiting_reg[FRAMES-2:0], 1'b1};
        else if (ends && !frame_done)
            waiting_reg <= waiting_reg >> 1;
        if (rst)
            waiting_reg <= {FRAMES{1'b0}};
    end

endmodule

`default_nettype wire
