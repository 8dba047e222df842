"""Tables as comma-separated files: a heading with the unit at the end of each name, then numbers, or names; empty where there is none."""

import csv

import numpy as np

from tremolo import outputs


def file_name(*words):
    """Names of points may hold blanks."""
    return "_".join(words).replace(" ", "_") + ".csv"


def write(path, table):
    """table: name -> numbers or texts, all of one length. Returns the path."""
    first = next(iter(table)) + ","  # the columns behind it depend on what is asked for
    with open(outputs.writable(path, beginning=first), "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(table)
        for row in zip(*table.values()):
            writer.writerow([value if isinstance(value, str) else "" if np.isnan(value) else f"{value:.9g}" for value in row])
    return path
