"""Runs a script of unittests: those tests whose name, or whose class's, contains "acceptance", or all others.

    usage: rows.py suite|acceptance SCRIPT ARGUMENTS
"""

import runpy
import sys
import unittest
from pathlib import Path

WHICH = sys.argv[1]
ACCEPTANCE = {"suite": False, "acceptance": True}[WHICH]
names_of = unittest.TestLoader.getTestCaseNames
chosen = []


def chosen_names(loader, case):
    names = [name for name in names_of(loader, case) if ("acceptance" in f"{case.__name__}.{name}".lower()) == ACCEPTANCE]
    chosen.extend(names)
    return names


unittest.TestLoader.getTestCaseNames = chosen_names
sys.argv = sys.argv[2:]
sys.path[0] = str(Path(sys.argv[0]).parent)
try:
    runpy.run_path(sys.argv[0], run_name="__main__")
finally:
    if not chosen:
        sys.exit(f"rows.py: {sys.argv[0]} has no tests of {WHICH}")
