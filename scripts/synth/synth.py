"""The command behind scripts/synth.sh, whose head tells how to call it."""

import argparse

import os

import baseline
import bitstream
import flow
import power
import report
import sweep
import tables

SEEDS = 5  # placements of an ECP5 design: the clock depends on where the placer starts


def show(sections, file):
    """Prints sections and keeps them for `floorline report --hardware`."""
    print(report.text(sections))
    flow.keep(sections, file)
    print(f"\nfor a report: floorline report SEQUENCE --hardware {file.relative_to(flow.ROOT)}")


def synthesise(options):
    """A target of the flow: each design's resources, clock, and what the baseline says."""
    names = list(flow.entries()) if options.design == "all" else [options.design]
    results, sections = [], []
    for name in names:
        design = flow.Design(name, options.target)
        results.append(flow.evaluate(design, options.seeds, options.record, options.jobs))
        sections += report.sections(results[-1])
    show(sections, flow.ROOT / f"build/synth/{options.target}/{options.design}.sections.json")
    if options.baseline == "write":
        baseline.write(results)
    elif options.baseline == "check":
        grown = baseline.grown(results)
        if grown:
            flow.fail("resources have grown; if that is meant, run again with --baseline write:\n" + "\n".join(grown))


def main():
    parser = argparse.ArgumentParser(prog="synth.sh", description="Synthesis with open tools; see the head of scripts/synth.sh.")
    commands = parser.add_subparsers(dest="target", required=True, metavar="TARGET")
    for target in flow.TARGETS:
        command = commands.add_parser(target, help=f"resources{' and clock' if target == 'ecp5' else ''} on {target}")
        command.add_argument("--design", default="top", help="name in scripts/synth/designs.yaml, or all")
        command.add_argument("--seeds", type=int, default=SEEDS, help="placements to try (ecp5)")
        command.add_argument("--baseline", choices=["check", "write"])
        command.set_defaults(run=synthesise)
    command = commands.add_parser("sweep", help="resources and clock by frame size, and the FPGAs that hold it")
    command.add_argument("--seeds", type=int, default=1, help="placements of each size (ecp5)")
    command.set_defaults(run=lambda options: show(sweep.sections(sweep.measure(options)), flow.ROOT / "build/synth/sweep.sections.json"))
    command = commands.add_parser("power", help="estimate of the power")
    command.set_defaults(run=lambda options: show(power.sections(power.measure(options.record)), flow.ROOT / "build/synth/power.sections.json"))
    command = commands.add_parser("ulx3s", help="bitstream for the ULX3S board")
    command.set_defaults(run=lambda options: bitstream.build())
    command = commands.add_parser("tables", help="the tables of README.md and docs/synthesis.md")
    command.add_argument("--check", action="store_true", help="only compare with what is there")
    command.set_defaults(run=lambda options: tables.update(options.check))
    for command in commands.choices.values():
        command.add_argument("--record", action="store_true", help="also keep the results in records/synth")
        command.add_argument("--jobs", type=int, default=os.cpu_count(), help="placements at a time")
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()
