"""What the simpler laws must give, in closed form. Stresses in Pa, compression positive; angles in degrees.

Mohr-Coulomb: N = (1 + sin phi)/(1 - sin phi). Simple shear of a perfectly plastic soil without elastic volume change at
the limit (Davis 1968): tau = (sigma_v sin phi cos psi + c cos phi cos psi)/(1 - sin phi sin psi).
"""

import numpy as np


def flow_number(friction):
    sine = np.sin(np.radians(friction))
    return (1.0 + sine) / (1.0 - sine)


def compression_strength(lateral, cohesion, friction):
    """sigma_1 at failure."""
    n = flow_number(friction)
    return n * lateral + 2.0 * cohesion * np.sqrt(n)


def simple_shear_strength(vertical, cohesion, friction, dilation=0.0):
    phi, psi = np.radians(friction), np.radians(dilation)
    strength = (vertical * np.sin(phi) + cohesion * np.cos(phi)) * np.cos(psi)
    return strength / (1.0 - np.sin(phi) * np.sin(psi))


def oedometer_modulus(young, poisson):
    return young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))


def hyperbola(amplitude, reference_strain):
    """G/Gmax and Masing damping of tau = G gamma/(1 + gamma/gamma_r)."""
    x = amplitude / reference_strain
    damping = 4.0 / np.pi * (1.0 + 1.0 / x) * (1.0 - np.log1p(x) / x) - 2.0 / np.pi
    return 1.0 / (1.0 + x), damping
