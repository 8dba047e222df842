"""Processes of a run, as the system knows them."""

from pathlib import Path


def children(pid):
    """Process ids of its children; none where it is gone."""
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except (FileNotFoundError, ProcessLookupError):
        return []


def alive(pid):
    """Running or stopped; a zombie is gone."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def status(pid):
    """What the system says of it, by lines; empty where it is gone."""
    try:
        return Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return ""


def variable(pid, name):
    """A variable in the environment of a process; None without it, or without the process."""
    try:
        values = dict(line.split("=", 1) for line in Path(f"/proc/{pid}/environ").read_text().split("\0") if "=" in line)
    except OSError:
        return None
    return values.get(name)


def ranks_below(mpirun):
    """Process ids of the ranks that an mpirun has started on its machine, by rank."""
    found = {}
    for process in children(mpirun):
        rank = variable(process, "OMPI_COMM_WORLD_RANK")
        if rank is not None:
            found[int(rank)] = process
    return found
