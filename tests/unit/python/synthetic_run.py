"""A run file with a known plane wave, written by h5py to the letter of docs/output-format.md."""

import h5py
import numpy as np

C_S = 95.8  # m/s
CREST, TOE, SLOPE_FOOT, SLOPE_HEAD = 10.0, 0.0, 30.0, 40.0  # levels and the ends of a 45 degree slope, m


def ricker(t, frequency=3.0, peak_time=0.6):
    a = (np.pi * frequency * (t - peak_time)) ** 2
    return (1.0 - 2.0 * a) * np.exp(-a)


def slope_particles(size=1.0):
    """Particle positions of a slope that falls to the left, two by two in cells of `size`."""
    step = size / 2.0
    x, y = np.meshgrid(np.arange(step / 2, 70.0, step), np.arange(-20.0 + step / 2, CREST, step))
    surface = np.clip(TOE + (x - SLOPE_FOOT), TOE, CREST)
    inside = y < surface
    return np.column_stack([x[inside], y[inside]])


def pore_pressure_ratio(t):
    """r_u that rises to 1 within two seconds, anywhere."""
    return np.sin(np.pi / 4.0 * np.asarray(t))


def write(path, angle_deg=15.0, amplitude=0.1, frame_interval=0.02, frames=100, size=1.0, damaged=False, water=False,
          width=70.0, structures=False):
    """An SV wave v = amplitude * ricker(t - (x sin + y cos)/c_s) along (cos, -sin), nothing else; with `water` a pore
    pressure that rises by itself; with `structures` a tunnel that rises and turns, and a block. Only soil at x < `width`
    is there."""
    position = slope_particles(size)
    position = position[position[:, 0] < width]
    particles = len(position)
    angle = np.radians(angle_deg)
    polarisation = np.array([np.cos(angle), -np.sin(angle)])

    def velocity(points, t):
        delay = (points[:, 0] * np.sin(angle) + (points[:, 1] + 20.0) * np.cos(angle)) / C_S
        return amplitude * ricker(t - delay)[:, None] * polarisation

    with h5py.File(path, "w") as file:
        file.attrs.update(
            {
                "schema_version": np.bytes_("1.0"), "title": np.bytes_("synthetic slope"),
                "status": np.bytes_("complete"), "mesh_size": size, "angle_deg": angle_deg, "wave": np.bytes_("SV"),
                "soil_names": np.array([b"sand", b"base layer"]), "box": [0.0, -20.0, 70.0, 10.0],
            }
        )
        file["case"] = np.bytes_("title = 'synthetic slope'\n")
        group = file.create_group("frames")
        file.create_group("monitors")
        for number in range(frames):
            t = number * frame_interval
            frame = group.create_group(f"{number:04}")
            frame.attrs["time"] = t
            centre = np.array([SLOPE_HEAD, CREST + 5.0])
            band = np.exp(-(((np.linalg.norm(position - centre, axis=1) - 16.0) / 1.0) ** 2))
            dt = 1e-4
            fields = {
                "position": (position, "m"),
                "velocity": (velocity(position, t), "m/s"),
                "acceleration": ((velocity(position, t + dt) - velocity(position, t - dt)) / (2 * dt), "m/s2"),
                "equivalent_plastic_strain": (band * number / frames, "1"),
                "soil": ((position[:, 1] < -12.0).astype(np.int32), "1"),
                "volume": (np.full(particles, (size / 2.0) ** 2), "m2"),
            }
            if water:
                fields["pore_pressure_ratio"] = (np.full(particles, pore_pressure_ratio(t)), "1")
            for name, (values, unit) in fields.items():
                frame.create_dataset(name, data=values).attrs["unit"] = np.bytes_(unit)
        _write_series(file, "monitors/crest", frame_interval * frames, velocity, np.array([[45.0, 10.0]]), damaged, water)
        _write_boundary(file, velocity, frame_interval, frames)
        if structures:
            _write_structures(file, frame_interval, frames)
            _write_drift(file)
        times = np.arange(frames) * frame_interval
        ledger = np.column_stack([times, 1e3 * times**2, 1e3 * times, -2e3 * times])
        energy = file.create_dataset("energy", data=ledger)
        energy.attrs["columns"] = np.array([b"time", b"kinetic", b"elastic", b"dashpots"])
        energy.attrs["units"] = np.array([b"s", b"J/m", b"J/m", b"J/m"])
        timings = file.create_group("timings")
        timings.attrs["columns"] = np.array([b"pass", b"seconds"])
        timings["pass"] = np.array([b"scatter", b"gather"])
        timings["seconds"] = [1.0, 2.0]


def _write_boundary(file, velocity, interval, count):
    """Faces along the base, 0.5 m long."""
    x = np.arange(0.25, 70.0, 0.5)
    position = np.column_stack([x, np.full(len(x), -20.0)])
    # A run writes at the first step after each interval: late by up to a step, here by up to 30 % of the interval.
    times = interval * (np.arange(count) + 0.3 * np.modf(0.618 * np.arange(count))[0] + 0.3 * (np.arange(count) == 1))
    group = file.create_group("boundary")
    group.attrs["source"] = np.array([b"left"] * len(x))
    group["position"], group["normal"] = position, np.tile([0.0, -1.0], (len(x), 1))
    group["length"], group["time"] = np.full(len(x), 0.5), times
    motion = np.array([velocity(position, t) for t in times])
    group["domain_velocity"] = group["free_field_velocity"] = motion
    group["traction"] = np.zeros_like(motion)


DRIFT = 0.012  # m, of the middle of the base


def _write_drift(file):
    """A base that sags towards its middle, and a right side that leans outwards; a matched layer holds the left side."""
    x, y = np.arange(0.25, 70.0, 0.5), np.arange(-19.75, 10.0, 0.5)
    rows = {"side": np.array([b"base"] * len(x) + [b"right"] * len(y)),
            "x": np.append(x, np.full(len(y), 70.0)), "y": np.append(np.full(len(x), -20.0), y),
            "dx": np.append(np.zeros(len(x)), 1e-3 * (y + 20.0)),
            "dy": np.append(-DRIFT * np.sin(np.pi * x / 70.0), np.zeros(len(y))),
            "strength_share": np.full(len(x) + len(y), 0.1)}
    group = file.create_group("drift")
    group.attrs["columns"] = np.array([name.encode() for name in rows])
    for name, values in rows.items():
        group[name] = values


RISE, TURN = 0.05, 0.02  # of the tunnel, m/s and rad/s
TUNNEL = np.array([52.0, -4.0])
BLOCK = np.array([[60.0, 10.0], [64.0, 10.0], [64.0, 12.0], [60.0, 12.0]])
BODY_COLUMNS = ["time", "x", "y", "tilt", "vx", "vy", "spin"] + [
    f"{force}_{part}" for force in ("normal", "friction", "water", "weight") for part in ("x", "y", "moment")]


def ring(radius):
    """A circle around the tunnel's centre, counter-clockwise."""
    angle = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    return TUNNEL + radius * np.column_stack([np.cos(angle), np.sin(angle)])


def _write_structures(file, interval, count):
    file.attrs["structure_names"] = np.array([b"tunnel", b"block"])
    times = np.arange(0.0, interval * count, 0.005)
    contact = file.create_group("contact")
    for number in range(count):
        frame = contact.create_group(f"{number:04}")
        frame.attrs["time"] = number * interval
        nodes = {"position": [[61.0, 10.0], [62.0, 10.0]], "normal": [[0.0, 1.0], [0.0, 1.0]],
                 "body": np.array([1, 1], dtype=np.int32), "area": [1.0, 1.0], "normal_force": [5e4, 3e4],
                 "friction_force": [1e3, -1e3], "water_force": [0.0, 0.0]}
        for name, values in nodes.items():
            frame[name] = np.array(values)
    group = file.create_group("bodies")
    for name, centre, outline, hole in (("tunnel", TUNNEL, ring(2.5), ring(2.2)), ("block", BLOCK.mean(axis=0), BLOCK, None)):
        moves = name == "tunnel"
        rows = np.zeros((len(times), len(BODY_COLUMNS)))
        columns = {"time": times, "x": centre[0], "y": centre[1] + RISE * times * moves, "tilt": TURN * times * moves,
                   "vy": RISE * moves, "spin": TURN * moves, "normal_y": 8e4 - 16e4 * moves, "weight_y": -8e4 + 16e4 * moves}
        for column, values in columns.items():
            rows[:, BODY_COLUMNS.index(column)] = values
        series = group.create_dataset(name, data=rows)
        series.attrs["columns"] = np.array([c.encode() for c in BODY_COLUMNS])
        series.attrs["units"] = np.array([b"1"] * len(BODY_COLUMNS))
        series.attrs["outline"] = outline.ravel()
        if hole is not None:
            series.attrs["hole"] = hole.ravel()
        series.attrs["mass"], series.attrs["inertia"] = 8e3, 1e4


def _write_series(file, path, duration, velocity, point, damaged, water):
    t = np.arange(0.0, duration, 0.005)
    v = np.array([velocity(point, ti)[0] for ti in t])
    a = np.gradient(v, t, axis=0)
    u = np.cumsum(v, axis=0) * 0.005
    rows = np.column_stack([t, np.tile(point, (len(t), 1)), u, v, a])
    columns = [b"time", b"x", b"y", b"ux", b"uy", b"vx", b"vy", b"ax", b"ay"]
    units = [b"s", b"m", b"m", b"m", b"m", b"m/s", b"m/s", b"m/s2", b"m/s2"]
    if water:  # 5 m below the table, an effective stress of 50 kPa before the shaking
        ratio = pore_pressure_ratio(t)
        rows = np.column_stack([rows, -5e4 * (1.0 - ratio), 1e4 * v[:, 0], 49050.0 + 5e4 * ratio, ratio])
        columns += [b"syy", b"sxy", b"pore_pressure", b"pore_pressure_ratio"]
        units += [b"Pa", b"Pa", b"Pa", b"1"]
    if damaged:
        rows = np.vstack([rows, np.full((3, rows.shape[1]), np.nan)])
    series = file.create_dataset(path, data=rows)
    series.attrs["columns"] = np.array(columns)
    series.attrs["units"] = np.array(units)
