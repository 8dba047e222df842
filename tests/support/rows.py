"""Runs a script of unittests: those classes whose names contain "Acceptance", or all others.

    usage: rows.py suite|acceptance SCRIPT ARGUMENTS
"""

import runpy
import sys
import unittest
from pathlib import Path

ACCEPTANCE = {"suite": False, "acceptance": True}[sys.argv[1]]
load = unittest.TestLoader.loadTestsFromTestCase


def load_chosen(loader, case):
    return load(loader, case) if ("Acceptance" in case.__name__) == ACCEPTANCE else loader.suiteClass()


unittest.TestLoader.loadTestsFromTestCase = load_chosen
sys.argv = sys.argv[2:]
sys.path[0] = str(Path(sys.argv[0]).parent)
runpy.run_path(sys.argv[0], run_name="__main__")
