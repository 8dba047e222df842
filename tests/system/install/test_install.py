"""cmake --install gives a tree that works wherever it is put: programs, manual, completions, the Python package, and
libraries that another CMake project finds, links and gets right numbers from.

    usage: test_install.py BUILD_DIR CONSUMER_DIR
"""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CONSUMER = Path(sys.argv.pop(2))
BUILD = Path(sys.argv.pop(1))


def run(*command, **options):
    """Runs a command; its output is shown where it fails."""
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=240, **options)
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

    def test_a_tree_put_elsewhere_makes_runs_draws_and_reports_a_case(self):
        place = Path(self.folder.name) / "elsewhere" / "tremolo"
        shutil.copytree(self.prefix, place)
        work = Path(self.folder.name) / "work"
        work.mkdir()
        bare = {"PATH": f"{place}/bin:/usr/bin:/bin", "HOME": str(work)}
        run("tremolo", "new", "first", "--like", "box", cwd=work, env=bare)
        case = work / "first" / "case.toml"
        text = case.read_text()
        self.assertIn('title = "first"', text)
        self.assertIn(f"#:schema {place}/share/tremolo/docs/case.schema.json", text)
        self.assertTrue((place / "share/tremolo/docs/case.schema.json").is_file())
        case.write_text(text.replace("size = 0.5", "size = 4.0").replace("duration_s = 2.2", "duration_s = 0.2"))
        run("tremolo", "run", "first/case.toml", "--report", cwd=work, env=bare)
        run("tremolo", "plot", "runs/first", cwd=work, env=bare)
        self.assertTrue((work / "runs/first/report.html").is_file())
        self.assertTrue((work / "runs/first/pictures/model.png").is_file())

    def test_every_command_has_a_manual_page_without_faults(self):
        pages = self.prefix / "share/man/man1"
        names = re.findall(r"^  (\w+) ", run(self.prefix / "bin/tremolo", "--help"), re.MULTILINE)
        self.assertIn("run", names)
        self.assertEqual({"tremolo.1"} | {f"tremolo-{name}.1" for name in names}, {page.name for page in pages.iterdir()})
        for page in pages.iterdir():
            faults = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", page], capture_output=True, text=True)
            self.assertEqual((faults.returncode, faults.stderr), (0, ""), page.name)
        self.assertIn("folder of the pictures", (pages / "tremolo-plot.1").read_text())

    def test_shells_complete_commands_options_and_values(self):
        share = self.prefix / "share"
        script = f'''source {share}/bash-completion/completions/tremolo
            complete_words() {{ COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _tremolo; echo "${{COMPREPLY[@]}}"; }}
            complete_words tremolo tim; complete_words tremolo run --mo; complete_words tremolo run --mode l'''
        self.assertEqual(run("bash", "-c", script).split("\n")[:3], ["timeline", "--mode --motion", "lockstep"])
        fish = f"source {share}/fish/vendor_completions.d/tremolo.fish;"
        for line, first in (("tremolo tim", "timeline"), ("tremolo run --mot", "--motion"), ("tremolo run --mode l", "lockstep")):
            self.assertEqual(run("fish", "-c", f"{fish} complete -C '{line}'").split()[0], first)
        run("zsh", "-n", share / "zsh/site-functions/_tremolo")

    def test_pip_installs_the_python_package(self):
        target = Path(self.folder.name) / "site"
        source = Path(self.folder.name) / "python"
        shutil.copytree(self.prefix / "share/tremolo/python", source)  # pip builds beside the sources
        run("/usr/bin/python3", "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps",
            "--target", target, source)
        program = "import importlib.metadata, sys; sys.path.insert(0, sys.argv[1]); import tremolo.report.page; " \
                  "print('tremolo', importlib.metadata.version('tremolo'), tremolo.__file__)"
        words = run("/usr/bin/python3", "-I", "-c", program, target).split()
        self.assertEqual(" ".join(words[:2]), run(self.prefix / "bin/tremolo", "--version").strip())
        self.assertEqual(words[2], str(target / "tremolo/__init__.py"))
        self.assertTrue((target / "tremolo/report/base.html.jinja").is_file())

    def test_acceptance_debian_package_names_what_it_needs_and_holds_what_runs(self):
        made = Path(self.folder.name) / "package"
        run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", made)
        package = next(made.glob("tremolo_*.deb"))
        needs = run("dpkg-deb", "-f", package, "Depends")
        for name in ("libfftw3-double3", "libzmq5", "libsundials", "libhdf5", "python3-h5py", "python3-plotly"):
            self.assertIn(name, needs)
        root = made / "root"
        run("dpkg-deb", "-x", package, root)
        self.assertIn("tremolo", run(root / "usr/bin/tremolo", "--version", env={"PATH": "/usr/bin:/bin"}))
        program = "import site, sys; site.addsitedir(sys.argv[1]); import tremolo; print(tremolo.__file__)"
        found = run("/usr/bin/python3", "-I", "-c", program, root / "usr/lib/python3/dist-packages").strip()
        self.assertEqual(Path(found).resolve(), root / "usr/share/tremolo/python/tremolo/__init__.py")

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

    def test_acceptance_the_domain_runs_in_a_program_of_ones_own(self):
        example = CONSUMER.parents[3] / "docs/examples/domain_alone"
        build = Path(self.folder.name) / "domain_alone"
        run("cmake", "-S", example, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_CXX_FLAGS=-Werror=psabi")
        run("cmake", "--build", build)
        self.assertIn("the surface moves with 1.997 times the incident wave", run(build / "shaken_box"))

    def test_acceptance_template_of_an_own_free_field_builds_and_conforms(self):
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
