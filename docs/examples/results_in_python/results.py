# %% [markdown]
# Results in Python, cell by cell: a site under several models, then a run. Jupyter and VS Code show each `# %%` as a cell; as a
# program it prints the same and draws two pictures.
#
#     tremolo column site/case.toml --models eql,fe,wave --out runs/site
#     tremolo run my_slope/case.toml --out runs/my_slope
#     python3 docs/examples/results_in_python/results.py runs/site runs/my_slope
#
# PYTHONPATH is python/ of the source, or share/tremolo/python of an installation.

# %%
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # leave it out in a notebook

import matplotlib.pyplot as plt
import numpy as np

from tremolo import Run, Site

site_folder, run_folder = sys.argv[1:3]

# %% What is there: a site, its models, a file of each
site = Site(site_folder)
print(site.title, "under", ", ".join(site.models))
print(f"Vs30 = {site.facts['vs30']:.0f} m/s, T0 = {site.facts['period']:.2f} s")
for model, warning in site.warnings():
    print(f"{model}: {warning}")

# %% A free field is a run without particles: histories are found by their place
first = site.first.run
print(first)
surface = first.monitor("surface")
print(f"{first.name}: PGA = {np.abs(surface['ax']).max():.2f} {surface.units['ax']}")

# %% A part of a history, and all of it as a pandas DataFrame where pandas is installed
strong = surface.between(0.3 * surface.time[-1], 0.6 * surface.time[-1])
print(f"{len(strong)} of {len(surface)} rows; largest velocity there {np.abs(strong['vx']).max():.3g} m/s")
try:
    print(surface.to_frame().describe())
except ImportError as missing:
    print(missing)

# %% Profiles of peaks, a line a model
figure, ax = plt.subplots(figsize=(3.2, 4.0), layout="constrained")
for name, model in site.models.items():
    ax.plot(100.0 * model.profile["peak_gxy"], model.depth(), label=name)
ax.set(xlabel="largest shear strain (%)", ylabel="depth (m)", xlim=(0.0, None))
ax.invert_yaxis()
ax.legend()
figure.savefig(Path(site_folder) / "strain.png", dpi=120)

# %% A run: frames of particles, histories of monitors
run = Run(run_folder)
print(run)
last = run.frame(-1)
print(f"{len(last['position'])} particles, the fastest at the end with {np.linalg.norm(last['velocity'], axis=1).max():.3g} m/s")

# %% Points of the soil by their place, a field by its time
index = run.nearest_frame(0.5 * run.times[-1])
position, velocity = run.field(index, "position"), run.field(index, "velocity")
figure, ax = plt.subplots(figsize=(6.4, 3.0), layout="constrained")
shown = ax.scatter(*position.T, c=velocity[:, 0], s=1.0, cmap="RdBu_r")
ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal", title=f"t = {run.times[index]:.2f} s")
figure.colorbar(shown, label="horizontal velocity (m/s)")
figure.savefig(Path(run_folder) / "velocity.png", dpi=120)

# %% Lines have coordinates: profiles over depth and time
for name in run.lines:
    line = run.line(name)
    peaks = np.abs(line.values("gxy")).max(axis=0)
    deepest = int(np.argmax(peaks))
    print(f"line {name}: largest shear strain {peaks[deepest]:.3g} at y = {line.coordinates['y'][deepest]:.2f} m")
