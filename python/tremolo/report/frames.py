"""Frames of a field as small images: particles as squares on a grid of pixels, structures above them.

All frames of all runs have the same bounds and the same scale. A pixel is an index of a palette: COLOURS steps of the colour
scale, then the colours of structures and of nothing at all.
"""

import base64
import io

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex, to_rgb
from PIL import Image, ImageDraw

from tremolo import bodies, style
from tremolo.pictures import maps

WIDTH = 960  # pixels
COLOURS = 64
BODY, EDGE, NOTHING = COLOURS, COLOURS + 1, COLOURS + 2
MOST_FRAMES = 81
# Bytes of the images of all fields and runs. base64 takes a third more; with Plotly and charts a report is below 15 MB.
MOST_BYTES = 7_000_000


def _along_x(values):
    return values[:, 0]


def _size(values):
    return np.hypot(values[:, 0], values[:, 1])


class Field:
    """A field of the run file, and how it is shown."""

    def __init__(self, name, label, unit, scalar, diverging=False, fixed=None):
        self.name, self.label, self.unit, self.scalar = name, label, unit, scalar
        self.colours = style.DIVERGING if diverging else style.SEQUENTIAL
        self.diverging, self.fixed = diverging, fixed

    def values(self, run, index):
        return self.scalar(run.field(index, self.name))

    def limits(self, runs, indices):
        """Lowest and highest value of the colours, for all runs and frames."""
        if self.fixed:
            return self.fixed
        top = maps.symmetric_limit([self.values(run, i) for run, own in zip(runs, indices) for i in own])
        return (-top if self.diverging else 0.0), top


FIELDS = [
    Field("acceleration", "horizontal acceleration", "m/s²", _along_x, diverging=True),
    Field("displacement", "size of the displacement", "m", _size),
    Field("equivalent_plastic_strain", "equivalent plastic strain", "1", np.asarray),
    Field("pore_pressure_ratio", "pore pressure ratio r_u", "1", np.asarray, fixed=(0.0, 1.0)),
]


def scale(colours):
    """The colour scale as Plotly takes it, in the steps of the images."""
    steps = colormaps[colours](np.linspace(0.0, 1.0, COLOURS))
    return [[i / (COLOURS - 1), to_hex(step)] for i, step in enumerate(steps)]


def _palette(colours):
    steps = [*colormaps[colours](np.linspace(0.0, 1.0, COLOURS))[:, :3], to_rgb(bodies.FILL["facecolor"])]
    steps += [to_rgb(bodies.FILL["edgecolor"]), (1.0, 1.0, 1.0)]
    return (255 * np.array(steps)).round().astype(np.uint8)


def raster(position, size, level, bounds, shape):
    """Palette indices [rows, columns], the uppermost row first.

    position: [particles, 2], m; size: side of the squares, m, one of all or one each; level: [particles], palette index of each;
    bounds: xmin, ymin, xmax, ymax, m; shape: rows and columns.
    """
    rows, columns = shape
    pixels = np.full(shape, NOTHING, dtype=np.uint8)
    scale = np.array([columns / (bounds[2] - bounds[0]), rows / (bounds[3] - bounds[1])])
    # As on pictures, squares overlap a little: the particles of stretched soil leave no gaps.
    half = np.broadcast_to(0.625 * np.asarray(size, dtype=float).reshape(-1, 1), (len(position), 1))
    first = np.floor((position - half - bounds[:2]) * scale).astype(int)
    last = np.maximum(np.floor((position + half - bounds[:2]) * scale).astype(int), first + 1)
    widest, highest = (last - first).max(axis=0)
    if widest * highest > len(position):  # few large squares: one after the other
        low, high = np.clip(first, 0, (columns, rows)), np.clip(last, 0, (columns, rows))
        for (left, bottom), (right, top), colour in zip(low, high, np.broadcast_to(level, len(position))):
            pixels[rows - top : rows - bottom, left:right] = colour
        return pixels
    for dx in range(widest):
        for dy in range(highest):
            x, y = first[:, 0] + dx, first[:, 1] + dy
            inside = (x < last[:, 0]) & (y < last[:, 1]) & (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
            pixels[rows - 1 - y[inside], x[inside]] = level[inside]
    return pixels


def levels(values, low, high):
    """Palette index of values; those beyond the scale have its end's colour."""
    return np.clip(np.round((values - low) / (high - low) * (COLOURS - 1)), 0, COLOURS - 1).astype(np.uint8)


def _draw_bodies(image, run, time, bounds):
    """Structures and linings where they are; through their holes one sees the ground."""
    ground = image.copy()
    draw = ImageDraw.Draw(image)
    scale = np.array([image.width / (bounds[2] - bounds[0]), -image.height / (bounds[3] - bounds[1])])
    origin = np.array([bounds[0], bounds[3]])
    rings = [run.body(name).corners(time) for name in run.bodies] + [run.lining(name).faces(time) for name in run.linings]
    for pair in rings:
        outline, hole = (ring if ring is None else [tuple(p) for p in (ring - origin) * scale] for ring in pair)
        draw.polygon(outline, fill=BODY, outline=EDGE)
        if hole is not None:
            mask = Image.new("1", image.size)
            ImageDraw.Draw(mask).polygon(hole, fill=1)
            image.paste(ground, mask=mask)
            draw.polygon(hole, outline=EDGE)


def encoded(image, colours):
    """Bytes of a lossless WebP of palette indices."""
    image.putpalette(_palette(colours).tobytes())
    image.info["transparency"] = NOTHING
    stream = io.BytesIO()
    image.convert("RGBA").save(stream, "WEBP", lossless=True, method=2, quality=30)
    return stream.getvalue()


def uri(content, kind="image/webp"):
    return f"data:{kind};base64," + base64.b64encode(content).decode("ascii")


def same_particles(runs):
    """Whether two runs begin with the same particles, and keep them."""
    if len(runs) != 2:
        return False
    one, other = (run.field(0, "position") for run in runs)
    last = {len(run.field(len(run.times) - 1, "position")) for run in runs}
    return one.shape == other.shape and last == {len(one)} and np.allclose(one, other, atol=1e-9)


class Panel:
    """The images of a run, or of the difference of two."""

    def __init__(self, title, low, high, colours, images):
        self.title, self.low, self.high, self.colours, self.images = title, low, high, colours, images

    def thin(self):
        self.images = self.images[::2]


class Player:
    """Images of all fields that all runs have, at the same times."""

    def __init__(self, runs, titles):
        self.runs, self.titles = runs, titles
        end = min(run.times[-1] for run in runs)
        times = runs[0].times[runs[0].times <= end * (1 + 1e-9)]
        times = times if len(times) else runs[0].times[:1]
        every = -(-len(times) // MOST_FRAMES)
        self.times = times[::every]
        self.indices = [[run.nearest_frame(time) for time in self.times] for run in runs]
        bounds = [style.extent(run, sorted({own[0], own[len(own) // 2], own[-1]})) for run, own in zip(runs, self.indices)]
        self.bounds = [*np.min([b[:2] for b in bounds], axis=0), *np.max([b[2:] for b in bounds], axis=0)]
        self.shape = (max(int(WIDTH * style.aspect_of(self.bounds)), 1), WIDTH)
        self.fields = [(field, self._panels(field)) for field in FIELDS if all(run.has_field(field.name) for run in runs)]
        while len(self.times) > 2 and self._bytes() > MOST_BYTES:
            self.times = self.times[::2]
            for _, panels in self.fields:
                for panel in panels:
                    panel.thin()

    def start(self):
        """Index of the frame that a reader sees first: one in the middle of the shaking."""
        run = self.runs[0]
        times = maps.telling_times(run) if run.has_field("acceleration") else run.times
        return int(np.argmin(np.abs(self.times - times[len(times) // 2])))

    def _bytes(self):
        return sum(len(image) for _, panels in self.fields for panel in panels for image in panel.images)

    def _image(self, run, index, values, low, high, colours):
        pixels = raster(run.field(index, "position"), style.sizes(run, index), levels(values, low, high), self.bounds, self.shape)
        image = Image.fromarray(pixels)
        _draw_bodies(image, run, run.times[index], self.bounds)
        return encoded(image, colours)

    def _panels(self, field):
        low, high = field.limits(self.runs, self.indices)
        panels = []
        for run, title, own in zip(self.runs, self.titles, self.indices):
            images = [self._image(run, i, field.values(run, i), low, high, field.colours) for i in own]
            panels.append(Panel(title, low, high, field.colours, images))
        if same_particles(self.runs):
            panels.append(self._difference(field))
        return panels

    def _difference(self, field):
        first, second = self.runs
        gaps = [field.values(second, j) - field.values(first, i) for i, j in zip(*self.indices)]
        top = maps.symmetric_limit(gaps)
        images = [self._image(first, i, gap, -top, top, style.DIVERGING) for i, gap in zip(self.indices[0], gaps)]
        return Panel(f"{self.titles[1]} less {self.titles[0]}", -top, top, style.DIVERGING, images)

    def content(self):
        """What the page's player reads."""
        return {
            "times": [round(float(time), 4) for time in self.times],
            "start": self.start(),
            "bounds": [float(edge) for edge in self.bounds],
            "fields": [
                {
                    "name": field.name, "label": field.label, "unit": field.unit,
                    "panels": [
                        {"title": panel.title, "low": panel.low, "high": panel.high, "scale": scale(panel.colours),
                         "images": [uri(image) for image in panel.images]}
                        for panel in panels
                    ],
                }
                for field, panels in self.fields
            ],
        }
