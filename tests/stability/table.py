#!/usr/bin/env python3
"""Runs the hard cases and writes their table: case, bound, measured, margin.

    tests/stability/table.py BUILD [PAGE]

runs all tests of BUILD that are called after a hard case, those of acceptance among them, and writes what they have measured
(tests/support/hard_case.hpp) between the markers of PAGE, or prints it."""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[1] / "support"))
import measured_rows

BEGIN = "<!-- measured by tests/stability/table.py -->"


def margin(measured, relation, bound):
    """How many times the bound could be tightened."""
    if relation == "=":
        return "exact"
    if relation == "<":
        return f"{bound / measured:.3g}" if measured > 0 else "-"
    return f"{measured / bound:.3g}"


def bounds_table(worst):
    lines = ["| case | what | bound | measured | margin |", "|---|---|---|---|---|"]
    for (case, kind, what, relation, bound, unit), measured in sorted(worst.items()):
        if kind != "monitor":
            prefix = "" if kind == "bound" else "wrong variant, must miss the bound: "
            lines.append(f"| {case} | {prefix}{what} | {relation} {float(bound):.6g} {unit} | {measured:.3g} "
                         f"| {margin(measured, relation, float(bound))} |")
    return "\n".join(lines)


def monitors_table(worst):
    """One row a case: measured, and the bound where it is not everybody's."""
    quantities = {"mass": 1e-12, "momentum": 1e-10, "energy": 0.02, "largest speed": None}
    cases = {}
    for (case, kind, what, _, bound, _), measured in worst.items():
        if kind == "monitor":
            own = "" if float(bound) == quantities[what] else f" (< {float(bound):.3g})"
            cases.setdefault(case, {})[what] = f"{measured:.2g}{own}"
    lines = ["| case | mass < 1e-12 | momentum < 1e-10 | energy < 0.02 | largest speed, m/s |", "|---|---|---|---|---|"]
    for case, measured in sorted(cases.items()):
        lines.append(f"| {case} | " + " | ".join(measured.get(what, "-") for what in quantities) + " |")
    return "\n".join(lines)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "rows"
        done = subprocess.run(["ctest", "-L", "stability|acceptance", "-R", "hard_cases|HardCase"], cwd=sys.argv[1],
                              env={**os.environ, measured_rows.VARIABLE: str(file)}, check=False)
        rows = measured_rows.read(file)
        if not rows:
            sys.exit("no hard case has run")
        worst = measured_rows.worst_of(rows)
    text = f"{bounds_table(worst)}\n\n### Monitors\n\n{monitors_table(worst)}"
    if len(sys.argv) == 3:
        measured_rows.write_between(sys.argv[2], BEGIN, text)
    else:
        print(text)
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
