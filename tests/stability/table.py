#!/usr/bin/env python3
"""Runs the hard cases and writes their table: case, bound, measured, margin.

    tests/stability/table.py BUILD [PAGE]

runs `ctest -L stability -R hard_cases` in BUILD and writes what every test has measured (tests/support/hard_case.hpp)
between the markers of PAGE, or prints it."""

import os
import pathlib
import subprocess
import sys
import tempfile

BEGIN = "<!-- measured by tests/stability/table.py -->"
END = "<!-- end -->"


def margin(measured, relation, bound):
    """How many times the bound could be tightened."""
    if relation == "=":
        return "exact"
    if relation == "<":
        return f"{bound / measured:.3g}" if measured > 0 else "-"
    return f"{measured / bound:.3g}"


def table(rows):
    """Several rows of one kind in a test become their worst."""
    worst = {}
    for suite, test, kind, what, measured, relation, bound, unit in rows:
        key = (suite, test, kind, what, relation, bound, unit)
        better = min if relation == ">=" else max
        worst[key] = better(worst.get(key, float(measured)), float(measured))
    lines = ["| case | what | bound | measured | margin |", "|---|---|---|---|---|"]
    for (suite, test, kind, what, relation, bound, unit), measured in sorted(worst.items()):
        prefix = {"bound": "", "monitor": "monitor: ", "wrong": "wrong variant, must break the bound: "}[kind]
        lines.append(f"| {suite}.{test} | {prefix}{what} | {relation} {bound} {unit} | {measured:.3g} "
                     f"| {margin(measured, relation, float(bound))} |")
    return "\n".join(lines)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "rows"
        done = subprocess.run(["ctest", "-L", "stability", "-R", "hard_cases"], cwd=sys.argv[1],
                              env={**os.environ, "TREMOLO_HARD_CASES": str(file)}, check=False)
        if not file.exists():
            sys.exit("no hard case has run")
        text = table([line.split("\t") for line in file.read_text().splitlines()])
    if len(sys.argv) == 3:
        page = pathlib.Path(sys.argv[2])
        old = page.read_text()
        page.write_text(old[:old.index(BEGIN) + len(BEGIN)] + "\n" + text + "\n" + old[old.index(END):])
    else:
        print(text)
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
