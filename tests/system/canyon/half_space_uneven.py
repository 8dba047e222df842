"""The exact motion of an elastic half-space with an uneven surface under a plane SV wave, plane strain, computed without cells: the
method of fundamental solutions (Fairweather and Karageorghis 1998, Adv. Comput. Math. 9, pp. 69-95).

The field is that of the level half-space, in closed form, plus the fields of forces in the air above the ground, each of
which is known in closed form in an infinite medium. The forces are such that nothing is left of the traction on the surface:

    v(x) = v0(x) + sum_j G(x - y_j) f_j,      t0(x_i) + sum_j T(x_i - y_j, n_i) f_j = 0 at all x_i of the surface.

Each part satisfies the equations of motion and runs away from what is uneven. So the only errors are what is left of the traction between
the points x_i, which is measured, and the ends of the surface that has such points. All is done at complex frequencies s = eta + i
omega: exp(-eta t) damps what comes back from the ends and what wraps around in time (Phinney 1965, J. Geophys. Res. 70, pp. 1185-1190).

    G_ki = (psi delta_ki - chi e_k e_i)/(2 pi mu),      e = r/|r|
    psi  = K0(z2) + (K1(z2) - g K1(z1))/z2,    chi = K2(z2) - g^2 K2(z1),    z2 = s |r|/c_s, z1 = s |r|/c_p, g = c_s/c_p

(Cruse and Rizzo 1968, J. Math. Anal. Appl. 22, pp. 244-259). x to the right, y up, tension positive, SI units.
"""

import numpy as np


def bessel_k(z):
    """K0 and K1 of complex z, real part >= 0, to 1e-6: the ascending series up to |z| = 12, Hankel's expansion beyond (Abramowitz and
    Stegun 1964, 9.6.10 to 9.6.13 and 9.7.2)."""
    k0, k1 = np.empty_like(z), np.empty_like(z)
    near = np.abs(z) < 12.0
    x = z[near]
    log = np.log(0.5 * x)
    term = np.ones_like(x)  # (x^2/4)^k/k!^2
    digamma = -np.euler_gamma  # of k + 1
    k0[near], k1[near] = 0.0, 1.0 / x
    for k in range(60):
        k0[near] += term * (digamma - log)
        k1[near] += 0.5 * x * term / (k + 1.0) * (log - digamma - 0.5 / (k + 1.0))
        digamma += 1.0 / (k + 1.0)
        term = term * 0.25 * x * x / (k + 1.0) ** 2
    x = z[~near]
    for order, values in ((0, k0), (1, k1)):
        total, term = np.ones_like(x), np.ones_like(x)
        for k in range(1, 24):
            term = term * (4.0 * order**2 - (2.0 * k - 1.0) ** 2) / (8.0 * k * x)
            total += term
        values[~near] = np.sqrt(0.5 * np.pi / x) * np.exp(-x) * total
    return k0, k1


def bessel_k_on_a_ray(z):
    """The same where all z have one argument: cubic Hermite interpolation in log |z| of exp(z) K(z), which is smooth."""
    size = np.abs(z)
    logs = np.linspace(np.log(0.999 * size.min()), np.log(1.001 * size.max()), 6000)
    nodes = z.flat[0] / size.flat[0] * np.exp(logs)
    k0, k1 = bessel_k(nodes)
    step = logs[1] - logs[0]
    place = (np.log(size) - logs[0]) / step
    i = place.astype(int)
    t = place - i
    result = []
    for k, slope in ((k0, -k1), (k1, -k0 - k1 / nodes)):
        value, change = np.exp(nodes) * k, step * nodes * np.exp(nodes) * (k + slope)
        result.append(np.exp(-z) * ((1.0 + 2.0 * t) * (1.0 - t) ** 2 * value[i] + t * (1.0 - t) ** 2 * change[i]
                                    + t**2 * (3.0 - 2.0 * t) * value[i + 1] - t**2 * (1.0 - t) * change[i + 1]))
    return result


class Medium:
    """Density (kg/m3), speeds of shear and pressure waves (m/s)."""

    def __init__(self, density, vs, vp):
        self.density, self.vs, self.vp = density, vs, vp
        self.mu = density * vs**2
        self.lame = density * vp**2 - 2.0 * self.mu

    def stress(self, gradient):
        """[..., 2, 2] of displacement gradients du_k/dx_l."""
        trace = gradient[..., 0, 0] + gradient[..., 1, 1]
        return self.lame * trace[..., None, None] * np.eye(2) + self.mu * (gradient + np.swapaxes(gradient, -1, -2))


class Forces:
    """What unit forces at `sources` do at `points` of the infinite medium."""

    def __init__(self, medium, s, points, sources):
        self.medium, self.s = medium, s
        difference = points[:, None, :] - sources[None, :, :]
        self.r = np.linalg.norm(difference, axis=-1)
        self.e = difference / self.r[..., None]
        self.ratio = medium.vs / medium.vp
        self.z2 = s * self.r / medium.vs
        self.z1 = self.ratio * self.z2
        self.s0, self.s1 = bessel_k_on_a_ray(self.z2)
        self.p0, self.p1 = bessel_k_on_a_ray(self.z1)
        self.s2, self.p2 = self.s0 + 2.0 * self.s1 / self.z2, self.p0 + 2.0 * self.p1 / self.z1
        self.psi = self.s0 + (self.s1 - self.ratio * self.p1) / self.z2
        self.chi = self.s2 - self.ratio**2 * self.p2

    def displacement(self):
        """[points, sources, direction of the force, component]."""
        ee = self.e[..., :, None] * self.e[..., None, :]
        return (self.psi[..., None, None] * np.eye(2) - self.chi[..., None, None] * ee) / (2.0 * np.pi * self.medium.mu)

    def gradient(self):
        """[points, sources, direction of the force, component, derivative]."""
        k, g = self.s / self.medium.vs, self.ratio
        psi_slope = k * (-self.s1 - (self.s0 + self.s1 / self.z2 - g**2 * (self.p0 + self.p1 / self.z1)) / self.z2
                         - (self.s1 - g * self.p1) / self.z2**2)
        chi_slope = k * (-self.s1 - 2.0 * self.s2 / self.z2 + g**3 * (self.p1 + 2.0 * self.p2 / self.z1))
        i, c, d = self.e[..., :, None, None], self.e[..., None, :, None], self.e[..., None, None, :]
        unit = np.eye(2)
        ic, id, cd = unit[:, :, None], unit[:, None, :], unit[None, :, :]

        def wide(f):
            return f[..., None, None, None]

        return (wide(psi_slope) * ic * d - wide(chi_slope) * i * c * d
                - wide(self.chi / self.r) * (id * c + cd * i - 2.0 * i * c * d)) / (2.0 * np.pi * self.medium.mu)


def flat_ground(medium, angle, s, points):
    """Velocity [points, 2] and its gradient [points, 2, 2] of level ground under an SV wave of unit velocity (cos, -sin) of
    the angle that reaches (0, 0) at t = 0, with the reflected SV and P waves that leave no traction at y = 0; below the critical angle."""
    p = np.sin(angle) / medium.vs
    q, q_p = np.cos(angle) / medium.vs, np.sqrt(1.0 / medium.vp**2 - p**2)
    slowness = np.array([[p, q], [p, -q], [p, -q_p]])
    direction = np.array([[np.cos(angle), -np.sin(angle)], [np.cos(angle), np.sin(angle)], medium.vp * slowness[2]])
    gradients = -s * direction[:, :, None] * slowness[:, None, :]
    tractions = medium.stress(gradients)[:, :, 1]
    amplitudes = np.concatenate([[1.0], np.linalg.solve(tractions[1:].T, -tractions[0])])
    waves = amplitudes * np.exp(-s * points @ slowness.T)
    return waves @ direction, np.einsum("nw,wkl->nkl", waves, gradients)


class Gaussian:
    """y = -depth exp(-x^2/(2 sigma^2)), m."""

    def __init__(self, depth, sigma):
        self.depth, self.sigma = depth, sigma

    def level(self, x):
        return -self.depth * np.exp(-0.5 * (x / self.sigma) ** 2)

    def slope(self, x):
        return self.depth * x / self.sigma**2 * np.exp(-0.5 * (x / self.sigma) ** 2)

    def coarseness(self, x):
        """Spacing of points over the finest one."""
        return 1.0 + 3.0 * np.clip((abs(x) / self.sigma - 3.5) / 3.0, 0.0, 1.0)


class Trench:
    """A wide trench between two smooth steps at `left` and `right` (m), y = -height/2 (tanh((x - left)/w) - tanh((x - right)/w)), whose
    steepest slope is 45 degrees, w = height/2. Until waves from the other step arrive, each of them is a step without the other."""

    def __init__(self, height, left, right):
        self.height, self.edges = height, (left, right)

    def level(self, x):
        one, other = (np.tanh((x - edge) / (0.5 * self.height)) for edge in self.edges)
        return -0.5 * self.height * (one - other)

    def slope(self, x):
        one, other = (np.cosh(np.clip((x - edge) / (0.5 * self.height), -300.0, 300.0)) ** -2.0 for edge in self.edges)
        return other - one

    def coarseness(self, x):
        return 1.0 + 2.5 * np.clip((min(abs(x - edge) for edge in self.edges) / self.height - 2.0) / 2.0, 0.0, 1.0)


class UnevenGround:
    """A half-space whose surface has a shape that is level, y = 0, far away.

    spacing  of the forces where the surface is uneven, m
    ends     where points without traction end, m
    """

    def __init__(self, medium, shape, spacing=1.0, ends=(-400.0, 400.0)):
        self.medium, self.shape = medium, shape
        x = np.array(self.march(-spacing, ends[0])[::-1] + [0.0] + self.march(spacing, ends[1]))
        normal = self.normal(x)
        between = np.gradient(x) / normal[:, 1]
        self.sources = self.surface(x) + 2.0 * between[:, None] * normal
        self.held = np.sort(np.concatenate([x, 0.5 * (x[1:] + x[:-1])]))
        near = self.held[(self.held > 0.5 * ends[0]) & (self.held < 0.5 * ends[1])]
        self.checked = 0.5 * (near[1:] + near[:-1])

    def march(self, spacing, end):
        """Points from 0, which is not among them, to an end."""
        x = [0.0]
        while abs(x[-1]) < abs(end):
            x.append(x[-1] + spacing * self.shape.coarseness(x[-1]) * self.normal(x[-1])[1])
        return x[1:]

    def surface(self, x):
        return np.stack([x, self.shape.level(x)], axis=-1)

    def normal(self, x):
        slope = self.shape.slope(x)
        return np.stack([-slope, np.ones_like(slope)], axis=-1) / np.hypot(1.0, slope)[..., None]

    def tractions(self, s, angles, x):
        """Of all forces [2 x, forces], and of flat ground under each wave [2 x, angles]."""
        normal = self.normal(x)
        stress = self.medium.stress(Forces(self.medium, s, self.surface(x), self.sources).gradient())
        ours = np.einsum("njikl,nl->nkji", stress, normal).reshape(2 * len(x), -1)
        flat = [self.medium.stress(flat_ground(self.medium, angle, s, self.surface(x))[1]) for angle in angles]
        return ours, np.einsum("ankl,nl->nka", flat, normal).reshape(2 * len(x), -1)

    def transfer(self, s, angles, points):
        """Velocities [angles, points, 2] for a unit incident wave at one complex frequency, and the largest traction that is left between
        the points that have none, over rho c_s times the incident velocity."""
        ours, flat = self.tractions(s, angles, self.held)
        weight = np.sqrt(np.repeat(np.gradient(self.held) / self.normal(self.held)[:, 1], 2))[:, None]
        size = np.linalg.norm(ours, axis=0)
        strengths = np.linalg.lstsq(weight * ours / size, -weight * flat, rcond=1e-13)[0] / size[:, None]
        ours, flat = self.tractions(s, angles, self.checked)
        left = np.abs(ours @ strengths + flat).max() / (abs(s) * self.medium.density * self.medium.vs)
        ours = Forces(self.medium, s, points, self.sources).displacement()
        scattered = np.einsum("njik,jia->ank", ours, strengths.reshape(len(self.sources), 2, -1))
        return [flat_ground(self.medium, angle, s, points)[0] for angle in angles] + scattered, left

    def velocities(self, pulse, angles, points, times, period=5.0, highest=9.0):
        """Velocities [angles, times, points, 2], m/s, and the largest traction that is left at any frequency, as that of transfer() times
        the pulse's spectrum over its largest value.

        pulse    velocity of the incident wave at (0, 0) as a function of time, zero before t = 0
        period   of the sum over frequencies, s; highest: the last of these, Hz
        """
        damping = np.log(1e4) / period
        samples = np.arange(4096) * period / 4096
        frequencies = damping + 2j * np.pi * np.arange(int(highest * period) + 1) / period
        spectrum = pulse(samples) @ np.exp(-np.outer(samples, frequencies)) / 4096
        v = np.zeros((len(angles), len(times), len(points), 2))
        largest = 0.0
        for s, amplitude in zip(frequencies, spectrum):
            unit, left = self.transfer(s, angles, points)
            largest = max(largest, left * abs(amplitude) / np.abs(spectrum).max())
            v += (1.0 if s.imag == 0.0 else 2.0) * np.real((amplitude * np.exp(s * times))[None, :, None, None] * unit[:, None])
        return v, largest
