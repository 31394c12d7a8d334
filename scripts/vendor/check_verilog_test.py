"""Feeds check_verilog.py with lines that XST does not read, and with a good module."""

import sys

import check_verilog

GOOD = """
module good #(parameter WIDTH = 8) (input wire clk, input wire [WIDTH-1:0] a, output reg [WIDTH-1:0] b);
    localparam [7:0] ZERO = 8'b0;  // not logic, int or initial
    (* ram_style = "block" *) reg [7:0] memory [0:15];
    genvar i;
    generate for (i = 0; i < WIDTH; i = i + 1) begin : bits wire w = a[i]; end endgenerate
    wire signed [7:0] s = $signed(a) >>> 1;
    wire le = a <= 8'd3 && a != 8'hff && a[3 +: 2] == 2'b01;
    always @(posedge clk) b <= s + ZERO;
    initial begin
        memory[0] = 8'd1;
        memory[1] = 8'hff;
    end
    // synthesis translate_off
    initial memory[2] = 0;
    // synthesis translate_on
`ifdef SIMULATION
    initial $display("only in simulation");
`endif
`ifndef SYNTHESIS
    initial memory[3] = 0;
`endif
endmodule
"""

REFUSED = {  # a line: a part of the sentence
    "logic x;": "'logic'",
    "always_ff @(posedge clk) b <= a;": "'always_ff'",
    "for (int i = 0; i < 8; i = i + 1) b[i] = a[i];": "'int'",
    "always @* b = '0;": "without a width",
    "localparam W = $clog2(DEPTH);": "'$clog2'",
    "initial b = 0;": "'initial'",
    "initial for (i = 0; i < 8; i = i + 1) memory[i] = 8'd0;": "'initial'",
    "always @* i++;": "'++'",
    "sub u (.*);": ".*",
    "assign #5 b = a;": "a delay",
    "typedef enum {A, B} state;": "'typedef'",
}


def main():
    if check_verilog.faults(GOOD):
        sys.exit(f"error: a good module is refused: {check_verilog.faults(GOOD)}")
    for line, part in REFUSED.items():
        found = check_verilog.faults(f"module m;\n{line}\nendmodule\n")
        if not any(place == 2 and part in sentence for place, sentence in found):
            sys.exit(f"error: this was to be refused with {part} and gave {found}: {line}")


if __name__ == "__main__":
    main()
