"""Prints the synthesis figures with their bounds, a line each: name<TAB>value<TAB>bound<TAB>ok|short. Measures and records what is not known."""

import operator
import os

import baseline
import flow
import power
import tables

SEEDS = 5


def figure(name, value, relation, bound):
    holds = {"<=": operator.le, ">=": operator.ge}[relation](value, bound)
    print(f"{name}\t{value}\t{relation} {bound}\t{'ok' if holds else 'short'}", flush=True)


def evaluate(name, target, seeds=0):
    return flow.evaluate(flow.Design(name, target), seeds, record=True, jobs=os.cpu_count())


def resources():
    result = evaluate("top", "xc6v")
    for key, bound in (("lut", 5000), ("ff", 8000), ("bram", 90), ("dsp", 40)):
        figure(f"synth.{key}.xc6v", result["total"][key], "<=", bound)
    accepted = baseline.read()[baseline.name(result)]
    for key, count in accepted.items():
        figure(f"synth.{key}_growth.xc6v", round(baseline.growth(count, result["total"][key]), 3), "<=", baseline.GROWTH)


def lens():
    total = evaluate("lens", "xc6v")["total"]
    for key, aim in (("lut", 1200), ("bram", 8)):
        figure(f"synth.lens.{key}.xc6v", total[key], "<=", aim)


def by_hand():
    for kernel in tables.KERNELS:
        pair = (kernel, f"{kernel}_handwritten")
        compiled, handwritten = (evaluate(name, "xc6v")["total"] for name in pair)
        for key in ("lut", "ff"):
            figure(f"synth.{kernel}.{key}_by_hand_ratio", round(compiled[key] / handwritten[key], 2), "<=", 1.2)
        for key in ("bram", "dsp"):
            figure(f"synth.{kernel}.{key}_beyond_by_hand", compiled[key] - handwritten[key], "<=", 0)
        compiled_mhz, handwritten_mhz = (flow.best_route(evaluate(name, "ecp5", SEEDS))["mhz"] for name in pair)
        figure(f"synth.{kernel}.mhz_by_hand_ratio", round(compiled_mhz / handwritten_mhz, 2), ">=", 0.9)


def clock():
    placed = evaluate("top", "ecp5", SEEDS)
    mhz = flow.best_route(placed)["mhz"]
    figure("synth.mhz.ecp5", mhz, ">=", 100)
    figure("synth.seeds.ecp5", len(placed["routes"]), ">=", SEEDS)
    figure("synth.frames_per_second.ecp5", round(mhz * 1e6 / tables.cycles(tables.VGA)["frame_cycles"]), ">=", 325)


def main():
    resources()
    lens()
    by_hand()
    figure("synth.power_w", power.measure(record=True)["power_w"], "<=", tables.published()["paper"]["power_w"])
    clock()


if __name__ == "__main__":
    main()
