// Stands in for rtl/lib/fifo.v in the co-simulation that looks for depths: its DEPTH grows by what the harness
// gives it (cosim/probes.h). Simulation only.

`default_nettype none

module fifo #(
    parameter WIDTH = 8,
    parameter DEPTH = 17
) (
    input  wire             clk,
    input  wire             rst,

    input  wire [WIDTH-1:0] s_data,
    input  wire             s_valid,
    output wire             s_ready,

    output wire [WIDTH-1:0] m_data,
    output wire             m_valid,
    input  wire             m_ready
);
    import "DPI-C" function int hlsc_extra_places(input string who);

    reg [WIDTH-1:0] words[$];
    reg [WIDTH-1:0] first;
    int             held   = 0;
    int             places = DEPTH;

    assign s_ready = held < places;
    assign m_valid = held > 0;
    assign m_data  = first;

    always @(posedge clk) begin
        if (m_valid && m_ready)
            void'(words.pop_front());
        if (s_valid && s_ready)
            words.push_back(s_data);
        if (rst)
            words.delete();
        held   <= words.size();
        first  <= words.size() > 0 ? words[0] : 'x;
        places <= DEPTH + hlsc_extra_places($sformatf("%m"));
    end

endmodule

`default_nettype wire
