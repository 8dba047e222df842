"""CPU time of a step of the domain against the number of its particles, next to a line of slope one.

    usage: plot_cost.py JSON PNG        the JSON is what cost_domain_step --benchmark_format=json prints
"""

import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def read(table):
    """Particles and the least CPU time of a step (ms)."""
    least = {}
    with open(table) as file:
        for run in json.load(file)["benchmarks"]:
            name, *arguments = run["name"].split("/")
            if [name, *arguments[:1]] == ["particles", "usl_flip"] and run["run_type"] == "iteration":
                number = arguments[1]
                seconds = float(run["cpu_time"]) * 1e-9
                least[int(number)] = min(seconds, least.get(int(number), seconds))
    return sorted(least), [1e3 * least[number] for number in sorted(least)]


def main(table, picture):
    particles, ms = read(table)
    figure, axes = plt.subplots(figsize=(5.0, 4.0), layout="constrained")
    axes.plot(particles, [ms[0] * number / particles[0] for number in particles], "k--", linewidth=0.8, label="slope 1")
    axes.plot(particles, ms, "o-", label="a step: usl, FLIP, elastic")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="CPU time (ms)")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:])
