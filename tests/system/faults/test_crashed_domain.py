"""A domain that a signal ends: its results are marked as aborted, and nothing says that they were complete.

    usage: test_crashed_domain.py TREMOLO CRASHING_EXIT

CRASHING_EXIT is the library of crashing_exit.c.
"""

import os
import signal
import sys
import unittest

TREMOLO, CRASHING_EXIT = sys.argv.pop(1), sys.argv.pop(1)

from fault_lab import Attack, results


class CrashedDomain(unittest.TestCase):
    def check_aborted(self, run, number):
        run.process.wait(timeout=60)
        output = run.output()
        self.assertEqual(1, run.process.returncode, output)
        self.assertIn(f"'domain' was killed by signal {number}", output)
        self.assertNotIn("complete", output)
        status, _ = results(run.out)
        self.assertRegex(status, rf"^aborted.*'domain' was killed by signal {number}")

    def test_in_the_middle_of_its_run(self):
        for number in (signal.SIGSEGV, signal.SIGKILL):
            with self.subTest(number), Attack(TREMOLO, duration=60.0) as run:
                run.await_phase("stepping")
                os.kill(run.pid("domain"), number)
                self.check_aborted(run, int(number))

    def test_when_it_has_written_all_its_results(self):
        with Attack(TREMOLO, template="box", duration=0.2, every=0.05, environment={"LD_PRELOAD": CRASHING_EXIT}) as run:
            self.check_aborted(run, int(signal.SIGSEGV))
            self.assertEqual(5, run.frames())


if __name__ == "__main__":
    unittest.main()
