// Start of frame: what must happen between the first pixel of a frame at the guard and the core's start.
//
// Waits until the core has taken the parameters of the frame before and there is room for one more frame of results. Then, if the
// host asked for it, loads the frame parameters, and swaps the banks of the line table once the core is empty. A size that the
// core cannot hold is refused. Without updates a start takes two cycles.

`default_nettype none

module frame_start #(
    parameter SIZE_WIDTH = 12,
    parameter MAX_WIDTH  = 640,  // pixels
    parameter MAX_HEIGHT = 480   // lines
) (
    input  wire                  clk,
    input  wire                  rst,

    // Frame guard.
    input  wire                  start_request,
    output wire                  start_grant,
    output reg                   refuse,             // with start_grant

    // Register file.
    input  wire                  update_parameters,  // asked for by the host
    input  wire                  update_lines,
    output wire                  load,
    input  wire                  load_done,
    output wire                  lines_done,         // pulse: the bank was swapped
    output reg                   line_bank,          // bank that the core reads; the host writes the other one
    input  wire [SIZE_WIDTH-1:0] width,
    input  wire [SIZE_WIDTH-1:0] height,

    // Core.
    input  wire                  core_ready,         // it has taken the parameters of the frame before
    input  wire                  core_empty,         // no frame is in it
    input  wire                  results_room        // one more frame of results can be told apart
);

    localparam [1:0] IDLE  = 2'd0;
    localparam [1:0] LOAD  = 2'd1;
    localparam [1:0] LINES = 2'd2;
    localparam [1:0] GRANT = 2'd3;

    localparam [31:0]           LEAST        = 16;
    localparam [31:0]           WIDTH_BOUND  = MAX_WIDTH;
    localparam [31:0]           HEIGHT_BOUND = MAX_HEIGHT;

    reg [1:0] state_reg;

    wire begins = (state_reg == IDLE) && start_request && core_ready && results_room;

    assign load        = begins && update_parameters;
    assign lines_done  = (state_reg == LINES) && update_lines && core_empty;
    assign start_grant = (state_reg == GRANT);

    always @(posedge clk) begin
        // The size is loaded first of the parameters, many cycles before load_done.
        refuse <= width < LEAST[SIZE_WIDTH-1:0] || height < LEAST[SIZE_WIDTH-1:0] ||
                  width > WIDTH_BOUND[SIZE_WIDTH-1:0] || height > HEIGHT_BOUND[SIZE_WIDTH-1:0];

        case (state_reg)
            IDLE:
                if (begins)
                    state_reg <= update_parameters ? LOAD : update_lines ? LINES : GRANT;
            LOAD:
                if (load_done)
                    state_reg <= update_lines ? LINES : GRANT;
            LINES:
                if (core_empty)
                    state_reg <= GRANT;
            default:  // GRANT
                state_reg <= IDLE;
        endcase

        if (lines_done)
            line_bank <= !line_bank;

        if (rst) begin
            state_reg <= IDLE;
            line_bank <= 1'b0;
        end
    end

endmodule

`default_nettype wire
