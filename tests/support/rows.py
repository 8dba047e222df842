"""Runs a script of unittests: those classes whose names contain "Acceptance", or all others.

    usage: rows.py suite|acceptance SCRIPT ARGUMENTS
"""

import runpy
import sys
import unittest
from pathlib import Path

WHICH = sys.argv[1]
ACCEPTANCE = {"suite": False, "acceptance": True}[WHICH]
load = unittest.TestLoader.loadTestsFromTestCase
chosen = []


def load_chosen(loader, case):
    if ("Acceptance" in case.__name__) != ACCEPTANCE:
        return loader.suiteClass()
    chosen.extend(loader.getTestCaseNames(case))
    return load(loader, case)


unittest.TestLoader.loadTestsFromTestCase = load_chosen
sys.argv = sys.argv[2:]
sys.path[0] = str(Path(sys.argv[0]).parent)
try:
    runpy.run_path(sys.argv[0], run_name="__main__")
finally:
    if not chosen:
        sys.exit(f"rows.py: {sys.argv[0]} has no tests of {WHICH}")
