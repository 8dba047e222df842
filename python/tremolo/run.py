"""A run as numpy arrays: `run.h5` (docs/output-format.md), or what `tremolo column` wrote, which has the same form.

    from tremolo import Run

    run = Run("out")                      # the folder, or run.h5 itself, or OUT.h5 of `tremolo column`
    print(run)                            # what there is
    run.times                             # s, of the particle frames; none in a free field alone
    run.frame(10)["velocity"]             # [particles, 2], m/s
    run.monitor("toe")["ax"]              # m/s2 at run.monitor("toe").time
    run.line("shaft").values("gxy")       # [times, points], at run.line("shaft").coordinates
    run.body("tunnel")["water_y"]         # N/m at run.body("tunnel").time
    run.lining("ring").moment             # [times, elements], N, at run.lining("ring").time
    run.section("foot")["m"]              # N, at run.section("foot").time
    run.prop("strut").force               # N/m, tension positive
    run.table("profile")["peak_gxy"]      # of a free field alone, at run.table("profile")["y"]

All values are SI units; tension is positive; x points right, y up. `Series` says what one can do with a history.
"""

import contextlib
import json
import operator
from pathlib import Path

import h5py
import numpy as np

from tremolo import links
from tremolo.contact_stress import ContactStress
from tremolo.lining import Lining
from tremolo.prop import Prop
from tremolo.section import Section
from tremolo.series import Series, text

SCHEMA_MAJOR = "1"


class DamagedRun(ValueError):
    """A run file that cannot be read as what it should hold; says which part of which file."""


class Fields(dict):
    """The fields of a frame by name."""

    def __missing__(self, name):
        raise KeyError(f"no field '{name}'; the frame has {', '.join(self) or 'none'}")


class LinePoint(Series):
    """A point of a line, as a series of its own."""

    def __init__(self, line, number):
        own = [name for name in line.columns if name == "time" or name == name.rstrip("0123456789") + str(number)]
        columns = [name.rstrip("0123456789") for name in own]
        self._fill(columns, {column: line.units[name] for column, name in zip(columns, own)},
                   line._rows[:, [line.columns.index(name) for name in own]])


class Line(list):
    """The points of a line from one end to the other, each a series; and columns of all of them with their coordinates.

        shaft = run.line("shaft")
        shaft[3]["gxy"]                     # of the fourth point
        shaft.values("gxy")                 # [times, points]
        shaft.coordinates                   # {"time": [times], "distance": [points], "x": [points], "y": [points]}
        np.abs(shaft.values("gxy")).max(axis=0)    # the profile of peaks, at shaft.coordinates["y"]
    """

    @property
    def coordinates(self):
        """time (s); distance along the line from its first point, and place before the shaking (m)."""
        if not self or not len(self[0]):
            return {name: np.zeros(0) for name in ("time", "distance", "x", "y")}
        x, y = (np.array([point[c][0] - point["u" + c][0] for point in self]) for c in "xy")
        return {"time": self[0].time, "distance": np.hypot(x - x[0], y - y[0]), "x": x, "y": y}

    def values(self, column):
        """A column of all points, [times, points]."""
        return np.column_stack([point[column] for point in self])


def points_of(line):
    """The points of a line's series, whose columns are x0, y0, ..., x1, y1, ..."""
    count = sum(name.rstrip("0123456789") == "ux" for name in line.columns)
    return Line(LinePoint(line, number) for number in range(count))


class SlidingMass(Series):
    """Means over the soil within an outline: time, mass (kg/m), x, y, ux, uy, vx, vy, ax, ay.

    The attribute `outline` [corners, 2] is that at the start, m.
    """

    def __init__(self, dataset):
        super().__init__(dataset)
        self.outline = np.reshape(dataset.attrs["outline"], (-1, 2))


class Body(Series):
    """What became of a [[structure]]: motion of its centre of mass and the forces on it, and its outline at any time.

    The attributes: `outline` and `hole` [corners, 2] at the start (m; `hole` is None where there is none), `mass` (kg/m),
    `inertia` (kg m). An elastic structure has its bent outline at the times of frames.
    """

    def __init__(self, dataset, bent=None):
        super().__init__(dataset)
        self._bent = None if bent is None else Series(bent)
        self.outline = np.reshape(dataset.attrs["outline"], (-1, 2))
        self.hole = np.reshape(dataset.attrs["hole"], (-1, 2)) if "hole" in dataset.attrs else None
        self.mass = float(dataset.attrs["mass"])
        self.inertia = float(dataset.attrs["inertia"])

    def place(self, time):
        """x, y (m) of the centre of mass and tilt (rad, counter-clockwise) at a time (s)."""
        return tuple(float(np.interp(time, self["time"], self[column])) for column in ("x", "y", "tilt"))

    def corners(self, time):
        """Outline and hole at a time (s). Those of an elastic structure have more points than at the start."""
        if self._bent:
            return self._bent_rings(time)
        if len(self) == 0:
            return self.outline, self.hole
        x, y, tilt = self.place(time)
        # Before the first row it has not moved by more than rounding shows.
        start = np.array([self["x"][0], self["y"][0]])
        turn = np.array([[np.cos(tilt), np.sin(tilt)], [-np.sin(tilt), np.cos(tilt)]])

        def moved(polygon):
            return None if polygon is None else (polygon - start) @ turn + [x, y]

        return moved(self.outline), moved(self.hole)

    def _bent_rings(self, time):
        """Outline and hole from the points of the frames before and after a time."""
        def ring(of):
            columns = [name for name in self._bent.columns if name.rstrip("0123456789") in (f"{of}x", f"{of}y")]
            points = [np.interp(time, self._bent["time"], self._bent[name]) for name in columns]
            return np.reshape(points, (-1, 2)) if points else None

        return ring(""), ring("hole_")


class Run:
    """One run, complete or not, or one free field alone.

        with Run("out") as run:
            crest = run.monitor("crest")
            crest["ax"].max(), crest.units["ax"]
            last = run.frame(-1)
            last["position"][last["equivalent_plastic_strain"] > 0.1]      # m, where soil has failed
            run.nearest_frame(9.3)                                         # the number of a frame by its time (s)

    Names: `monitors`, `lines`, `sliding_masses`, `bodies`, `linings`, `props`, `sections`. What a run does not have is None, an empty list, or a KeyError that
    names what there is.
    """

    def __init__(self, path):
        path = Path(path)
        self.path = path / "run.h5" if path.is_dir() else path
        if not self.path.exists():
            raise FileNotFoundError(f"{self.path}: no such run")
        if not self.path.is_file():  # opening a pipe would wait for its other end
            raise OSError(f"{self.path}: not a regular file")
        try:
            self._file = h5py.File(self.path, "r")
        except OSError as error:
            raise OSError(f"{self.path}: cannot be read as HDF5: {error}") from error
        version = str(self.attribute("schema_version", "none"))
        if version.split(".")[0] != SCHEMA_MAJOR:
            raise ValueError(f"{self.path}: schema version {version}, this package reads {SCHEMA_MAJOR}.x")
        with self._reading("the frames"):
            self._frames = sorted(links.names(self._file["frames"]), key=int)
            self.times = np.array([float(self._file["frames"][name].attrs["time"]) for name in self._frames])

    @contextlib.contextmanager
    def _reading(self, what):
        """What h5py and numpy say of a damaged file, in many kinds of exceptions, becomes one that names file and part."""
        try:
            yield
        except (OSError, RuntimeError, LookupError, ValueError, TypeError, AttributeError, MemoryError) as error:
            raise DamagedRun(f"{self.path}: cannot read {what}, the file is damaged or is being written: {error}") from error

    def close(self):
        """Closes the file; `with Run(...) as run` does so at its end."""
        self._file.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __repr__(self):
        frames = f"{len(self.times)} frames, {self.times[0]:g} to {self.times[-1]:g} s" if len(self.times) else "no frames"
        named = ((kind, getattr(self, kind)) for kind in ("monitors", "lines", "sliding_masses", "bodies", "linings", "props", "sections"))
        held = "".join(f"; {kind.replace('_', ' ')}: {', '.join(names)}" for kind, names in named if names)
        return f"<Run {self.path}: '{self.title}', {self.status}; {frames}{held}>"

    def attribute(self, name, default=None):
        """An attribute of the root, e.g. mesh_size (m), angle_deg, box, soil_names."""
        with self._reading(f"the attribute {name}"):
            return text(self._file.attrs[name]) if name in self._file.attrs else default

    @property
    def title(self):
        """The title of the case."""
        return self.attribute("title", "")

    @property
    def name(self):
        """What tells it from others: the name of the folder of a run.h5, that of another file without .h5."""
        path = self.path.resolve()
        return path.parent.name if path.name == "run.h5" else path.stem

    @property
    def status(self):
        """'running', 'complete' or 'aborted: reason'."""
        return self.attribute("status")

    @property
    def case(self):
        """The text of the case file."""
        with self._reading("the case"):
            return text(self._file["case"][()])

    @property
    def plan(self):
        """The plan of effects: what `tremolo explain --json` calls `plan`; empty where the run holds none."""
        with self._reading("the plan"):
            return json.loads(text(self._file["plan"][()])) if "plan" in self._file else {}

    def _frame_name(self, index):
        """The name of a frame in the file. Raises TypeError and IndexError that say which frames there are."""
        count = len(self._frames)
        there = f"the run has {count} frames, 0 to {count - 1}" if count else "the run has no frame yet"
        try:
            index = operator.index(index)
        except TypeError:
            raise TypeError(f"{self.path}: frame {index!r} is no whole number; {there}; nearest_frame(time) finds one by its time") from None
        if not -count <= index < count:
            raise IndexError(f"{self.path}: no frame {index}; {there}")
        return self._frames[index]

    def frame(self, index):
        """Fields of one frame: name -> array [particles] or [particles, components]. Frame -1 is the last one."""
        name = self._frame_name(index)
        with self._reading(f"frame {index}"):
            frame = self._file["frames"][name]
            return Fields({field: frame[field][()] for field in links.names(frame)})

    def field(self, index, name):
        """One field of one frame."""
        frame_name = self._frame_name(index)
        with self._reading(f"frame {index}"):
            frame = self._file["frames"][frame_name]
            names = links.names(frame)
        if name not in names:
            raise KeyError(f"{self.path}: no field '{name}' in frame {index}; it has {', '.join(names) or 'none'}")
        with self._reading(f"{name} of frame {index}"):
            return frame[name][()]

    def has_field(self, name):
        """Whether the frames hold a field."""
        with self._reading("frame 0"):
            return bool(self._frames) and name in self._file["frames"][self._frames[0]]

    def nearest_frame(self, time):
        """Index of the frame nearest to a time (s)."""
        return int(np.argmin(np.abs(self.times - time)))

    @property
    def monitors(self):
        """Names of the monitors."""
        with self._reading("the monitors"):
            return links.names(self._file["monitors"])

    def monitor(self, name):
        """Series of a monitor: time, x, y, ux, uy, vx, vy, ax, ay; in soil also stress and strain (docs/output-format.md)."""
        if name not in self.monitors:
            raise KeyError(f"{self.path}: no monitor '{name}'; it has {', '.join(self.monitors) or 'none'}")
        with self._reading(f"the monitor {name}"):
            return Series(self._file["monitors"][name])

    @property
    def lines(self):
        """Names of the lines of points."""
        with self._reading("the lines"):
            return links.names(self._file["lines"]) if "lines" in self._file else []

    def line(self, name):
        """The points of a line from one end to the other, each with the columns of a monitor."""
        if name not in self.lines:
            raise KeyError(f"{self.path}: no line '{name}'; it has {', '.join(self.lines) or 'none'}")
        with self._reading(f"the line {name}"):
            return points_of(Series(self._file["lines"][name]))

    @property
    def sliding_masses(self):
        """Names of the sliding masses."""
        with self._reading("the sliding masses"):
            return links.names(self._file["sliding_masses"]) if "sliding_masses" in self._file else []

    def sliding_mass(self, name):
        """Series of a sliding mass."""
        if name not in self.sliding_masses:
            raise KeyError(f"{self.path}: no sliding mass '{name}'; it has {', '.join(self.sliding_masses) or 'none'}")
        with self._reading(f"the sliding mass {name}"):
            return SlidingMass(self._file["sliding_masses"][name])

    @property
    def shaking_table(self):
        """Motion of the shaking table: ux, uy, vx, vy, ax, ay over time; None where the base of the run lies on ground."""
        with self._reading("the shaking table"):
            return Series(self._file["shaking_table"]) if "shaking_table" in self._file else None

    @property
    def bodies(self):
        """Names of the structures, in the order of the case; those of `body` in contact()."""
        with self._reading("the bodies"):
            return list(self.attribute("structure_names", []))

    def body(self, name):
        """Motion, forces and outline of a structure."""
        if name not in self.bodies:
            raise KeyError(f"{self.path}: no body '{name}'; it has {', '.join(self.bodies) or 'none'}")
        with self._reading(f"the body {name}"):
            bent = self._file["outlines"] if "outlines" in self._file else {}
            return Body(self._file["bodies"][name], bent[name] if name in bent else None)

    @property
    def linings(self):
        """Names of the linings, in the order of the case."""
        with self._reading("the linings"):
            return list(self.attribute("lining_names", []))

    def lining(self, name):
        """Section forces and places of a lining, and what soil presses on it."""
        if name not in self.linings:
            raise KeyError(f"{self.path}: no lining '{name}'; it has {', '.join(self.linings) or 'none'}")
        with self._reading(f"the lining {name}"):
            return Lining(self._file["linings"][name])

    @property
    def props(self):
        """Names of the props that stand while the ground is shaken, in the order of the case."""
        with self._reading("the props"):
            return list(self.attribute("prop_names", []))

    def prop(self, name):
        """The force in a prop, and the places of its ends."""
        if name not in self.props:
            raise KeyError(f"{self.path}: no prop '{name}'; it has {', '.join(self.props) or 'none'}")
        with self._reading(f"the prop {name}"):
            return Prop(self._file["props"][name])

    @property
    def sections(self):
        """Names of the sections, in the order of the case."""
        with self._reading("the sections"):
            return list(self.attribute("section_names", []))

    def section(self, name):
        """Section forces of a cut through a structure, or of a ring of cuts."""
        if name not in self.sections:
            raise KeyError(f"{self.path}: no section '{name}'; it has {', '.join(self.sections) or 'none'}")
        with self._reading(f"the section {name}"):
            return Section(self._file["sections"][name])

    def contact(self, index):
        """Contact nodes of one frame: name -> array; None where the run has no structures.

        position [nodes, 2] (m), normal [nodes, 2] from soil to body, body (index into `bodies`), area (m), and the forces on
        the body in N/m: normal_force (of effective stress) and water_force (of excess pore pressure) along the normal n,
        friction_force along (-n_y, n_x).
        """
        return self._part("contact", index, f"the contact nodes of frame {index}")

    def _part(self, group, index, what):
        """What stands beside the soil's particles of a frame; None where the run has no such thing."""
        name = self._frame_name(index)
        with self._reading(what):
            if group not in self._file:
                return None
            points = self._file[group][name]
            return Fields({field: points[field][()] for field in links.names(points)})

    def contact_stress(self, name):
        """Pressure and shear on the surface of a structure in each frame."""
        self.body(name)  # refuses a name that is not there
        with self._reading(f"the contact nodes of {name}"):
            return ContactStress(self, name)

    def structures(self, index):
        """Particles of elastic structures in one frame: name -> array; None where the run has none.

        position [particles, 2] (m), body (index into `bodies`), size (m, of a particle's side), and what the case asks for of
        displacement [particles, 2] (m) and stress [particles, 4] (xx, yy, zz, xy in Pa; below a water table that beyond the
        pressure of water at rest).
        """
        return self._part("structures", index, f"the structures of frame {index}")

    @property
    def energy(self):
        """The energy ledger, J per metre of thickness; None where the run has none."""
        with self._reading("the energy"):
            return Series(self._file["energy"]) if "energy" in self._file else None

    @property
    def boundary(self):
        """Boundary exchange: name -> array (faces and [times, faces, 2]); None where the run has none."""
        with self._reading("the boundary"):
            if "boundary" not in self._file:
                return None
            group = self._file["boundary"]
            arrays = {name: group[name][()] for name in links.names(group)}
            whole = int(np.count_nonzero(~np.isnan(arrays["time"])))
            for name in ("time", "free_field_velocity", "domain_velocity", "traction"):
                arrays[name] = arrays[name][:whole]
            arrays["source"] = text(group.attrs["source"])
            return arrays

    def table(self, name):
        """A table, e.g. 'timings': column -> list or array; None where the run has none."""
        with self._reading(f"the table {name}"):
            if name not in self._file:
                return None
            group = self._file[name]
            return {column: text(group[column][()]) for column in text(group.attrs["columns"])}

    def table_units(self, name):
        """The unit of each column of a table."""
        with self._reading(f"the units of the table {name}"):
            group = self._file[name]
            return {column: text(group[column].attrs["unit"]) for column in text(group.attrs["columns"])}
