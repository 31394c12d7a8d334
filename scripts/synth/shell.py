"""A shell of three pins around a design, so that it is placed and routed with its clock on the clock network, as in a system, though it
has more ports than the package has pins: a shift register feeds the inputs; the outputs are registered and folded into one bit."""

CLOCKS = ("clk", "aclk")
FOLD = 16  # outputs that one register of the fold takes


def verilog(top, ports):
    """Verilog of module `shell`. ports: {name: {"direction": "input"|"output", "bits": [...]}}, as Yosys writes them."""
    widths = {name: len(port["bits"]) for name, port in ports.items()}
    inputs = [name for name, port in ports.items() if port["direction"] == "input" and name not in CLOCKS]
    outputs = [name for name, port in ports.items() if port["direction"] == "output"]
    clock = next(name for name in ports if name in CLOCKS)
    wires_in = sum(widths[name] for name in inputs)
    wires_out = sum(widths[name] for name in outputs)
    folds = -(-wires_out // FOLD)

    connections = [f".{clock}(clk)"]
    for vector, names in (("feed", inputs), ("result", outputs)):
        at = 0
        for name in names:
            connections.append(f".{name}({vector}[{at + widths[name] - 1}:{at}])")
            at += widths[name]
    fold = [f"fold[{i}] <= ^captured[{min(wires_out, (i + 1) * FOLD) - 1}:{i * FOLD}];" for i in range(folds)]
    return f"""module shell (input wire clk, input wire serial_in, output reg serial_out);
    reg [{wires_in - 1}:0] feed;
    wire [{wires_out - 1}:0] result;
    reg [{wires_out - 1}:0] captured;
    reg [{folds - 1}:0] fold;
    {top} design ({', '.join(connections)});
    always @(posedge clk) begin
        feed <= {{feed, serial_in}};
        captured <= result;
        {' '.join(fold)}
        serial_out <= ^fold;
    end
endmodule
"""
