"""tremolo: results of a run as arrays, and pictures of them."""

from tremolo.run import Run, Series

__all__ = ["Run", "Series"]
