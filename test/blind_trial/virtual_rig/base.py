# The rubber component of the virtual rig: spring, Maxwell elements, dashpot and Berg friction, with parameters from the
# five numbers of a specification (Polach 2015; Berg 1997). This Python code is independent of the package.
"""Base components of the virtual rigs [SI]."""
import dataclasses
import math

import numpy as np
from scipy.optimize import brentq
from scipy.signal import lfilter


FRICTION_RATE = 500.0  # sampling rate of the logs [Hz]


class Unsolvable(ValueError):
    """Raised if the specification has no solution."""


def berg_response(z, z2, dead_band=0.0):
    """Return the force of Berg's element divided by F_max along the displacement z [m], starting from rest.

    A reversal counts if the motion has moved back from its extremum by more than the dead band [m].
    """
    out = np.empty_like(z)
    z_s, f_s, direction, extremum = float(z[0]), 0.0, 0, float(z[0])
    for i, x in enumerate(z.tolist()):
        if (x - extremum) * direction > 0.0:
            extremum = x
        elif abs(x - extremum) > dead_band:
            if direction != 0:
                f_s = _branch(extremum - z_s, f_s, direction, z2)
                z_s = extremum
            direction, extremum = (1 if x > extremum else -1), x
        out[i] = _branch(x - z_s, f_s, direction or (1 if x >= z_s else -1), z2)
    return out


def _branch(way, start, direction, z2):
    """Return the force divided by F_max at a distance `way` from the last reversal, where this ratio was `start`."""
    room = 1.0 - direction * start
    return start + way * room / (z2 * room + direction * way)


@dataclasses.dataclass
class Base:
    """A component: k0 [N/m], Maxwell stiffnesses k [N/m] and relaxation times tau [s], dashpot c0 [Ns/m], friction."""

    k0: float
    k: list
    tau: list
    c0: float = 0.0
    friction_force: float = 0.0
    friction_z2: float = 0.0
    dead_band: float = 0.0

    def parts(self, z, rate):
        """Return lists of the elastic force and of all other force [N], for logs z [m] with a sampling `rate` [Hz]."""
        elastic = [self.k0 * x for x in z]
        rest = [self._memory(x, rate) for x in z]
        return elastic, rest

    def force(self, z, rate):
        return [a + b for a, b in zip(*self.parts(z, rate))]

    def _memory(self, z, rate):
        rest = np.zeros_like(z)
        for k, tau in zip(self.k, self.tau):
            rest += k * maxwell_response(z, tau, rate)
        if self.c0 > 0.0:
            rest += self.c0 * np.gradient(z) * rate
        if self.friction_force > 0.0:
            rest += self.friction_force * friction_on_grid(z, self.friction_z2, rate, self.dead_band)
        return rest

    def tangent(self, z, rate):
        """Return the derivatives of the force with respect to all parameters, as a matrix per log."""
        matrices = []
        for x in z:
            columns = [x]
            for tau in self.tau:
                columns.append(maxwell_response(x, tau, rate))
                h = 0.05 * tau
                columns.append(maxwell_response(x, tau + h, rate) - maxwell_response(x, tau - h, rate))
            if self.c0 > 0.0:
                columns.append(np.gradient(x) * rate)
            if self.friction_force > 0.0:
                high, low = (berg_response(x, s * self.friction_z2) for s in (1.05, 0.95))
                columns += [high + low, high - low]
            matrices.append(np.stack(columns, axis=1))
        return matrices

    def scaled(self, rng, spread):
        """Return a copy in which each parameter has an independent factor, and the factors."""
        def factor():
            return float(np.exp(rng.choice([-1.0, 1.0]) * rng.uniform(0.4, 1.0) * math.log1p(spread)))
        factors = {"k0": factor(), "k": [factor() for _ in self.k], "tau": [factor() ** 2 for _ in self.tau]}
        copy = dataclasses.replace(
            self, k0=self.k0 * factors["k0"], k=[a * b for a, b in zip(self.k, factors["k"])],
            tau=[a * b for a, b in zip(self.tau, factors["tau"])])
        if self.friction_force > 0.0:
            factors["friction_force"], factors["friction_z2"] = factor(), factor()
            copy.friction_force *= factors["friction_force"]
            copy.friction_z2 *= factors["friction_z2"]
        if self.c0 > 0.0:
            factors["c0"] = factor()
            copy.c0 *= factors["c0"]
        return copy, factors


def maxwell_response(z, tau, rate):
    """Return the force of a Maxwell element divided by its stiffness, exact for linear motion [m] between samples."""
    decay = -1.0 / (rate * tau)
    gain = -np.expm1(decay) / -decay
    return lfilter([gain], [1.0, -math.exp(decay)], np.diff(z, prepend=z[0]))


def friction_on_grid(z, z2, rate, dead_band):
    """Return the force of Berg's element divided by F_max, computed at up to FRICTION_RATE and linear in between.

    The element stores the last reversal only, so a small reversal between two samples of a log would shift all later
    forces. The base must agree with its model, so it uses the samples of the log.
    """
    skip = max(1, int(round(rate / FRICTION_RATE)))
    if skip == 1:
        return berg_response(z, z2, dead_band)
    n = np.arange(len(z))
    return np.interp(n, n[::skip], berg_response(z[::skip], z2, dead_band))


def sheet_factor(rng, spread):
    """Return the factor by which a number of a data sheet is wrong.

    Its logarithm follows Student's t with four degrees of freedom, because some sheets are far off, and has the standard
    deviation `spread`.
    """
    return math.exp(spread * rng.standard_t(4) / math.sqrt(2.0))


# ---- from a specification to parameters -----------------------------------------------------------------------------


def from_specification(model, s):
    """Return the base for a `model` of a component file and a specification `s` (a dict, SI). Raises Unsolvable."""
    return {"maxwell": maxwell, "maxwell_dashpot": maxwell_dashpot, "berg": berg, "multi_maxwell": multi_maxwell}[model](s)


def multi_maxwell(s):
    """Return the base by Polach's Eqs. 17-22, with f_l = n f_h / 10^(n-1) for the low edge of the band."""
    n = int(s["maxwell_elements"])
    low_k, mid_k, high_k = s["static_stiffness"], s["dynamic_stiffness"], s["maximum_stiffness"]
    f_n, f_h = s["nominal_frequency"], s["high_frequency"]
    f_l = n * f_h / 10.0 ** (n - 1)
    edges = np.geomspace(f_l, f_h, n + 1)
    breaks = 0.5 * (edges[1:] + edges[:-1])
    if not low_k < mid_k < high_k:
        raise Unsolvable("stiffnesses do not increase")
    crossing = f_n * math.sqrt((high_k**2 - mid_k**2) / (mid_k**2 - low_k**2))
    if not breaks[0] * 1.02 < crossing < breaks[-1] / 1.02:
        raise Unsolvable("dynamic stiffness out of reach")

    def stiffnesses(log_alpha):
        weights = np.exp(log_alpha * np.arange(n - 1, -1, -1))
        return (high_k - low_k) * weights / weights.sum()

    def excess(log_alpha):
        r = 1j * f_n / breaks
        return abs(low_k + np.sum(stiffnesses(log_alpha) * r / (1 + r))) - mid_k

    if excess(-12.0) * excess(12.0) > 0.0:
        raise Unsolvable("no root")
    alpha = brentq(excess, -12.0, 12.0, xtol=1e-13)
    return Base(low_k, stiffnesses(alpha).tolist(), (1.0 / (2.0 * math.pi * breaks)).tolist())


def maxwell(s):
    """Return one Maxwell element from K_n at f_n and K_max: |K|^2 = (K_st^2 + u K_max^2)/(1+u), u = (f_n/f_b)^2."""
    low_k, mid_k, high_k = s["static_stiffness"], s["dynamic_stiffness"], s["maximum_stiffness"]
    if not low_k < mid_k < high_k:
        raise Unsolvable("stiffnesses do not increase")
    u = (mid_k**2 - low_k**2) / (high_k**2 - mid_k**2)
    return Base(low_k, [high_k - low_k], [math.sqrt(u) / (2.0 * math.pi * s["nominal_frequency"])])


def maxwell_dashpot(s):
    """Return the base whose K at f_n has the specified real and imaginary part, for a given break frequency."""
    low_k, mid_k, delta = s["static_stiffness"], s["dynamic_stiffness"], s["loss_angle"]
    f_n, r = s["nominal_frequency"], s["nominal_frequency"] / s["break_frequency"]
    k1 = (mid_k * math.cos(delta) - low_k) * (1 + r * r) / (r * r)
    c0 = (mid_k * math.sin(delta) - k1 * r / (1 + r * r)) / (2.0 * math.pi * f_n)
    if k1 <= 0.0 or c0 <= 0.0:
        raise Unsolvable("loss angle out of reach")
    return Base(low_k, [k1], [1.0 / (2.0 * math.pi * s["break_frequency"])], c0=c0)


def berg_steady_state(z0, z2):
    """Return peak force and loss energy of a settled loop of amplitude z0, both divided by F_max."""
    peak = (math.sqrt(z2 * z2 + z0 * z0 + 6.0 * z2 * z0) - z2 - z0) / (2.0 * z2)
    near = z2 * (1.0 + peak)
    return peak, 2.0 * (2.0 * z0 - near * (1.0 + peak) * math.log1p(2.0 * z0 / near))


def berg(s):
    """Return Berg friction and one Maxwell element, which share the loss energy at (f_n, A_n) four to one."""
    low_k, mid_k, delta, a = s["static_stiffness"], s["dynamic_stiffness"], s["loss_angle"], s["nominal_amplitude"]
    share = 0.2
    r = s["nominal_frequency"] / s["break_frequency"]
    loss = mid_k * math.sin(delta)
    k1 = share * loss * (1 + r * r) / r
    stiffness = math.sqrt(mid_k**2 - (share * loss) ** 2) - k1 * r * r / (1 + r * r) - low_k
    energy = (1.0 - share) * math.pi * loss / stiffness

    def excess(log_z2):
        peak, lost = berg_steady_state(a, a * math.exp(log_z2))
        return lost / (peak * a) - energy

    if stiffness <= 0.0:
        raise Unsolvable("nothing left for the friction")
    if excess(-9.0) * excess(6.0) > 0.0:
        raise Unsolvable("loss angle out of reach")
    z2 = a * math.exp(brentq(excess, -9.0, 6.0, xtol=1e-12))
    return Base(low_k, [k1], [1.0 / (2.0 * math.pi * s["break_frequency"])],
                friction_force=stiffness * a / berg_steady_state(a, z2)[0], friction_z2=z2)
