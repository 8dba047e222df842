"""Who may include whom, and how long a file may be.

    usage: test_architecture.py SOURCE_DIR
"""

import json
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve()
LONGEST_FILE = 500  # lines

FOR_ALL = "base"  # may be included by every folder

# Libraries: folder -> folders whose headers it may include besides its own. coupler/eq6, materials/relaxation
# and mpm_domain/spec are libraries of their own.
LIBRARIES = {
    "base": set(),
    "mesh": set(),
    "seepage": set(),
    "wavefield": {"materials/relaxation"},
    "materials": {"materials/relaxation"},
    "materials/relaxation": set(),
    "motion": set(),
    "results": set(),
    "coupler/eq6": set(),
    "freefield": {"materials"},
    "mpm_domain/spec": {"mesh", "materials", "coupler/eq6"},
    "mpm_domain": {"mpm_domain/spec", "mesh", "seepage", "materials", "results", "coupler/eq6"},
    "scene": {"mpm_domain/spec", "mesh", "materials", "motion"},
    "coupler": {"results", "coupler/eq6"},
    "app": {"scene", "coupler", "results", "materials", "motion", "wavefield", "freefield", "mpm_domain", "mpm_domain/spec"},
}

# Mains of processes, in <library>/process/ or <library>/main.cpp: their library's folders and these.
PROCESSES = {
    "coupler": {"results", "coupler/eq6", "scene"},
    "wavefield": {"materials", "motion", "scene", "coupler"},
    "freefield": {"materials", "motion", "wavefield", "scene", "coupler"},
    "mpm_domain": {"mpm_domain/spec", "materials", "motion", "results", "coupler/eq6", "scene", "coupler", "freefield", "wavefield"},
}

# All that a process knows of the coupler. recorded_case takes no part in an exchange: it describes a case.
PARTICIPANT = re.compile(r"coupler/(participant\.hpp|eq6/.*|process/.*)")
NO_PARTICIPANT = {"coupler/process/recorded_case.cpp"}
PUBLIC_METHODS = 8  # of both roles together, besides constructors

# Rooms of the domain. A room may include those before it. Those up to the boundary work on mpm_domain/ground.hpp alone;
# those after it on mpm_domain/domain.hpp, which holds the boundary.
ON_GROUND = ["fields", "spec", "head", "kernel", "ranks", "grid", "tiles", "clocks", "passes", "particles", "strain", "dispersion", "transfer", "water"]
ON_GROUND += ["mass_damping", "contact", "lining", "prop", "section", "earthworks", "boundary"]
ROOMS = [*ON_GROUND, "step", "gravity", "column", "process"]
MOST_FILES = 20  # C++ files in a folder of a library

SOURCES = {".cpp", ".hpp", ".py", ".sh", ".cmake"}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')


def folder_of(path):
    """The architectural folder of a path relative to the root, e.g. coupler/eq6; the tables of fields belong to spec."""
    if path.startswith("mpm_domain/fields/"):
        return "mpm_domain/spec"
    return next((leaf for leaf in LIBRARIES if "/" in leaf and path.startswith(leaf + "/")), path.split("/")[0])


def is_process(path):
    return path.split("/")[1] in ("process", "main.cpp")


def allowed(path):
    folder = folder_of(path)
    others = LIBRARIES[folder]
    if folder in PROCESSES and is_process(path):
        others = others | PROCESSES[folder]
    if "materials" in others:
        others = others | {"materials/relaxation"}
    return others | {folder, FOR_ALL}


def sources(folder, suffixes):
    return sorted(p for p in (ROOT / folder).rglob("*") if p.suffix in suffixes and p.is_file())


def forbidden_includes():
    for folder in sorted({folder.split("/")[0] for folder in LIBRARIES}):
        for file in sources(folder, {".cpp", ".hpp"}):
            path = file.relative_to(ROOT).as_posix()
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                if match and folder_of(match[1]) not in allowed(path):
                    yield f"{path}:{number}: includes {match[1]}; {path} may know {sorted(allowed(path))}"


def tests_that_start_programs(cmake):
    """Name and labels of the ctest entries of a CMakeLists.txt that start a program besides test programs.

    Sanitized builds make test programs, and what those start, alone (target test_programs).
    """
    entry = re.compile(r"(tremolo_python_test\(|add_test\(NAME )(\S+)((?:[^()]|\([^()]*\))*)\)")
    for call, name, rest in entry.findall(cmake):
        if re.search(r"COMMAND (?!/|\$)|\$<TARGET_FILE|/bin\b", rest):
            if call.startswith("add_test"):
                (rest,) = re.findall(rf"set_tests_properties\({re.escape(name)}\s([^()]*)\)", cmake)
            (labels,) = re.findall(r'LABELS((?:\s+(?:[a-z]+\b|"[^"]*"))+)', rest) or [""]
            yield name, re.findall(r"[a-z]+", labels)


class Architecture(unittest.TestCase):
    def test_includes_follow_the_table(self):
        self.assertEqual([], list(forbidden_includes()))

    def test_rooms_of_the_domain_include_those_before_them(self):
        for number, room in enumerate(ROOMS):
            for file in sources(f"mpm_domain/{room}", {".cpp", ".hpp"}):
                for other in re.findall(r'^#include "mpm_domain/(\w+)/', file.read_text(encoding="utf-8"), re.MULTILINE):
                    self.assertIn(other, ROOMS[: number + 1], file.relative_to(ROOT).as_posix())

    def test_rooms_up_to_the_boundary_know_ground_alone(self):
        for room in ON_GROUND:
            for file in sources(f"mpm_domain/{room}", {".cpp", ".hpp"}):
                known = re.findall(r'^#include "mpm_domain/(\w+)\.hpp"', file.read_text(encoding="utf-8"), re.MULTILINE)
                self.assertLessEqual(set(known), {"ground"}, file.relative_to(ROOT).as_posix())

    def test_the_order_of_rooms_names_all(self):
        self.assertEqual(sorted(ROOMS), sorted(p.name for p in (ROOT / "mpm_domain").iterdir() if p.is_dir()))

    def test_folders_are_small(self):
        for library in sorted({folder.split("/")[0] for folder in LIBRARIES}):
            for folder in [ROOT / library, *(p for p in (ROOT / library).rglob("*") if p.is_dir())]:
                files = sum(p.suffix in {".cpp", ".hpp"} for p in folder.iterdir())
                self.assertLessEqual(files, MOST_FILES, folder.relative_to(ROOT))

    def test_tests_stand_where_their_source_does(self):
        stems = {}
        for library in sorted({folder.split("/")[0] for folder in LIBRARIES}):
            for file in (ROOT / library).rglob("*.?pp"):
                stems.setdefault((library, file.stem), set()).add(file.parent.relative_to(ROOT).as_posix())
        unit = ROOT / "tests" / "unit"
        for file in unit.rglob("*_test.cpp"):
            folder = file.parent.relative_to(unit).as_posix()
            sources = stems.get((folder.split("/")[0], file.stem.removesuffix("_test")), set())
            self.assertTrue(len(sources) != 1 or folder in sources, f"{file.relative_to(ROOT)}: {sources}")

    def test_every_rule_has_a_test_of_its_name(self):
        rules = re.findall(r"Needs::\w+,\s*(\w+),", (ROOT / "scene/rules/rule_table.cpp").read_text(encoding="utf-8"))
        tests = {
            name
            for file in (ROOT / "tests" / "unit" / "scene").rglob("*.cpp")
            for name in re.findall(r"TEST\w*\(\w+,\s*(\w+)\)", file.read_text(encoding="utf-8"))
        }
        self.assertGreater(len(rules), 90)
        self.assertEqual([], [rule for rule in rules if "".join(word.capitalize() for word in rule.split("_")) not in tests])

    def test_nobody_but_materials_asks_which_law_it_is(self):
        question = re.compile(r"(holds_alternative|get_if|std::get)<materials::")
        askers = [
            file.relative_to(ROOT).as_posix()
            for folder in LIBRARIES
            if folder != "materials"
            for file in sources(folder, {".cpp", ".hpp"})
            if question.search(file.read_text(encoding="utf-8"))
        ]
        self.assertEqual([], askers)

    def test_every_included_file_of_ours_exists(self):
        for folder in sorted({folder.split("/")[0] for folder in LIBRARIES}):
            for file in sources(folder, {".cpp", ".hpp"}):
                for name in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE):
                    self.assertTrue((ROOT / name).is_file(), f"{file.relative_to(ROOT)} includes {name}")

    def test_libraries_do_not_include_their_process(self):
        for folder in PROCESSES:
            for file in sources(folder, {".cpp", ".hpp"}):
                path = file.relative_to(ROOT).as_posix()
                if not is_process(path):
                    self.assertNotIn(f'#include "{folder}/process/', file.read_text(encoding="utf-8"), path)

    def test_processes_know_the_public_header_of_the_coupler_alone(self):
        for folder in PROCESSES:
            for file in sources(folder, {".cpp", ".hpp"}):
                path = file.relative_to(ROOT).as_posix()
                if is_process(path) and path not in NO_PARTICIPANT:
                    for name in re.findall(r'^#include "(coupler/[^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE):
                        self.assertRegex(name, PARTICIPANT, path)

    def test_the_public_header_has_few_methods_with_pre_and_postconditions(self):
        header = (ROOT / "coupler/participant.hpp").read_text(encoding="utf-8")
        methods = []
        for part in re.findall(r"^class \w+ {\npublic:\n(.*?)^private:", header, re.MULTILINE | re.DOTALL):
            # A declaration and the lines of /// right above it; constructors have no type before their name.
            for comment, name in re.findall(r"((?:^  ///.*\n)+)^  (?!explicit )\w[\w:<> ]* (\w+)\(", part, re.MULTILINE):
                methods.append(name)
                self.assertIn("@pre", comment, name)
                self.assertIn("@post", comment, name)
        self.assertIn("serve", methods)
        self.assertIn("exchange", methods)
        self.assertLessEqual(len(methods), PUBLIC_METHODS, methods)

    def test_no_file_is_too_long(self):
        folders = {folder.split("/")[0] for folder in LIBRARIES} | {"tests", "python", "scripts", "cmake", "cases"}
        long_files = {}
        for folder in folders:
            for file in sources(folder, SOURCES):
                lines = len(file.read_text(encoding="utf-8").splitlines())
                if lines > LONGEST_FILE:
                    long_files[file.relative_to(ROOT).as_posix()] = lines
        self.assertEqual({}, long_files)

    def test_tests_that_start_a_program_by_hand_are_left_out_of_sanitized_builds(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["testPresets"]
        left_out = [re.compile(p["filter"]["exclude"]["label"]) for p in presets if p["name"] in {"asan", "tsan"}]
        self.assertEqual(2, len(left_out))
        for file in (ROOT / "tests").rglob("CMakeLists.txt"):
            text = file.read_text(encoding="utf-8")
            for name, labels in tests_that_start_programs(text):
                for pattern in left_out:
                    self.assertTrue("fast" not in labels or any(map(pattern.search, labels)), f"{name} in {file}: {labels}")


class TheCheckItself(unittest.TestCase):
    """The table is read as it is meant."""

    def test_processes_may_know_more_than_their_library(self):
        self.assertNotIn("scene", allowed("mpm_domain/domain.cpp"))
        self.assertIn("scene", allowed("mpm_domain/process/domain_process.cpp"))

    def test_eq6_is_a_leaf_of_its_own(self):
        self.assertIn(folder_of("coupler/eq6/boundary_traction.hpp"), allowed("mpm_domain/domain.cpp"))
        self.assertNotIn(folder_of("coupler/hub/hub.hpp"), allowed("mpm_domain/domain.cpp"))
        self.assertEqual({"coupler/eq6", FOR_ALL}, allowed("coupler/eq6/boundary_traction.hpp"))


if __name__ == "__main__":
    unittest.main()
