"""The section of the gallery on what an update of each law costs."""

import json
import subprocess
from pathlib import Path

import gallery_rows as rows
import numpy as np
from gallery_runs import PAGES, write_between

# Law, benchmark program, its entries for one point and for 100,000 points at a shear strain increment of 1e-6.
TIMED = (
    ("`linear_elastic`", "materials_laws", "yielding/linear_elastic/1/-6", "yielding/linear_elastic/100000/-6"),
    ("`mohr_coulomb`", "materials_laws", "yielding/mohr_coulomb/1/-6", "yielding/mohr_coulomb/100000/-6"),
    ("`mohr_coulomb`, softening", "materials_laws", "yielding/mohr_coulomb_softening/1/-6",
     "yielding/mohr_coulomb_softening/100000/-6"),
    ("`drucker_prager`", "materials_laws", "yielding/drucker_prager/1/-6", "yielding/drucker_prager/100000/-6"),
    ("`multi_yield_clay`, 20 surfaces", "materials_laws", "yielding/clay_20/1/-6", "yielding/clay_20/100000/-6"),
    ("`mkz`, 32 elements, in the domain", "materials_laws", "yielding/iwan_32/1/-6", "yielding/iwan_32/100000/-6"),
    ("`pdmy03`", "pdmy03", "alone/-6/50", "hundred_thousand/-6/50"),
    ("`pm4sand`", "pm4sand", "alone/1e_6", "many/1e_6"),
)
BY_INCREMENT = (
    ("`pdmy03`", "pdmy03", [*(f"alone/-{n}/50" for n in (7, 6, 5, 4)), "alone/-3/1000"]),
    ("`pm4sand`", "pm4sand", [f"alone/1e_{n}" for n in (7, 6, 5, 4, 3)]),
)


def benchmark(gallery, program, names):
    """Counters of the entries of a benchmark program, by name."""
    pattern = f"^({'|'.join(names)})(/min_time.*|/iterations.*)?$"
    path = gallery.tremolo.parent / "cost" / f"cost_{program}"
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such benchmark; build it, or leave the section cost out with --only")
    options = [f"--benchmark_filter={pattern}", "--benchmark_format=json"]
    done = subprocess.run([path, *options], capture_output=True, text=True, check=True)
    runs = json.loads(done.stdout)["benchmarks"]
    return {run["name"].split("/min_time")[0].split("/iterations")[0]: run for run in runs}


def nanoseconds(run):
    return 1e9 * run["time_per_update"]


def processor():
    lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "this machine")


def benchmarks(timed):
    """Entries to run, by program."""
    programs = {program: [] for _, program, *_ in timed}
    for _, program, *names in timed:
        programs[program] += names
    return programs


def cost_table(runs):
    body = []
    cheapest = nanoseconds(runs["materials_laws"][TIMED[0][3]])
    for law, program, alone, many in TIMED:
        run = runs[program][many]
        state = run.get("state_bytes", run.get("bytes_of_state", np.nan))
        times = nanoseconds(runs[program][alone]), nanoseconds(run)
        body.append([law, *(f"{t:.3g}" for t in times), f"{times[1] / cheapest:.3g}", rows.number(state)])
    head = ["law", "one point (ns)", "of 100,000 points, each (ns)", "over `linear_elastic`", "state (bytes)"]
    return rows.table(head, body)


def cost(gallery):
    """What an update costs; the overview of the laws has the first table, too."""
    wanted = [*TIMED, *((law, program, *names) for law, program, names in BY_INCREMENT)]
    runs = {program: benchmark(gallery, program, names) for program, names in benchmarks(wanted).items()}
    spread = [
        [law, *(f"{nanoseconds(runs[program][name]):.0f}" for name in names)] for law, program, names in BY_INCREMENT
    ]
    increments = ["one point (ns), increment", *(f"1e-{n}" for n in (7, 6, 5, 4, 3))]
    write_between(PAGES / "README.md", "laws", cost_table(runs))
    machine = f"CPU time of one update on one core of {processor()}, shear strain increment 1e-6:"
    return "\n\n".join((machine, cost_table(runs), rows.table(increments, spread)))
