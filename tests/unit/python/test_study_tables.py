"""The tables that `tremolo cost` and `tremolo swap` print, of studies whose answers are known."""

import csv
import tempfile
import unittest
from pathlib import Path

from tremolo import cost, swap


def rung(size, error, cpu, front=True, **more):
    return {"folder": f"h={size}", "knobs": {"mesh.size": str(size), "time.transfer": "apic"}, "family": "time.transfer = apic",
            "size": size, "error": error, "phase_lag_s": 1e-3, "cpu_s": cpu, "updates": 1e6, "front": front, **more}


def ladder(*rungs, **more):
    return {"title": "Box", "error_of": "velocity", "rungs": list(rungs), "fits": [], **more}


# e = 0.03 h^2 over two sizes.
FIT = {"family": "time.transfer = apic", "points": 2, "order": 2.0, "constant": 0.03, "start_s": 0.2, "per_update_s": 80e-9,
       "error_spread": 1.0, "time_spread": 1.0}


class Cost(unittest.TestCase):
    def answer(self, target, **more):
        rungs = rung(2.0, 0.10, 1.0), rung(1.0, 0.03, 4.0), rung(0.9, 0.02, 9.5, front=False), rung(0.5, 0.01, 9.0)
        return list(cost.words(ladder(*rungs, target=target, **more)))[-2:]

    def test_the_cheapest_rung_that_is_good_enough_answers_a_target(self):
        for target, size, cpu in ((0.2, 2, 1), (0.03, 1, 4), (0.029, 0.5, 9)):
            measured, _ = self.answer(target)
            self.assertIn(f"time.transfer = apic, mesh.size = {size}: ", measured)
            self.assertIn(f"{cpu} s of CPU time", measured)
        self.assertEqual(["measured: no rung reaches 0.9 %", "predicted: nothing, no fit of these rungs reaches so far"], self.answer(0.009))

    def test_a_prediction_says_that_it_was_not_run(self):
        prediction = {"family": "", "size": 0.25, "error": 0.005, "cpu_s": 33.3}
        self.assertEqual("predicted: 0.9 % with mesh.size = 0.25: error 0.5 %, 33.3 s of CPU time; not run, by the fit",
                         self.answer(0.009, prediction=prediction)[1])

    def test_every_rung_has_a_line(self):
        reference = rung(0.5, 0.0, 9.0, front=False, reference=True)
        del reference["error"]
        refused = {"folder": "h=7", "knobs": {"mesh.size": "7", "time.transfer": "apic"}, "refused": "7 m do not divide the box"}
        lines = list(cost.words(ladder(rung(1.0, 0.03, 4.0), reference, refused, fits=[FIT])))
        self.assertEqual(["1.0", "apic", "3", "%", "1.000", "ms", "4.00", "s", "1e+06", "*"], lines[2].split())
        self.assertEqual(["0.5", "apic", "reference"], lines[3].split()[:3])
        self.assertTrue(lines[4].endswith("refused: 7 m do not divide the box"))
        self.assertIn("error 3 % (h/1 m)^2.00 (two points, unchecked), CPU time 0.2 s + 80 ns an update", lines[-1])
        self.assertEqual(len({line.index("apic") for line in lines[2:5]}), 1)

    def test_the_file_holds_values_with_commas(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "cost.csv"
            cost.write_table(ladder(rung(1.0, 0.03, 4.0, knobs={"mesh.refine": "[1, 2]"}), {"knobs": {}, "refused": "no"}), path)
            with open(path, newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([{"mesh.refine": "[1, 2]", "relative_error": "0.03", "phase_lag_s": "0.001", "cpu_s": "4.0",
                           "particle_updates": "1000000.0", "front": "1"}], rows)


class Swap(unittest.TestCase):
    def entry(self, model, **more):
        return {"model": model, "refused": "", "failed": False, "source_cpu_s": 1.0, "domain_cpu_s": 2.0, "wall_s": 3.0,
                "free_field": 0.0123, "monitors": {"crest": 0.5}, **more}

    def test_every_model_has_a_line(self):
        refused = {"model": "ode", "refused": "knows vertical incidence only\nand more", "failed": False}
        failed = {"model": "eql", "refused": "the run in x failed", "failed": True}
        lines = list(swap.words([refused, self.entry("fe"), failed]))
        self.assertEqual("ode         refused: knows vertical incidence only", lines[1])
        self.assertEqual(["fe", "1.00", "s", "2.00", "s", "3.00", "s", "1.230", "%", "-", "50.000", "%"], lines[2].split())
        self.assertEqual("eql         failed: the run in x failed", lines[3])
        self.assertTrue(lines[0].endswith("crest") and len(lines[0]) == len(lines[2]))
        self.assertIn("to 'fe'", lines[4])
        self.assertEqual(5, len(lines))

    def test_pore_pressure_has_a_table_of_its_own(self):
        wet = {"crest": {"mean": 0.38, "rms_difference": 0.005}}
        lines = list(swap.words([self.entry("mpm", pore_pressure_ratio=wet), self.entry("fe")]))
        self.assertEqual(["r_u", "crest"], lines[-4].split())
        self.assertEqual(["mpm", "0.380", "(0.005)"], lines[-3].split())
        self.assertEqual(["fe", "-"], lines[-2].split())

    def test_no_model_is_said(self):
        self.assertEqual(["no model can compute this case"], list(swap.words([{"model": "ode", "refused": "no"}])))


if __name__ == "__main__":
    unittest.main()
