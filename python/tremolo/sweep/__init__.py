"""`tremolo sweep`: the runs of a study carried out here or by Slurm, and what is made of them.

`plan.py` is what C++ wrote of the study; `task.py` carries out one run; `pool.py` and `slurm.py` carry out all; `measures.py`
measures a run; `table.py`, `statistics.py` and `pictures.py` are what comes of it, and `site_responses.py` of site responses.
"""
