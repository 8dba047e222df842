"""Histories: what a series of an HDF5 file holds."""

import numpy as np


def text(value):
    """An attribute or a dataset of HDF5 in Python's own types: strings of fixed length arrive as bytes."""
    if isinstance(value, bytes):
        return value.rstrip(b"\0").decode("utf-8")
    if isinstance(value, np.ndarray) and value.dtype.kind == "S":
        return [text(bytes(item)) for item in value]
    if isinstance(value, np.generic):
        return value.item()
    return value


class Series:
    """A history: columns by name, units by column, one row a time.

        toe = run.monitor("toe")
        toe["ax"]                       # m/s2, at toe["time"] or toe.time
        toe.units["ax"]                 # "m/s2"
        dict(toe)                       # all columns
        toe.between(5.0, 10.0)["ax"]    # a part of it
        toe.to_frame()                  # as a pandas DataFrame over the time

    The first column is the time (s).
    """

    def __init__(self, dataset):
        columns = text(dataset.attrs["columns"])
        rows = dataset[()]
        # A writer that died while it flushed may have declared rows whose values never arrived.
        self._fill(columns, dict(zip(columns, text(dataset.attrs["units"]))), rows[: np.count_nonzero(~np.isnan(rows[:, 0]))])

    def _fill(self, columns, units, rows):
        self.columns, self.units, self._rows = columns, units, rows

    def keys(self):
        """Names of the columns."""
        return list(self.columns)

    def __iter__(self):
        return iter(self.columns)

    def __getitem__(self, column):
        if column not in self.columns:
            raise KeyError(f"no column '{column}'; the series has {', '.join(self.columns)}")
        return self._rows[:, self.columns.index(column)]

    def __len__(self):
        return len(self._rows)

    def __repr__(self):
        span = f", {self.time[0]:g} to {self.time[-1]:g} s" if len(self) else ""
        return f"<{type(self).__name__}: {len(self)} rows{span}; {', '.join(f'{c} ({self.units[c]})' for c in self.columns)}>"

    @property
    def time(self):
        """s, of the rows."""
        return self._rows[:, 0]

    def between(self, begin, end):
        """The rows from one time to another (s), both included, as a series."""
        part = Series.__new__(Series)
        part._fill(self.columns, self.units, self._rows[(self.time >= begin) & (self.time <= end)])
        return part

    def to_frame(self):
        """A pandas DataFrame with the time (s) for its index; its `attrs` hold the units by column.

        Raises ImportError that says what is missing where pandas is not installed.
        """
        try:
            import pandas
        except ImportError as error:
            raise ImportError("Series.to_frame() needs pandas, the Debian package python3-pandas; without it dict(series) has the "
                              "columns as arrays") from error
        frame = pandas.DataFrame(self._rows[:, 1:], index=pandas.Index(self.time, name=self.columns[0]), columns=self.columns[1:])
        frame.attrs["units"] = dict(self.units)
        return frame
