"""Registers behind block RAMs and multipliers of an ECP5 netlist moved into these blocks.

DP16KD and MULT18X18D have registers at their outputs, which Yosys leaves unused. Without, an output is there 5.8 ns (3.9 ns behind the inputs)
after the clock edge, and the way to the register comes on top. A block's register is taken when every output bit that is used feeds exactly
one flip-flop and nothing else, all of these with the same clock and enable and without reset: then nothing but the timing changes.
"""

import collections

# Of a block: its outputs, its clock, and what switches their register on.
Port = collections.namedtuple("Port", "prefix width clock parameters")
RAM_PORTS = [Port(f"DO{side}", 18, f"CLK{side}", {f"REGMODE_{side}": "OUTREG"}) for side in "AB"]
PRODUCT = Port("P", 36, None, {"REG_OUTPUT_CLK": "CLK0", "REG_OUTPUT_CE": "CE0", "REG_OUTPUT_RST": "RST0"})
INVERTER = "0101010101010101"  # LUT4 of its input A


def constant(bit):
    return isinstance(bit, str)


class Netlist:
    """A module of a Yosys JSON netlist with who reads each bit."""

    def __init__(self, module):
        self.cells = module["cells"]
        self.readers = collections.defaultdict(list)  # bit: [(cell, port)]
        self.last_bit = 0
        for name, cell in self.cells.items():
            for port, bits in cell["connections"].items():
                self.see(bits)
                if cell["port_directions"][port] == "input":
                    for bit in bits:
                        self.readers[bit].append((name, port))
        for port in module["ports"].values():
            self.see(port["bits"])
            for bit in port["bits"]:
                self.readers[bit].append((None, None))
        self.inverted = {}  # bit: its complement

    def see(self, bits):
        self.last_bit = max([self.last_bit] + [bit for bit in bits if not constant(bit)])

    def complement(self, bit):
        """The complement of a bit, from an inverter that all who ask share."""
        if bit not in self.inverted:
            self.last_bit += 1
            self.inverted[bit] = self.last_bit
            self.cells[f"complement_{bit}"] = {
                "hide_name": 1, "type": "LUT4", "parameters": {"INIT": INVERTER}, "attributes": {},
                "port_directions": {"A": "input", "B": "input", "C": "input", "D": "input", "Z": "output"},
                "connections": {"A": [bit], "B": ["0"], "C": ["0"], "D": ["0"], "Z": [self.last_bit]}}
        return self.inverted[bit]

    def registers_behind(self, cell, port):
        """{output of the port: the flip-flop behind it}, or None where the block's register cannot take their place."""
        found = {}
        for name in (f"{port.prefix}{i}" for i in range(port.width)):
            for bit in cell["connections"].get(name, []):
                readers = self.readers[bit]
                if not readers:
                    continue
                reader, pin = readers[0]
                if len(readers) > 1 or pin != "DI" or self.cells[reader]["type"] != "TRELLIS_FF":
                    return None
                found[name] = reader
        controls = {self.control(self.cells[name]) for name in found.values()}
        return found if len(controls) == 1 and None not in controls else None

    @staticmethod
    def control(flip_flop):
        """(clock, enable, inverted enable) of a flip-flop without reset that starts as 0, else None."""
        parameters, connections = flip_flop["parameters"], flip_flop["connections"]
        if connections.get("LSR", ["0"]) not in (["0"], ["x"]) or parameters["REGSET"] != "RESET" or parameters["CLKMUX"] != "CLK":
            return None
        mux = parameters["CEMUX"].strip()
        return connections["CLK"][0], "1" if mux == "1" else connections["CE"][0], mux == "INV"


def take(netlist, cell, port, enable_pin):
    """Moves the flip-flops behind a port into its block; returns how many."""
    registers = netlist.registers_behind(cell, port)
    if not registers:
        return 0
    clock, enable, inverted = Netlist.control(netlist.cells[next(iter(registers.values()))])
    if port.clock and cell["connections"][port.clock] != [clock]:
        return 0
    pins = {enable_pin: netlist.complement(enable) if inverted else enable}
    if port.clock is None:
        pins |= {"CLK0": clock, "RST0": "0"}
    for pin, bit in pins.items():
        cell["connections"][pin] = [bit]
        cell["port_directions"][pin] = "input"
    cell["parameters"] |= port.parameters
    for output, name in registers.items():
        cell["connections"][output] = netlist.cells.pop(name)["connections"]["Q"]
    return len(registers)


def pack(module):
    """Packs a module of a Yosys JSON netlist in place; returns how many flip-flops the blocks took."""
    netlist = Netlist(module)
    taken = 0
    for cell in list(netlist.cells.values()):
        if cell["type"] == "DP16KD":
            taken += sum(take(netlist, cell, port, f"OCE{port.prefix[-1]}") for port in RAM_PORTS)
        elif cell["type"] == "MULT18X18D":
            taken += take(netlist, cell, PRODUCT, "CE0")
    return taken
