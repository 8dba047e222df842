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
velocities to t - dt/2. A test compares tremolo with this file, face by face and particle by particle.
"""

import numpy as np

from plane_wave import C_P, C_S, DENSITY, HIGH, LAME, LOW, SHEAR, free_field


def hats(x, nodes):
    """Hat functions of nodes at x."""
    return np.maximum(0.0, 1.0 - np.abs(x[:, None] - nodes) / (nodes[1] - nodes[0]))


def means(x, half, nodes):
    """Hat functions of nodes averaged over [x - half, x + half], and the derivatives of these means by x."""
    h = nodes[1] - nodes[0]
    left, right = (np.clip((x[:, None] + side - nodes) / h, -1.0, 1.0) for side in (-half, half))
    integral = h * (right - 0.5 * right * np.abs(right) - left + 0.5 * left * np.abs(left))
    return integral / (2.0 * half), (hats(x + half, nodes) - hats(x - half, nodes)) / (2.0 * half)


def product(along_x, along_y):
    """Weights of a particle or face (row) at each node of the grid (column) from those in both directions."""
    return np.einsum("pj,pi->pji", along_y, along_x).reshape(len(along_x), -1)


class FlatBox:
    """@param h: size of the cells, m; dt: time step, s; free_field(x, t): velocity and stress as in plane_wave.py"""

    def __init__(self, h, dt, free_field=free_field):
        self.h, self.dt, self.free_field, self.count = h, dt, free_field, 0
        self.half = 0.25 * h  # of a particle's side
        x, y = np.meshgrid(*(np.arange(low + self.half, high, 2.0 * self.half) for low, high in zip(LOW, HIGH)))
        self.x = np.column_stack([x.ravel(), y.ravel()])
        self.volume = np.full(x.size, (2.0 * self.half) ** 2)
        self.mass = DENSITY * self.volume
        self.v, self.b, self.stress = np.zeros((x.size, 2)), np.zeros((x.size, 2, 2)), np.zeros((x.size, 3))
        self.lines = [np.arange(low - h, high + 1.5 * h, h) for low, high in zip(LOW, HIGH)]
        self.nodes = np.column_stack([grid.ravel() for grid in np.meshgrid(*self.lines)])
        # Faces move with the particles along left side, right side and base, and keep the free field of their first position.
        to_edges = self.x[:, 0] - LOW[0], HIGH[0] - self.x[:, 0], self.x[:, 1] - LOW[1]
        riders = [np.flatnonzero(distance < 0.5 * h) for distance in to_edges]
        self.rider = np.concatenate(riders)
        self.normal = np.repeat([[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0]], [len(edge) for edge in riders], axis=0)
        self.start = self.x[self.rider] + self.half * self.normal
        self.impedance = DENSITY * np.where(self.normal != 0.0, C_P, C_S)  # across and along a face, Pa s/m

    def particle_weights(self):
        """S, its gradient (dS/dx, dS/dy), and D, which is diagonal."""
        (sx, gx), (sy, gy) = (means(self.x[:, k], self.half, line) for k, line in enumerate(self.lines))
        d = [np.sum(s * (line - self.x[:, [k]]) ** 2, axis=1) for k, (s, line) in enumerate(zip((sx, sy), self.lines))]
        return product(sx, sy), (product(gx, sy), product(sx, gy)), np.column_stack(d)

    def face_weights(self):
        """W, averaged along the face and linear across it."""
        at = self.x[self.rider] + self.half * self.normal
        return product(*(np.where(self.normal[:, [k]] != 0.0, hats(at[:, k], line), means(at[:, k], self.half, line)[0])
                         for k, line in enumerate(self.lines)))

    def momentum(self, s, d):
        """sum_p S_Ip m_p (v_p + B_p D_p^-1 (x_I - x_p)) at the nodes."""
        c = self.mass[:, None, None] * self.b / d[:, None, :]
        at_origin = self.mass[:, None] * self.v - np.einsum("pkl,pl->pk", c, self.x)
        return s.T @ at_origin + sum((s.T @ c[:, :, k]) * self.nodes[:, [k]] for k in (0, 1))

    def boundary_traction(self, v):
        """Eq. (6) for velocities v (m/s) at the faces, Pa."""
        v_ff, stress = self.free_field(self.start, self.count * self.dt)
        (xx, yy, xy), (nx, ny) = stress.T, self.normal.T
        return -self.impedance * (v - v_ff) + np.column_stack([xx * nx + xy * ny, xy * nx + yy * ny])

    def step(self):
        s, (gx, gy), d = self.particle_weights()
        w, length = self.face_weights(), 2.0 * self.half
        m = (s.T @ self.mass)[:, None]
        m[m <= 1e-20 * DENSITY * self.h**2] = np.inf  # nodes without soil stay at rest
        v = self.momentum(s, d) / m
        xx, yy, xy = self.volume * self.stress.T
        internal = np.column_stack([gx.T @ xx + gy.T @ xy, gx.T @ xy + gy.T @ yy])
        force = length * w.T @ self.boundary_traction(w @ v) - internal

        # Three fixed-point steps invert M + dt/2 C, beginning with C lumped to the nodes.
        z = 0.5 * self.dt * length * self.impedance
        excess = np.zeros_like(force)  # of the lumped dashpots' force
        for _ in range(3):
            a = (force + excess) / (m + w.T @ z)
            excess = (w.T @ z) * a - w.T @ (z * (w @ a))
        v = v + self.dt * (force + excess) / (m + w.T @ z)

        self.v = s @ v
        self.b = np.stack([s @ (v * self.nodes[:, [k]]) - self.v * self.x[:, [k]] for k in (0, 1)], axis=2)
        u = self.momentum(s, d) / m
        self.strain(self.dt * np.stack([gx @ u, gy @ u], axis=2))
        self.x = self.x + self.dt * self.v
        self.count += 1

    def strain(self, a):
        """Stress and volume for A = dt grad u: the stress rotates with the soil (Hughes and Winget 1980), then Hooke's law acts."""
        e = a - 0.5 * a @ a
        exx, eyy, gxy, spin = e[:, 0, 0], e[:, 1, 1], e[:, 0, 1] + e[:, 1, 0], 0.5 * (e[:, 1, 0] - e[:, 0, 1])
        dilation, angle = exx + eyy, 4.0 * np.arctan(0.5 * spin)  # twice the rotation
        half, xy = 0.5 * (self.stress[:, 0] - self.stress[:, 1]), self.stress[:, 2]
        mean = 0.5 * (self.stress[:, 0] + self.stress[:, 1]) + LAME * dilation
        deviator = half * np.cos(angle) - xy * np.sin(angle)
        shear = half * np.sin(angle) + xy * np.cos(angle)
        self.stress = np.column_stack([mean + deviator + 2.0 * SHEAR * exx, mean - deviator + 2.0 * SHEAR * eyy, shear + SHEAR * gxy])
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
