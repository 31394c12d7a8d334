"""The regression baseline of the resources: scripts/synth/baseline.json, {TARGET/DESIGN: {lut, ff, bram, dsp}}."""

import json

import flow

FILE = flow.HERE / "baseline.json"
GROWTH = 0.02  # beyond this a resource has grown


def name(result):
    return f"{result['target']}/{result['design']}"


def read():
    return json.loads(FILE.read_text())


def growth(before, now):
    """How much a count has grown, as a share of what it was."""
    return (now - before) / max(before, 1)


def grown(results):
    """A sentence for each resource that grew beyond the bound; a design without a baseline has grown, too."""
    before = read()
    lines = []
    for result in results:
        if name(result) not in before:
            lines.append(f"{name(result)} has no baseline")
            continue
        for key, count in before[name(result)].items():
            if growth(count, result["total"][key]) > GROWTH:
                lines.append(f"{name(result)}: {key} {count} -> {result['total'][key]}")
    return lines


def write(results):
    now = read() | {name(result): result["total"] for result in results}
    FILE.write_text(json.dumps(dict(sorted(now.items())), indent=1) + "\n")
