"""The folder that `tremolo column --models` wrote: site.json, and a file of a free field for each model.

    site = Site("out")
    site.models["fe"].profile["peak_gxy"]          # at site.models["fe"].profile["y"], m
    site.models["fe"].run.monitor("surface")["ax"]
"""

import json
from pathlib import Path

from tremolo.run import Run

NAME = "site.json"


class Model:
    """A free field of the site: its tables by name (docs/output-format.md)."""

    def __init__(self, name, run, soil=""):
        self.name, self.soil, self.run = name, soil, run
        self.profile, self.spectra, self.transfer, self.measures = (
            run.table(name) for name in ("profile", "spectra", "transfer", "measures"))
        if None in (self.profile, self.spectra, self.transfer, self.measures):
            raise ValueError(f"{run.path}: lacks the tables of a free field, which `tremolo column` writes")
        self.strain_compatible = run.table("strain_compatible")
        self.warnings = (run.table("warnings") or {"text": []})["text"]

    def depth(self):
        """The depth of each level of the profile below the surface, m."""
        return self.profile["y"].max() - self.profile["y"]

    def places(self):
        """Names of the histories, from the surface down as asked for."""
        return list(self.run.table("levels")["name"])

    def measure(self, place, name):
        """An intensity measure, SI units."""
        return float(self.measures[name][list(self.measures["place"]).index(place)])


class Site:
    """A site under several models.

        site = Site("runs/site")                       # what `tremolo column --models` wrote
        site = Site.of_files(["fe.h5", "fine.h5"])     # what `tremolo column --model` wrote of one site
        site.facts["vs30"], site.layers["vs"]          # m/s
        site.models["fe"].profile["peak_gxy"]          # at site.models["fe"].depth(), m
        site.warnings()                                # [(model, sentence)]

    Raises OSError and ValueError for what is neither.
    """

    def __init__(self, folder):
        folder = Path(folder)
        content = json.loads((folder / NAME).read_text(encoding="utf-8"))
        self.title = content["title"]
        self.refused = {entry["model"]: entry["refused"] for entry in content["models"] if entry["refused"]}
        self.models = {entry["model"]: Model(entry["model"], Run(folder / entry["file"]), entry["soil"])
                       for entry in content["models"] if not entry["refused"]}
        if not self.models:
            raise ValueError(f"{folder}: no model could compute this site")

    @classmethod
    def of_files(cls, paths):
        """Files of free fields, each under its name without .h5; the whole path where two are alike."""
        site = cls.__new__(cls)
        names = [Path(path).stem for path in paths]
        names = names if len(set(names)) == len(names) else [str(path) for path in paths]
        site.models = {name: Model(name, Run(path)) for name, path in zip(names, paths)}
        site.title, site.refused = site.first.run.title, {}
        return site

    @property
    def first(self):
        """The model whose ground, outcrop and case stand for all."""
        return next(iter(self.models.values()))

    @property
    def direction(self):
        """"x" or "y", of the wave's own motion: horizontal of SV, vertical of P."""
        return "x" if self.first.run.attribute("wave") == "SV" else "y"

    @property
    def layers(self):
        """From the surface down, the half-space last: name -> column, SI units."""
        return self.first.run.table("layers")

    @property
    def facts(self):
        """Vs30, periods and impedance: name -> number, SI units."""
        return {name: float(values[0]) for name, values in self.first.run.table("site").items()}

    @property
    def has_outcrop(self):
        """Whether the motion of the bare outcrop is known."""
        return "outcrop" in self.first.spectra

    def warnings(self):
        """(model, sentence) of each."""
        return [(model.name, text) for model in self.models.values() for text in model.warnings]
