#!/usr/bin/env python3
"""Writes everything that follows from the register map rtl/registers.yaml.

./scripts/registers.py          writes the files
./scripts/registers.py --check  fails when one of them is not what the map gives

Files: rtl/axil_registers.v (the register file), rtl/floorline_registers.h (C and C++), docs/registers.md; and the steps in
rtl/board/register_setup.v, which is written by hand but for them.
"""

import argparse
import pathlib
import re
import sys

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = "rtl/registers.yaml"
PARAMETERS_OFFSET = 0x100  # registers lie below, one page for each region
GENERATED = f"Generated from {SOURCE} by scripts/registers.py; change the map, not this file."


def fail(message):
    sys.exit(f"error: {message}")


def load_map():
    """Reads the map, gives each register its offset and bit positions, and checks that everything fits."""
    register_map = yaml.safe_load((ROOT / SOURCE).read_text())
    for index, register in enumerate(register_map["registers"]):
        register["offset"] = 4 * index
        lsb = 0
        for field in register.get("fields", []):
            field["lsb"] = lsb
            lsb += field["bits"]
        register.setdefault("bits", lsb)
    for index, parameter in enumerate(register_map["parameters"]):
        parameter["offset"] = PARAMETERS_OFFSET + 4 * index
        parameter["access"] = "rw"
    everything = register_map["registers"] + register_map["parameters"]
    for register in everything:
        if not 1 <= register["bits"] <= 32:
            fail(f"{SOURCE}: {register['name']} has {register['bits']} bits; a register holds 1 to 32, so split it.")
    if len(register_map["registers"]) > 64 or len(register_map["parameters"]) > 64:
        fail(f"{SOURCE}: a region holds 64 registers; widen PARAMETERS_OFFSET in scripts/registers.py.")
    names = [register["name"] for register in everything]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        fail(f"{SOURCE}: {', '.join(sorted(twice))} is named twice; give each register its own name.")
    table = register_map["line_table"]
    if sum(field["bits"] for field in table["fields"]) > 32 * table["words"]:
        fail(f"{SOURCE}: the fields of line_table need more than {table['words']} words; raise `words`.")
    return register_map


# ---- Verilog ----


def vector(bits):
    return f"[{bits - 1}:0]" if bits > 1 else ""


def port(direction, bits, name):
    return f"    {direction:6} wire {vector(bits):7} {name}"


def register_ports(registers):
    """Ports towards the core, by access; constants (ro with a reset value) have none."""
    ports = []
    for register in registers:
        name = register["name"].lower()
        if register["access"] == "ro" and "reset" not in register:
            ports.append(port("input", register["bits"], name))
        elif register["access"] == "rw" and name == "control":
            ports += [port("output", field["bits"], field["name"].lower()) for field in register["fields"]]
        elif register["access"] == "w1s":
            ports.append(port("output", register["bits"], name))
            ports.append(port("input", register["bits"], f"{name}_done"))
        elif register["access"] == "w1c":
            ports.append(port("input", register["bits"], "events"))
    return ports


def register_value(register):
    """Verilog expression of what a read gives, 32 bits."""
    name = register["name"].lower()
    if "reset" in register:
        return f"32'h{register['reset']:08x}"
    value = name if register["access"] == "ro" else f"{name}_reg"
    padding = 32 - register["bits"]
    return value if padding == 0 else f"{{{padding}'d0, {value}}}"


def verilog(register_map):
    registers, parameters = register_map["registers"], register_map["parameters"]
    stored = [r for r in registers if r["access"] in ("rw", "w1s", "w1c")]
    address_bits = register_map["address_bits"]
    last = len(parameters) - 1
    lines = [f"""// Register file of floorline_top: AXI4-Lite slave, control, status, interrupt, and the shadowed frame parameters.
// {GENERATED}
//
// Parameters are written into a small RAM at any time. A pulse on `load` copies all of them into the registers that the core
// sees, one a cycle, and load_done tells the end; reads of the host wait meanwhile. docs/registers.md has the map.

`default_nettype none

module axil_registers (
    input  wire         clk,
    input  wire         rst,

    input  wire [{address_bits - 1}:0]  s_axil_awaddr,
    input  wire         s_axil_awvalid,
    output wire         s_axil_awready,
    input  wire [31:0]  s_axil_wdata,
    input  wire [3:0]   s_axil_wstrb,
    input  wire         s_axil_wvalid,
    output wire         s_axil_wready,
    output wire [1:0]   s_axil_bresp,
    output wire         s_axil_bvalid,
    input  wire         s_axil_bready,
    input  wire [{address_bits - 1}:0]  s_axil_araddr,
    input  wire         s_axil_arvalid,
    output wire         s_axil_arready,
    output wire [31:0]  s_axil_rdata,
    output wire [1:0]   s_axil_rresp,
    output wire         s_axil_rvalid,
    input  wire         s_axil_rready,

    output reg          irq,

    output wire         line_write,          // a word for the line table
    output wire [9:0]   line_write_address,  // line << 2 | word
    output wire [31:0]  line_write_data,

    input  wire         load,                // take the frame parameters
    output reg          load_done,
"""]
    core_ports = register_ports(registers)
    core_ports += [port("output", p["bits"], p["name"].lower()) for p in parameters]
    lines.append(",\n".join(core_ports) + "\n);\n")
    lines.append(f"""
    wire         write_strobe;
    wire [{address_bits - 3}:0]  write_address;
    wire [31:0]  write_data;
    wire [{address_bits - 3}:0]  read_address;

    // Word addresses: 10 the line table, else 9:6 = 0 registers, 9:6 = 1 frame parameters.
    wire         in_lines      = write_address[10];
    wire         in_registers  = (write_address[10:6] == 5'd0);
    wire         in_parameters = (write_address[10:6] == 5'd1);
    wire [5:0]   write_index   = write_address[5:0];
    wire         write_mapped  = in_lines || (in_parameters && write_index <= 6'd{last}) ||
                                 (in_registers && ({' || '.join(f"write_index == 6'd{r['offset'] // 4}" for r in stored)}));

    reg          loading_reg;
    reg          reading_store_reg;  // a cycle after loading_reg: a read of the host that had begun is over
    reg [5:0]    load_index_reg;
    reg [31:0]   register_word;      // what the host reads
    wire [31:0]  store_word;
    wire         read_mapped = read_address[10:7] == 4'd0 &&
                               read_address[5:0] <= (read_address[6] ? 6'd{last} : 6'd{len(registers) - 1});

    axil_slave #(
        .ADDRESS_WIDTH({address_bits})
    ) slave (
        .clk           (clk),
        .rst           (rst),
        .s_axil_awaddr (s_axil_awaddr),
        .s_axil_awvalid(s_axil_awvalid),
        .s_axil_awready(s_axil_awready),
        .s_axil_wdata  (s_axil_wdata),
        .s_axil_wstrb  (s_axil_wstrb),
        .s_axil_wvalid (s_axil_wvalid),
        .s_axil_wready (s_axil_wready),
        .s_axil_bresp  (s_axil_bresp),
        .s_axil_bvalid (s_axil_bvalid),
        .s_axil_bready (s_axil_bready),
        .s_axil_araddr (s_axil_araddr),
        .s_axil_arvalid(s_axil_arvalid),
        .s_axil_arready(s_axil_arready),
        .s_axil_rdata  (s_axil_rdata),
        .s_axil_rresp  (s_axil_rresp),
        .s_axil_rvalid (s_axil_rvalid),
        .s_axil_rready (s_axil_rready),
        .write_strobe  (write_strobe),
        .write_address (write_address),
        .write_data    (write_data),
        .write_error   (!write_mapped),
        .read_hold     (loading_reg),
        .read_address  (read_address),
        .read_data     (read_address[6] ? store_word : register_word),
        .read_error    (!read_mapped)
    );

    assign line_write         = write_strobe && in_lines;
    assign line_write_address = write_address[9:0];
    assign line_write_data    = write_data;

    // Registers.
""")
    for register in stored:
        lines.append(f"    reg {vector(register['bits']):7} {register['name'].lower()}_reg;\n")
    lines.append("\n")
    for register in stored:
        name = register["name"].lower()
        if name == "control":
            lines += [f"    assign {f['name'].lower()} = {name}_reg{'' if register['bits'] == 1 else '[' + str(f['lsb']) + ']'};\n" for f in register["fields"]]
        elif register["access"] == "w1s":
            lines.append(f"    assign {name} = {name}_reg;\n")
    lines.append("\n    always @(posedge clk) begin\n")
    for register in stored:
        name, bits, index = register["name"].lower(), register["bits"], register["offset"] // 4
        written = f"write_data[{bits - 1}:0]" if bits > 1 else "write_data[0]"
        chosen = f"write_strobe && in_registers && write_index == 6'd{index}"
        if register["access"] == "rw":
            lines.append(f"        if ({chosen})\n            {name}_reg <= {written};\n")
        else:
            gate = f"({{{bits}{{{chosen}}}}} & {written})"
            kept = f"({name}_reg & ~{name}_done) | {gate}" if register["access"] == "w1s" else f"({name}_reg & ~{gate}) | events"
            lines.append(f"        {name}_reg <= {kept};\n")
    lines.append("        irq <= |(interrupt_enable_reg & interrupt_status_reg);\n\n        if (rst) begin\n")
    lines += [f"            {r['name'].lower()}_reg <= {r['bits']}'d0;\n" for r in stored]
    lines.append("""            irq <= 1'b0;
        end
    end

    always @* begin
""")
    lines.append("        case (read_address[5:0])\n")
    lines += [f"            6'd{r['offset'] // 4}: register_word = {register_value(r)};\n" for r in registers]
    lines.append(f"""            default: register_word = 32'd0;
        endcase
    end

    // Frame parameters: what the host wrote. In LUTs, from where a word is there sooner than from a block RAM.
    (* ram_style = "distributed" *)
    reg [31:0] store [0:63];

    always @(posedge clk)
        if (write_strobe && in_parameters)
            store[write_index] <= write_data;
    assign store_word = store[reading_store_reg ? load_index_reg : read_address[5:0]];

    // Loading: the word of load_index_reg is in loaded_word_reg one cycle later, when the parameter's bit of loaded_reg is 1.
    reg [{last}:0] loaded_reg;
    reg [31:0] loaded_word_reg;

    always @(posedge clk) begin
        reading_store_reg <= loading_reg && !(reading_store_reg && load_index_reg == 6'd{last});
        load_index_reg    <= reading_store_reg ? load_index_reg + 1'b1 : 6'd0;
        loaded_reg        <= {{loaded_reg[{last - 1}:0], reading_store_reg && load_index_reg == 6'd0}};
        loaded_word_reg   <= store_word;
        load_done         <= loaded_reg[{last}];
        if (load)
            loading_reg <= 1'b1;
        else if (reading_store_reg && load_index_reg == 6'd{last})
            loading_reg <= 1'b0;

        if (rst) begin
            loading_reg       <= 1'b0;
            reading_store_reg <= 1'b0;
            loaded_reg        <= {last + 1}'d0;
            load_done         <= 1'b0;
        end
    end

    // Frame parameters: what the core sees.
""")
    width = max(len(vector(p["bits"])) for p in parameters)
    lines += [f"    reg {vector(p['bits']):{width}} {p['name'].lower()}_reg;\n" for p in parameters]
    lines.append("\n")
    lines += [f"    assign {p['name'].lower()} = {p['name'].lower()}_reg;\n" for p in parameters]
    lines.append("\n    always @(posedge clk) begin\n")
    for index, p in enumerate(parameters):
        bits = f"[{p['bits'] - 1}:0]" if 1 < p["bits"] < 32 else "[0]" if p["bits"] == 1 else ""
        lines.append(f"        if (loaded_reg[{index}])\n            {p['name'].lower()}_reg <= loaded_word_reg{bits};\n")
    lines.append("""    end

endmodule

`default_nettype wire
""")
    return "".join(lines)


# ---- C ----


def c_header(register_map):
    out = [f"""/* Registers of the Floorline core: byte offsets, bit positions and masks.
 * {GENERATED} docs/registers.md says what each means. */
#ifndef FLOORLINE_REGISTERS_H
#define FLOORLINE_REGISTERS_H
"""]
    for register in register_map["registers"]:
        out.append(f"\n#define FLOORLINE_{register['name']} 0x{register['offset']:03x}u\n")
        if "reset" in register:
            out.append(f"#define FLOORLINE_{register['name']}_VALUE 0x{register['reset']:08x}u\n")
        for field in register.get("fields", []):
            prefix = f"FLOORLINE_{register['name']}_{field['name']}"
            out.append(f"#define {prefix}_SHIFT {field['lsb']}\n")
            out.append(f"#define {prefix}_MASK 0x{((1 << field['bits']) - 1) << field['lsb']:08x}u\n")
    out.append("\n/* Frame parameters: shadowed, taken with FLOORLINE_UPDATE_PARAMETERS_MASK. */\n")
    out += [f"#define FLOORLINE_{p['name']} 0x{p['offset']:03x}u\n" for p in register_map["parameters"]]
    out.append(f"#define FLOORLINE_PARAMETER_COUNT {len(register_map['parameters'])}u\n")
    table = register_map["line_table"]
    out.append("\n/* Line table: word w of line n at FLOORLINE_LINES + n * FLOORLINE_LINE_BYTES + 4 * w, write only. */\n")
    out.append(f"#define FLOORLINE_LINES 0x{table['offset']:04x}u\n")
    out.append(f"#define FLOORLINE_LINE_BYTES {4 * table['words']}u\n")
    lsb = 0
    for field in table["fields"]:
        out.append(f"#define FLOORLINE_LINE_{field['name'].upper()}_SHIFT {lsb}\n")
        out.append(f"#define FLOORLINE_LINE_{field['name'].upper()}_BITS {field['bits']}\n")
        lsb += field["bits"]
    out.append("\n#endif\n")
    return "".join(out)


# ---- Documentation ----


def bit_range(lsb, bits):
    return str(lsb) if bits == 1 else f"{lsb + bits - 1}:{lsb}"


def parameter_note(parameter):
    kind = parameter.get("format") or ("signed" if parameter.get("signed") else "")
    return ", ".join(text for text in (kind, parameter.get("unit", "")) if text)


def document(register_map):
    table = register_map["line_table"]
    out = [f"""# Registers

{GENERATED}

32-bit registers on AXI4-Lite, {register_map['address_bits']} address bits. Write whole words (another WSTRB, or an address that is not listed, is answered with SLVERR).
`rtl/floorline_registers.h` has the offsets and masks for C and C++.

To change parameters: wait until UPDATE reads 0, write those that change, write UPDATE. They are taken together at the next start of frame.

## Control and status
| offset | register | access | bits | field | meaning |
| --- | --- | --- | --- | --- | --- |
"""]
    for register in register_map["registers"]:
        reset = f" (0x{register['reset']:08x})" if "reset" in register else ""
        out.append(f"| 0x{register['offset']:03x} | {register['name']} | {register['access']} | {bit_range(0, register['bits'])} | | {register['description']}{reset} |\n")
        for field in register.get("fields", []):
            out.append(f"| | | | {bit_range(field['lsb'], field['bits'])} | {field['name']} | {field['description']} |\n")
    out.append("""
ro: read only; rw: read and write; w1s: a written 1 sets, hardware clears; w1c: hardware sets, a written 1 clears. All are 0 after reset.

## Frame parameters
The fields of `hls/parameters.h`, read and written at any time, used from the start of frame on at which UPDATE.PARAMETERS was 1. Undefined after reset:
write all of them before the first frame.

| offset | register | bits | format, unit | meaning |
| --- | --- | --- | --- | --- |
""")
    for p in register_map["parameters"]:
        out.append(f"| 0x{p['offset']:03x} | {p['name']} | {bit_range(0, p['bits'])} | {parameter_note(p)} | {p.get('description', '')} |\n")
    out.append(f"""
## Line table
Word w of line n at 0x{table['offset']:04x} + {4 * table['words']} n + 4 w, write only, two banks: the one that is written is taken whole at the start of frame at which
UPDATE.LINES is 1. After that the other bank is written, so write every line in use each time. {table['description']}:

| bits | field | |
| --- | --- | --- |
""")
    lsb = 0
    for field in table["fields"]:
        out.append(f"| {bit_range(lsb, field['bits'])} | {field['name']} | {'signed' if field.get('signed') else ''} |\n")
        lsb += field["bits"]
    return "".join(out)


# ---- The board demonstration ----

BOARD_SETUP = "rtl/board/register_setup.v"


def board_setup(register_map):
    """The setup of the board demonstration: its steps are the parameters in the order of the map, then UPDATE and CONTROL."""
    parameters = [parameter["name"] for parameter in register_map["parameters"]]
    steps = parameters + ["UPDATE", "CONTROL"]

    def renumbered(match):
        value, name = match.groups()
        if name not in steps:
            fail(f"{BOARD_SETUP} writes {name}, which {SOURCE} does not have; take the line out or name it as the map does.")
        return f"10'd{steps.index(name)}: ".ljust(8) + value

    text = re.sub(r"10'd\d+: +(value = .*?// (\w+))", renumbered, (ROOT / BOARD_SETUP).read_text())
    return re.sub(r"(PARAMETERS +=) \d+;", rf"\1 {len(parameters)};", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare the files with what the map gives")
    check = parser.parse_args().check
    register_map = load_map()
    files = {
        "rtl/axil_registers.v": verilog(register_map),
        "rtl/floorline_registers.h": c_header(register_map),
        "docs/registers.md": document(register_map),
        BOARD_SETUP: board_setup(register_map),
    }
    for name, text in files.items():
        path = ROOT / name
        if not check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            fail(f"{name} is not what {SOURCE} gives; run ./scripts/registers.py and commit it.")


if __name__ == "__main__":
    main()
