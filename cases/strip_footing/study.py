#!/usr/bin/env python3
"""Which weight of the footing the clay carries, as a share of Prandtl's (2 + pi) c, with two sizes of cells: a Markdown table.

    cases/strip_footing/study.py [TREMOLO]      default: build/release/bin/tremolo; results go to runs/strip_footing
"""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
CASE = Path(__file__).resolve().parent / "case.toml"
SHARES = [0.80, 0.90, 0.95, 1.00, 1.05, 1.10]
SIZES = [0.25, 0.125]
COHESION, HEIGHT, GRAVITY = 20e3, 2.0, 9.81


def stands(tremolo, folder, share, size):
    """Whether the gravity stage comes to rest."""
    text = CASE.read_text()
    density = share * (2.0 + np.pi) * COHESION / (GRAVITY * HEIGHT)
    for old, new in [("density = 4979.0 ", f"density = {density:.1f} "), ("size = 0.25\n", f"size = {size}\n")]:
        if text.count(old) != 1:
            raise SystemExit(f"{CASE}: expected exactly one '{old.strip()}'")
        text = text.replace(old, new)
    case = folder / f"{share:.2f}_{size}.toml"
    case.write_text(text)
    done = subprocess.run([tremolo, "run", case, "--out", folder / case.stem, "--replace"], capture_output=True, text=True)
    return done


def main():
    tremolo = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/tremolo"
    folder = Path("runs/strip_footing")
    folder.mkdir(parents=True, exist_ok=True)


if __name__ == "__main__":
    main()
