"""Runs the soil tests of the gallery and keeps its pictures; where page and repository are."""

import io
import json
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "python"))

import gallery_tests as tests
from PIL import Image
from tremolo import style
from tremolo.soil_test import drawing, record

PAGES = ROOT / "docs" / "materials"
DPI = 110


@dataclass
class Gallery:
    """Where the command, the reference curves and the results are."""

    tremolo: Path
    reference: Path
    folder: Path

    def __post_init__(self):
        self.manifest = json.loads((self.reference / "manifest.json").read_text())

    def parameters(self, name):
        return self.manifest[name]["params"]

    def curve(self, name):
        return record.read_reference(self.reference / f"{name}.csv")

    def run(self, text, name):
        """Runs a test file that is not kept."""
        path = self.folder / f"{name}.toml"
        path.write_text(text)
        return self._run(path)

    def run_kept(self, text, name):
        """Runs a test file that readers of the page can run."""
        path = PAGES / "tests" / f"{name}.toml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        return self._run(path)

    def _run(self, path):
        out = self.folder / f"{path.stem}.h5"
        command = [self.tremolo, "soiltest", path, "--out", out]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{path.name}: {done.stderr.strip() or done.stdout.strip()}")
        print(f"  {path.stem}", flush=True)
        return record.read(out)

    def calibrate(self, text, name):
        """What `tremolo calibrate` found: contraction_rate and the cycles that it gives."""
        path = PAGES / "tests" / f"{name}.toml"
        path.write_text(text)
        done = subprocess.run([self.tremolo, "calibrate", path], capture_output=True, text=True, check=True)
        print(f"  {name}", flush=True)
        rate = re.search(r"Found:\s+contraction_rate = ([\d.e+-]+)", done.stdout)
        cycles = re.search(r"([\d.e+-]+) cycles at that stress ratio", done.stdout)
        if rate is None or cycles is None:
            raise RuntimeError(f"{name}: tremolo calibrate said something else:\n{done.stdout}")
        return {"contraction_rate": float(rate[1]), "cycles": float(cycles[1])}

    def own(self, name):
        """The test of a reference curve, as its file under docs/materials/tests describes it."""
        return self.run_kept(tests.own_test(name, self.parameters(name)), name)

    def replay(self, name):
        """The test along the strains of a reference curve, whose last row may be there twice."""
        lines = (self.reference / f"{name}.csv").read_text().splitlines(keepends=True)
        steps = [line.split(",", 1)[0] for line in lines]
        path = self.folder / f"{name}.csv"
        path.write_text("".join(line for line, step, before in zip(lines, steps, ["", *steps]) if step != before))
        return self.run(tests.replay(name, self.parameters(name), path), name)

    def strength(self, name, stress_ratios, relative_density):
        """The cyclic strength curve of the soil of a reference curve."""
        text = tests.strength_test(name, self.parameters(name), stress_ratios, relative_density)
        return self.run_kept(text, f"{name.split('_ucdss')[0]}_strength")


def only(test):
    return test.histories["000"]


def save(test, name, references=(), labels=None, title=None, finish=None):
    """A picture of the page, in 256 colours so that the repository stays small; `finish` may add to the figure."""
    figure = drawing.draw(test, references, labels, title)
    if finish is not None:
        finish(figure)
    pixels = io.BytesIO()
    figure.savefig(pixels, dpi=DPI)
    style.plt.close(figure)
    picture = Image.open(pixels).convert("RGB").quantize(256, method=Image.Quantize.FASTOCTREE)
    picture.save(PAGES / "pictures" / f"gallery_{name}.png", optimize=True)


def together(several):
    """One test of the histories of several; the lines are those that reach furthest."""
    last = list(several.values())[-1]
    histories = {name: only(test) for name, test in several.items()}
    return record.SoilTest(last.path, last.about, histories, last.summary, lines=last.lines)


def label(test):
    return f"{test.about['vertical_stress'] / 1e3:.3g} kPa"


def write_between(page, section, text):
    """Replaces what stands between the markers of a section."""
    content = page.read_text(encoding="utf-8")
    begin, end = f"<!-- {section} -->\n", f"<!-- /{section} -->"
    if begin not in content or end not in content:
        raise ValueError(f"{page}: has no place for {section}: {begin.strip()} ... {end}")
    head, rest = content.split(begin, 1)
    page.write_text(f"{head}{begin}\n{text}\n\n{end}{rest.split(end, 1)[1]}", encoding="utf-8")
