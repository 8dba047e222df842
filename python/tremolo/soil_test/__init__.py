"""Soil tests: what `tremolo soiltest` has written, measures of its histories, and their picture."""
