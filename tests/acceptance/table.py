#!/usr/bin/env python3
"""Runs the tests of label acceptance and writes their table: measured, bound, result, CPU time.

    tests/acceptance/table.py BUILD PAGE           all of them; the table replaces that of PAGE
    tests/acceptance/table.py BUILD --only REGEX   those whose names match; the table is printed

Tests write what they measure as tests/support/hard_case.hpp says. A test that writes nothing has one row, without
numbers."""

import argparse
import concurrent.futures
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.append(str(pathlib.Path(__file__).parents[1] / "support"))
import measured_rows

BEGIN = "<!-- measured by tests/acceptance/table.py -->"
RESULTS = {"run": "pass", "notrun": "skipped", "fail": "**fail**"}


def names(build, only):
    shown = subprocess.run(["ctest", "--test-dir", build, "-L", "^acceptance$", "-R", only, "--show-only=json-v1"],
                           capture_output=True, text=True, check=True).stdout
    return [test["name"] for test in json.loads(shown)["tests"]]


def run(build, name):
    """The test's rows, its result, and its CPU time in s with that of all processes that it started."""
    with tempfile.TemporaryDirectory() as folder:
        rows, junit = pathlib.Path(folder) / "rows", pathlib.Path(folder) / "junit.xml"
        process = subprocess.Popen(["ctest", "--test-dir", build, "-R", f"^{re.escape(name)}$", "--output-junit", junit],
                                   env={**os.environ, measured_rows.VARIABLE: str(rows)}, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)  # wait4 has collected it
        result = xml.etree.ElementTree.parse(junit).find("testcase").get("status")
        print(f"{name}: {result}, {used.ru_utime + used.ru_stime:.0f} s", file=sys.stderr, flush=True)
        return measured_rows.worst_of(measured_rows.read(rows)), RESULTS[result], used.ru_utime + used.ru_stime


def table(done):
    lines = ["| test | what | measured | bound | result | CPU, s |", "|---|---|---|---|---|---|"]
    for name, (worst, result, seconds) in done.items():
        first = f"`{name}`"
        for (_, kind, what, relation, bound, unit), measured in worst.items():
            prefix = "wrong variant, must miss the bound: " if kind == "wrong" else ""
            lines.append(f"| {first} | {prefix}{what} | {measured:.3g} | {relation} {float(bound):.6g} {unit} | {result} "
                         f"| {seconds:.0f} |")
        if not worst:
            lines.append(f"| {first} | - | - | - | {result} | {seconds:.0f} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("page", nargs="?")
    parser.add_argument("--only", default="", metavar="REGEX")
    chosen = parser.parse_args()
    if (chosen.page is None) == (chosen.only == ""):
        parser.error("either PAGE or --only REGEX")

    found = names(chosen.build, chosen.only)
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        done = dict(zip(found, pool.map(lambda name: run(chosen.build, name), found)))
    failed = sum(result == "**fail**" for _, result, _ in done.values())
    total = sum(seconds for _, _, seconds in done.values())
    said = f"{datetime.date.today():%-d %B %Y}: {len(done)} tests, {failed} failed, {total / 60:.0f} minutes of CPU."
    text = "\n".join([said, "", *table(done)])
    if chosen.page:
        measured_rows.write_between(chosen.page, BEGIN, text)
    else:
        print(text)
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
