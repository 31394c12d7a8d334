// What must hold for every buffer between two valid/ready streams (fifo, skid_buffer), whatever its inputs do.
//
// Nothing is assumed of the source: it may drop s_valid or change s_data at will. One arbitrary word is marked as it is taken;
// when its turn comes it must be on m_data, unchanged: no loss, no duplication, order kept. The solver chooses the word.

`default_nettype none

module stream_buffer_properties #(
    parameter WIDTH = 2,
    parameter DEPTH = 2,   // words that the buffer holds
    parameter LATENCY = 1  // cycles from a word taken by an empty buffer to m_valid
) (
    input wire             clk,
    input wire             rst,
    input wire [WIDTH-1:0] s_data,
    input wire             s_valid,
    input wire             s_ready,
    input wire [WIDTH-1:0] m_data,
    input wire             m_valid,
    input wire             m_ready,
    input wire             mark        // chosen by the solver
);

    wire push = s_valid && s_ready;
    wire pop  = m_valid && m_ready;

    reg started = 1'b0;                // a reset came first
    reg [3:0] level;                   // words inside
    reg marked;
    reg [WIDTH-1:0] marked_data;
    reg [3:0] ahead;                   // words inside that leave before the marked one
    reg past_stalled;
    reg [WIDTH-1:0] past_data;
    reg [3:0] waiting;                 // cycles in which the buffer held a word and offered none
    reg [3:0] refusing;                // cycles in which the buffer had a free place and refused

    always @(posedge clk) begin
        started <= 1'b1;
        if (rst) begin
            level        <= 0;
            marked       <= 1'b0;
            past_stalled <= 1'b0;
            waiting      <= 0;
            refusing     <= 0;
        end else begin
            level        <= level + push - pop;
            past_stalled <= m_valid && !m_ready;
            past_data    <= m_data;
            waiting      <= (level != 0 && !m_valid) ? waiting + 1'b1 : 0;
            refusing     <= (level < DEPTH && !s_ready) ? refusing + 1'b1 : 0;
            if (push && mark && !marked) begin
                marked      <= 1'b1;
                marked_data <= s_data;
                ahead       <= level - pop;
            end else if (marked && pop) begin
                marked <= (ahead != 0);
                ahead  <= ahead - 1'b1;
            end
        end
    end

    always @* begin
        if (!started)
            assume (rst);
        if (started && !rst) begin
            assert (level <= DEPTH);
            assert (!m_valid || level != 0);
            assert (!past_stalled || m_valid);
            assert (!past_stalled || m_data == past_data);
            assert (!marked || ahead < level);
            assert (!(marked && m_valid && ahead == 0) || m_data == marked_data);
            assert (waiting < LATENCY);
            assert (refusing < LATENCY);
            cover (marked && pop && ahead == 0 && past_stalled && level == DEPTH);
        end
    end

endmodule

`default_nettype wire
