"""Rows that tests write of what they measure (hard_case.hpp), and pages that hold tables between two markers."""

import pathlib

VARIABLE = "TREMOLO_HARD_CASES"  # of the environment: the file to which tests append their rows
END = "<!-- end -->"


def read(file):
    """Rows [suite, test, kind, what, measured, relation, bound, unit]; none where no test has written any."""
    file = pathlib.Path(file)
    return [line.split("\t") for line in file.read_text().splitlines()] if file.exists() else []


def worst_of(rows):
    """Measured by (case, kind, what, relation, bound, unit): several rows of one kind in a test become their worst."""
    worst = {}
    for suite, test, kind, what, measured, relation, bound, unit in rows:
        key = (f"{suite}.{test}", kind, what, relation, bound, unit)
        better = min if relation == ">=" else max
        worst[key] = better(worst.get(key, float(measured)), float(measured))
    return worst


def write_between(page, begin, text):
    """Replaces what stands between the marker `begin` and END of a page."""
    page = pathlib.Path(page)
    old = page.read_text()
    start = old.index(begin) + len(begin)
    page.write_text(old[:start] + "\n" + text + "\n" + old[old.index(END, start):])
