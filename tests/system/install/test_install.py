"""cmake --install gives programs that start, and libraries that another CMake project finds, links and gets right
numbers from.

    usage: test_install.py BUILD_DIR CONSUMER_DIR
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CONSUMER = Path(sys.argv.pop(2))
BUILD = Path(sys.argv.pop(1))


def run(*command):
    """Runs a command; its output is shown where it fails."""
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=240)
    if result.returncode != 0:
        raise AssertionError(f"{command} ended with {result.returncode}\n{result.stdout}\n{result.stderr}")
    return result.stdout


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = Path(cls.folder.name) / "prefix"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_programs_start(self):
        for name in ("tremolo", "tremolo-domain", "tremolo-column", "tremolo-recording", "tremolo-wave"):
            with self.subTest(name):
                self.assertTrue(run(self.prefix / "bin" / name, "--help").strip())

    def test_the_python_package_is_whole(self):
        source = CONSUMER.parents[3] / "python"
        parts = {path.relative_to(source) for path in source.rglob("*") if path.is_file() and "__pycache__" not in path.parts}
        installed = self.prefix / "share/tremolo/python"
        self.assertEqual(parts, {path.relative_to(installed) for path in installed.rglob("*") if path.is_file()})

    def test_another_project_finds_and_uses_the_libraries(self):
        build = Path(self.folder.name) / "consumer"
        run("cmake", "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release")
        run("cmake", "--build", build)
        self.assertEqual(run(build / "consumer").strip(), "peak 0.200000 m/s")

    def test_template_of_an_own_free_field_builds_and_conforms(self):
        template = CONSUMER.parents[3] / "docs/examples/own_free_field"
        build = Path(self.folder.name) / "own_free_field"
        run("cmake", "-S", template, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release")
        run("cmake", "--build", build)
        self.assertIn("14 passed", run(self.prefix / "bin/tremolo", "conform", build / "my_field"))

    def test_headers_lie_below_one_folder(self):
        self.assertEqual([path.name for path in (self.prefix / "include").iterdir()], ["tremolo"])
        self.assertTrue((self.prefix / "include/tremolo/coupler/eq6/boundary_traction.hpp").is_file())


if __name__ == "__main__":
    unittest.main()
