"""Tables as comma-separated files: a heading with the unit at the end of each name, then numbers; empty where there is none."""

import csv
import io

import numpy as np

from tremolo import outputs


def file_name(*words):
    """Names of points may hold blanks."""
    return "_".join(words).replace(" ", "_") + ".csv"


def write(path, table):
    """table: name -> array, all of one length. Returns the path."""
    heading = io.StringIO()
    csv.writer(heading).writerow(table)
    with open(outputs.writable(path, beginning=heading.getvalue()), "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(table)
        for row in zip(*table.values()):
            writer.writerow(["" if np.isnan(value) else f"{value:.9g}" for value in row])
    return path
