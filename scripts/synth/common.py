"""Shared by the scripts of this folder: where the checkout is, progress lines, one-sentence failures."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def fail(message):
    sys.exit(f"error: {message}")


def say(message):
    print(f"==> {message}", file=sys.stderr, flush=True)
