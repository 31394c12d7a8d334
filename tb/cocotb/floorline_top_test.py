"""floorline_top in Icarus with AXI agents that others wrote (cocotbext-axi): the frames of cosim_vectors, with and without pauses on
every port. Run by scripts/cocotb.sh."""
import itertools
import json
import os
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

CONTROL, UPDATE, NULL_PIXELS, THRESHOLD_USED = 0x00C, 0x010, 0x03C, 0x040
STREAMS = ("points", "obstacles", "counts")


def pauses(seed):
    generator = random.Random(seed)
    return (generator.random() < 0.4 for _ in itertools.count())


def differing_bits(expected, got):
    """An element that one side lacks counts as all ones."""
    return sum((a ^ b).bit_count() for a, b in itertools.zip_longest(expected, got, fillvalue=(1 << 128) - 1))


class Bench:
    def __init__(self, dut):
        self.dut = dut
        cocotb.start_soon(Clock(dut.aclk, 10, "ns").start())
        options = dict(clock=dut.aclk, reset=dut.aresetn, reset_active_level=False)
        self.registers = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), **options)
        self.video = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis_video"), byte_lanes=1, **options)
        self.results = {
            name: AxiStreamSink(AxiStreamBus.from_prefix(dut, f"m_axis_{name}"), byte_lanes=1, **options) for name in STREAMS
        }

    def pause(self):
        for seed, port in enumerate([self.video, *self.results.values()]):
            port.set_pause_generator(pauses(seed))

    async def reset(self):
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, 4)
        self.dut.aresetn.value = 1
        await ClockCycles(self.dut.aclk, 4)

    async def write(self, offset, value):
        await self.registers.write_dword(offset, value)

    async def read(self, offset):
        return await self.registers.read_dword(offset)

    async def send(self, frame):
        pixels, width = frame["pixels"], frame["width"]
        for start in range(0, len(pixels), width):
            line = pixels[start : start + width]
            await self.video.send(AxiStreamFrame(tdata=line, tuser=[int(start == 0)] + [0] * (width - 1)))

    async def receive(self):
        return {name: await sink.recv(compact=False) for name, sink in self.results.items()}


async def run(dut, with_pauses):
    with open(os.environ["FLOORLINE_VECTORS"]) as file:
        frames = json.load(file)
    bits = 0
    bench = Bench(dut)
    await bench.reset()
    if with_pauses:
        bench.pause()
    await bench.write(CONTROL, 1)
    for frame in frames:
        for offset, value in frame["writes"]:
            await bench.write(offset, value)
        await bench.send(frame)
        packets = await bench.receive()
        for name, packet in packets.items():
            bits += differing_bits([int(element, 16) for element in frame[name]], packet.tdata)
            assert set(packet.tuser) == {0}, f"{name} are marked malformed"
        for register, name in ((NULL_PIXELS, "null_pixels"), (THRESHOLD_USED, "threshold_used")):
            bits += differing_bits([frame[name]], [await bench.read(register)])
        assert await bench.read(UPDATE) == 0
    print(f"differing bits: {bits} in {len(frames)} frames")
    assert bits == 0


@cocotb.test()
async def status_registers_are_0_after_reset(dut):
    """And none is unknown: an X in a word that is read raises an error."""
    bench = Bench(dut)
    await bench.reset()
    for offset in range(CONTROL, THRESHOLD_USED + 4, 4):
        assert await bench.read(offset) == 0, hex(offset)


@cocotb.test()
async def frames_back_to_back(dut):
    await run(dut, with_pauses=False)


@cocotb.test()
async def frames_with_pauses(dut):
    await run(dut, with_pauses=True)
