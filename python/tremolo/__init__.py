"""tremolo: results of a run as arrays, and pictures of them.

    from tremolo import Run, Site

    run = Run("runs/my_slope")                # a run, or OUT.h5 of `tremolo column`
    run.monitor("crest")["ax"]                # m/s2
    Site("runs/site").models["fe"].profile    # what `tremolo column --models` wrote

help(Run), help(Series), help(Line), help(Site) say more, with examples. `python3 -m tremolo plot|compare|report|extract` does what
the commands of the same names do. A free field of one's own: tremolo.participant.
"""

from tremolo.run import Line, Run, Series
from tremolo.site.read import Site

__all__ = ["Line", "Run", "Series", "Site"]
