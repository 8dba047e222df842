#!/usr/bin/env python3
"""Picture of how much the crest of a step amplifies, by the domain and without cells (step_case.py, half_space_uneven.py).

    tests/system/canyon/plot_step.py TREMOLO FOLDER PICTURE.png      runs of FOLDER are made unless they stand there
"""

import subprocess
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[3] / "python"), str(Path(__file__).parent)]

import numpy as np
from elastic_ground import GROUND
from half_space_uneven import UnevenGround
from step_case import PLACES, TRENCH_ENDS, amplification, frequency, response, starts, trench, write
from tremolo import Run, style

SCENES = ((0, "right", "0°"), (15, "right", "15°, towards the lower ground"), (15, "left", "15°, towards the upper ground"))
SHOWN = PLACES.index(-5.0)


def main():
    tremolo, folder, picture = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    figure, ax = style.plt.subplots(figsize=(6.4, 3.6), layout="constrained")
    for (angle, falling, label), colour in zip(SCENES, style.COLOURS):
        name = f"{angle}_{falling}"
        if not (folder / name / "run.h5").exists():
            subprocess.run([tremolo, "run", write(folder / f"{name}.toml", angle, falling, 1.0), "--out", folder / name], check=True)
        run = Run(folder / name)
        series = [run.monitor(f"place {i}") for i in range(len(PLACES))]
        place = starts(series)[SHOWN : SHOWN + 1]
        ground = UnevenGround(GROUND, trench(falling), 1.25, TRENCH_ENDS[falling])
        shares = np.arange(0.04, 0.42, 0.02)
        exact = [amplification(angle, h, place, ground.transfer(frequency(h), np.radians([angle]), place)[0][0])[0] for h in shares]
        ax.plot(shares, exact, color=colour, linewidth=1.0, label=label)
        found = [amplification(angle, h, place, response(series[SHOWN : SHOWN + 1], h))[0] for h in shares]
        ax.plot(shares, found, "o", color=colour, markersize=3)
    ax.axvline(0.2, color="0.6", linewidth=0.8, zorder=0)
    ax.set(xlabel="height over the length of shear waves, H/λ", ylabel="horizontal motion at the crest\nover that of level ground")
    ax.legend()
    print(style.save(figure, picture.parent, picture.name))


if __name__ == "__main__":
    main()
