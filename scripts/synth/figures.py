"""Prints the synthesis figures with their bounds, a line each: name<TAB>value<TAB>bound<TAB>ok|short."""

import operator

import synth

SEEDS = 3
# ICVS 2015, architecture 2: 61.9 MHz at 640x480.
PIXELS = 640 * 480


def figure(name, value, relation, bound):
    holds = {"<=": operator.le, ">=": operator.ge}[relation](value, bound)
    print(f"{name}\t{value}\t{relation} {bound}\t{'ok' if holds else 'short'}", flush=True)


def evaluate(name, target):
    return synth.evaluate(synth.Design(name, synth.designs()[name], target, SEEDS))


def main():
    top = evaluate("top", "xc6v")["total"]
    for key, bound in (("lut", 5000), ("ff", 8000), ("bram", 90), ("dsp", 40)):
        figure(f"synth.{key}.xc6v", top[key], "<=", bound)

    placed = evaluate("top", "ecp5")
    figure("synth.fmax.ecp5", placed["fmax_mhz"], ">=", 100)
    figure("synth.frames_per_second.ecp5", round(placed["fmax_mhz"] * 1e6 / (PIXELS + 1000)), ">=", 325)

    for kernel in ("gaussian", "erode", "polar"):
        compiled, by_hand = (evaluate(name, "xc6v")["total"] for name in (kernel, f"{kernel}_handwritten"))
        for key in ("lut", "ff"):
            figure(f"synth.{kernel}.{key}_by_hand_ratio", round(compiled[key] / by_hand[key], 2), "<=", 1.2)
        for key in ("bram", "dsp"):
            figure(f"synth.{kernel}.{key}_beyond_by_hand", compiled[key] - by_hand[key], "<=", 0)


if __name__ == "__main__":
    main()
