"""Pictures and tables of a sweep whose runs are site responses: spectra, amplification and profiles of the runs that differ in motion
and random profile alone, with median and standard deviation."""

from tremolo import outputs, style
from tremolo.site import suite_pictures, suite_tables
from tremolo.site.suite import Response
from tremolo.site.suite_pictures import Family
from tremolo.sweep.plan import in_words

MODEL_KEY = "model"


def _name(sweep, group):
    """"eql, motion.scale = 2": what tells a group from the others."""
    settings = [(sweep.colour_key, group.colour)] if sweep.colour_key else []
    return ", ".join(in_words(value) if key == MODEL_KEY else f"{key} = {in_words(value)}" for key, value in [*settings, *group.rest])


def families(sweep):
    """A family a group, as many as there are colours; otherwise one a colour."""
    groups = sweep.groups()
    if len(groups) <= len(style.COLOURS):
        runs = {_name(sweep, group): group.runs for group in groups}
    else:
        runs = {}
        for group in groups:
            runs.setdefault(_name(sweep, group._replace(rest=())), []).extend(group.runs)
    return [Family(name, [Response.read(sweep.plan.runs[number].column) for number in numbers]) for name, numbers in runs.items()]


def draw(sweep):
    """Figures by name."""
    found = suite_pictures.of_suite(families(sweep))
    for figure in found.values():
        figure.suptitle(f"{sweep.plan.title}\n{len(sweep.complete)} of {len(sweep.plan.runs)} runs", fontsize=9)
    return found


def write(sweep):
    """Writes pictures and tables; yields their paths."""
    for name, figure in draw(sweep).items():
        yield style.save(figure, sweep.plan.folder, f"{name}.png")
    yield from suite_tables.write(families(sweep), outputs.made_folder(sweep.plan.folder / "tables"))
