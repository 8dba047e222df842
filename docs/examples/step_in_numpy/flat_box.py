#!/usr/bin/env python3
"""tremolo's step in plain numpy: elastic soil of one kind, one clock, and the boundary tractions of Eq. (6).

    ./flat_box.py      motion of the surface of cases/halfspace_box, in cells of 4 m, beside the exact one

Particles carry mass m, volume V, position x, velocity v, the affine moment B and stress s. The grid is new in each step:

    m_I = sum_p S_Ip m_p,   m_I v-_I = sum_p S_Ip m_p (v_p + B_p D_p^-1 (x_I - x_p))        particles to grid
    f_I = -sum_p V_p s_p grad S_Ip + sum_f L_f W_fI t_f,   t_f = t^vis + t^dyn              Eq. (6)
    (M + dt/2 C) (v+ - v-) = dt f,   C = sum_f L_f Z_f W_f W_f^T                            dashpots, centred in time
    v_p = sum_I S_Ip v+_I,   B_p = sum_I S_Ip v+_I (x_I - x_p)^T                            grid to particles
    m_I u_I = sum_p S_Ip m_p (v_p + B_p D_p^-1 (x_I - x_p)),   x_p += dt v_p                and once more to the grid
    s_p += E : sym e,   e = A - A A/2,   A = dt grad u                                      strain about mid-step

(Bardenhagen and Kober 2004; Jiang et al. 2015; docs/theory.md, sections 1, 2 and 4.) Positions and stresses belong to t,
velocities to t - dt/2. A test holds tremolo to this file, face by face and particle by particle.
"""

import numpy as np

DENSITY, YOUNG, POISSON = 1700.0, 40e6, 0.28  # kg/m3, Pa, 1
LOW, HIGH = np.array([0.0, -40.0]), np.array([100.0, 0.0])  # corners of the box, m
ANGLE, FREQUENCY, PEAK_TIME, PEAK = np.radians(15.0), 3.0, 1.0, 0.1  # rad, Hz, s, m/s; of the incident wave at LOW
LAME = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON))  # Pa
SHEAR = YOUNG / (2.0 * (1.0 + POISSON))
C_P, C_S = np.sqrt((LAME + 2.0 * SHEAR) / DENSITY), np.sqrt(SHEAR / DENSITY)  # m/s


def free_field(x, t):
    """Exact velocity (m/s) and stress (xx, yy, xy; Pa) of an SV wave and of what the surface reflects, (T1) and (T2)."""
    p = np.sin(ANGLE) / C_S  # horizontal slowness
    q_s, q_p = np.sqrt(C_S**-2 - p * p), np.sqrt(C_P**-2 - p * p)
    c2, mixed = 1.0 - 2.0 * C_S**2 * p * p, 4.0 * C_S**4 * p * p * q_p * q_s
    velocity, stress = np.zeros((len(x), 2)), np.zeros((len(x), 3))
    for amplitude, q, dx, dy in (  # q is the vertical slowness, (dx, dy) the direction of the motion
        (1.0, q_s, C_S * q_s, -C_S * p),
        ((c2 * c2 - mixed) / (c2 * c2 + mixed), -q_s, C_S * q_s, C_S * p),
        (4.0 * C_S**3 / C_P * p * q_s * c2 / (c2 * c2 + mixed), -q_p, C_P * p, -C_P * q_p),
    ):
        a = (np.pi * FREQUENCY * (t - PEAK_TIME - p * (x[:, 0] - LOW[0]) - q * x[:, 1] + q_s * LOW[1])) ** 2
        v = amplitude * PEAK * (1.0 - 2.0 * a) * np.exp(-a)
        mean = -LAME * (p * dx + q * dy)
        velocity += np.outer(v, (dx, dy))
        stress += np.outer(v, (mean - 2.0 * SHEAR * p * dx, mean - 2.0 * SHEAR * q * dy, -SHEAR * (q * dx + p * dy)))
    return velocity, stress


def hats(x, nodes):
    """Hat functions of nodes at x."""
    return np.maximum(0.0, 1.0 - np.abs(x[:, None] - nodes) / (nodes[1] - nodes[0]))


def means(x, half, nodes):
    """Hat functions of nodes averaged over [x - half, x + half], and the derivatives of these means by x."""
    h = nodes[1] - nodes[0]

    def integral(x):  # of the hats, from their middles on
        z = np.clip((x[:, None] - nodes) / h, -1.0, 1.0)
        return h * (z - 0.5 * z * np.abs(z))

    between = (integral(x + half) - integral(x - half), hats(x + half, nodes) - hats(x - half, nodes))
    return [part / (2.0 * half) for part in between]


def product(along_x, along_y):
    """Weights of a particle or face (row) at each node of the grid (column) from those in both directions."""
    return np.einsum("pj,pi->pji", along_y, along_x).reshape(len(along_x), -1)


class FlatBox:
    """@param h: size of the cells, m; dt: time step, s; free_field(x, t): as above"""

    def __init__(self, h, dt, free_field=free_field):
        self.h, self.dt, self.free_field, self.count = h, dt, free_field, 0
        self.half = 0.25 * h  # of a particle's side
        x, y = np.meshgrid(*(np.arange(low + self.half, high, 2.0 * self.half) for low, high in zip(LOW, HIGH)))
        self.x = np.column_stack([x.ravel(), y.ravel()])
        number = len(self.x)
        self.volume = np.full(number, (2.0 * self.half) ** 2)
        self.mass = DENSITY * self.volume
        self.v, self.b, self.stress = np.zeros((number, 2)), np.zeros((number, 2, 2)), np.zeros((number, 3))
        self.lines = [np.arange(low - h, high + 1.5 * h, h) for low, high in zip(LOW, HIGH)]
        self.nodes = np.column_stack([grid.ravel() for grid in np.meshgrid(*self.lines)])
        # Faces ride on the particles along left side, right side and base, and keep the free field of where they began.
        to_low, to_high = self.x - LOW, HIGH - self.x
        near = [distance < 0.5 * h for distance in (to_low[:, 0], to_high[:, 0], to_low[:, 1])]
        self.rider = np.concatenate([np.flatnonzero(which) for which in near])
        self.normal = np.repeat([[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0]], [which.sum() for which in near], axis=0)
        self.start = self.x[self.rider] + self.half * self.normal
        self.impedance = DENSITY * np.where(self.normal != 0.0, C_P, C_S)  # across and along a face, Pa s/m

    def face_weights(self):
        """W: averaged along the face, linear across it."""
        at = self.x[self.rider] + self.half * self.normal
        return product(*(np.where(self.normal[:, [k]] != 0.0, hats(at[:, k], line), means(at[:, k], self.half, line)[0])
                         for k, line in enumerate(self.lines)))

    def weights(self):
        """S, dS/dx and dS/dy; D, which is diagonal."""
        (sx, gx), (sy, gy) = (means(self.x[:, k], self.half, line) for k, line in enumerate(self.lines))
        d = [np.sum(s * (self.lines[k] - self.x[:, [k]]) ** 2, axis=1) for k, s in enumerate((sx, sy))]
        return product(sx, sy), (product(gx, sy), product(sx, gy)), np.column_stack(d)

    def momentum(self, s, d):
        c = self.b / d[:, None, :]
        at_origin = self.v - np.einsum("pkl,pl->pk", c, self.x)
        return s.T @ (self.mass[:, None] * at_origin) + sum(
            (s.T @ (self.mass[:, None] * c[:, :, k])) * self.nodes[:, [k]] for k in (0, 1))

    def boundary_traction(self, v):
        """Eq. (6) for velocities v (m/s) at the faces, Pa."""
        v_ff, stress = self.free_field(self.start, self.count * self.dt)
        xx, yy, xy = stress.T
        nx, ny = self.normal.T
        return -self.impedance * (v - v_ff) + np.column_stack([xx * nx + xy * ny, xy * nx + yy * ny])

    def step(self):
        s, gradient, d = self.weights()
        w = self.face_weights()
        m = (s.T @ self.mass)[:, None]
        full = m > 1e-20 * DENSITY * self.h**2
        per_mass = np.where(full, 1.0 / np.where(full, m, 1.0), 0.0)
        v = self.momentum(s, d) * per_mass
        xx, yy, xy = self.volume * self.stress.T
        length = 2.0 * self.half
        force = length * w.T @ self.boundary_traction(w @ v) - np.column_stack(
            [gradient[0].T @ xx + gradient[1].T @ xy, gradient[0].T @ xy + gradient[1].T @ yy])

        # The inverse of M + dt/2 C by three fixed-point steps from C lumped to the nodes.
        share = 0.5 * self.dt * length * self.impedance
        inertia = np.where(full, m + w.T @ share, np.inf)
        beyond = np.zeros_like(force)  # what the lumped dashpots take too much
        for _ in range(3):
            a = (force + beyond) / inertia
            beyond = (w.T @ share) * a - w.T @ (share * (w @ a))
        v = v + self.dt * (force + beyond) / inertia

        self.v = s @ v
        self.b = np.stack([s @ (v * self.nodes[:, [k]]) - self.v * self.x[:, [k]] for k in (0, 1)], axis=2)
        u = self.momentum(s, d) * per_mass
        self.strain(np.stack([self.dt * g @ u for g in gradient], axis=2))
        self.x = self.x + self.dt * self.v
        self.count += 1

    def strain(self, a):
        """Stress and volume for A = dt grad u: the stress turns with the soil (Hughes and Winget 1980), then Hooke's law."""
        e = a - 0.5 * a @ a
        exx, eyy, gxy, turn = e[:, 0, 0], e[:, 1, 1], e[:, 0, 1] + e[:, 1, 0], 0.5 * (e[:, 1, 0] - e[:, 0, 1])
        xx, yy, xy = self.stress.T
        twice = 4.0 * np.arctan(0.5 * turn)
        deviator, dilation = 0.5 * (xx - yy) * np.cos(twice) - xy * np.sin(twice), exx + eyy
        mean = 0.5 * (xx + yy) + LAME * dilation
        self.stress = np.column_stack([mean + deviator + 2.0 * SHEAR * exx, mean - deviator + 2.0 * SHEAR * eyy,
                                       0.5 * (xx - yy) * np.sin(twice) + xy * np.cos(twice) + SHEAR * gxy])
        self.volume = self.volume * (1.0 + dilation * (1.0 + 0.5 * dilation))


if __name__ == "__main__":
    box = FlatBox(4.0, 0.0075)
    middle = np.argmin(np.hypot(*(box.x - (50.0, 0.0)).T))
    print("t (s), horizontal velocity at the middle of the surface and the exact one (m/s)")
    while box.count < 300:
        box.step()
        if box.count % 10 == 0:
            t = (box.count - 0.5) * box.dt
            print(f"{t:.3f}  {box.v[middle, 0]:+.4f}  {free_field(box.x[[middle]], t)[0][0, 0]:+.4f}")
