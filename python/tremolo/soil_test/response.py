"""What a history of a soil test says in numbers, and how far two histories are apart.

    r_u = 1 - sigma'/sigma'_0                  excess pore pressure ratio of a constant-volume test
    G   = (tau_1 - tau_2) / (gamma_1 - gamma_2)  secant modulus between the two ends of a loop
    D   = dW / (4 pi W),  W = G A^2 / 2          damping ratio; dW area of the loop, A its strain amplitude
"""

import numpy as np

IN_PLANE = ("sig_xx", "sig_yy", "sig_xy")


def volumetric_strain(history):
    """Volume strain, compression positive."""
    return -(history["eps_xx"] + history["eps_yy"] + history.get("eps_zz", 0.0))


def deviator_of_plane(history):
    """sigma_1 - sigma_3 in the plane, Pa."""
    return 2.0 * np.hypot(0.5 * (history["sig_xx"] - history["sig_yy"]), history["sig_xy"])


def deviator_of_space(history):
    """sqrt(3 J2) with the stress out of plane, Pa."""
    xx, yy, zz = (history[name] for name in ("sig_xx", "sig_yy", "sig_zz"))
    squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * squares + 3.0 * history["sig_xy"] ** 2)


def mean_stress(history, in_plane):
    """p', Pa, compression positive."""
    if in_plane:
        return -0.5 * (history["sig_xx"] + history["sig_yy"])
    return -(history["sig_xx"] + history["sig_yy"] + history["sig_zz"]) / 3.0


def is_in_plane(history):
    """Whether the invariants p, q of a history are those of the plane (PM4Sand, Mohr-Coulomb) or of space."""

    def distance(p, q):
        return np.abs(history["p"] - p).max() + np.abs(history["q"] - q).max()

    plane = distance(mean_stress(history, True), deviator_of_plane(history))
    return bool(plane <= distance(mean_stress(history, False), deviator_of_space(history)))


def pore_pressure_ratio(history, held="sig_yy"):
    """r_u of a constant-volume test from the stress that the apparatus would hold constant."""
    return 1.0 - history[held] / history[held][0]


def cycles_to(cycle, measure, level):
    """The number of cycles at which `measure` first reaches `level`, NaN if it never does."""
    reached = np.flatnonzero(measure >= level)
    if len(reached) == 0:
        return np.nan
    k = reached[0]
    if k == 0:
        return float(cycle[0])
    part = (level - measure[k - 1]) / (measure[k] - measure[k - 1])
    return float(cycle[k - 1] + part * (cycle[k] - cycle[k - 1]))


def reversals(strain):
    """Rows at which the direction of straining changes, the last row included."""
    direction = np.sign(np.diff(strain))
    moving = np.flatnonzero(direction)
    turns = moving[1:][direction[moving[1:]] != direction[moving[:-1]]]
    return np.append(turns, len(strain) - 1)


def secant_and_damping(strain, stress):
    """(A, G, D) of one loop, from an end over the other end and back; its first end may be left and met again at
    different stresses."""
    middle = np.argmax(np.abs(strain - strain[0]))
    amplitude = 0.5 * abs(strain[middle] - strain[0])
    ends = 0.5 * (stress[0] + stress[-1]) - stress[middle]
    modulus = ends / (strain[0] - strain[middle])
    area = abs(np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(strain)))
    return amplitude, modulus, area / (2.0 * np.pi * modulus * amplitude**2)


def last_loops(strain):
    """Rows of the last loop of every amplitude, slices in the order of the test."""
    turns = reversals(strain)
    amplitudes = np.abs(strain[turns])
    loops = []
    k = 0
    while k < len(turns):
        end = k
        while end + 1 < len(turns) and np.isclose(amplitudes[end + 1], amplitudes[k], rtol=1e-3, atol=0.0):
            end += 1
        if end - k >= 2:
            loops.append(slice(turns[end - 2], turns[end] + 1))
        k = end + 1
    return loops


def common_rows(ours, reference):
    """Rows of both histories that belong to the same number of increments.

    Raises ValueError where fewer than nine in ten rows of the reference have a partner.
    """
    _, mine, theirs = np.intersect1d(ours["step"].astype(int), reference["step"].astype(int), return_indices=True)
    if len(theirs) < 0.9 * len(reference["step"]):
        raise ValueError(f"only {len(theirs)} of {len(reference['step'])} rows of the reference stand in the test")
    return mine, theirs


def stress_differences(ours, reference):
    """Largest difference of the stresses in the plane at every common row, Pa, and the rows of the reference."""
    mine, theirs = common_rows(ours, reference)
    difference = np.max([np.abs(ours[name][mine] - reference[name][theirs]) for name in IN_PLANE], axis=0)
    return difference, theirs


def relative(value, reference):
    """value / reference - 1."""
    return value / reference - 1.0
