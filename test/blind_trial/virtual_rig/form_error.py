# Form errors, because rubber follows no textbook law. Each law of a rig is multiplied by a smooth random function of
# displacement, speed and level of motion, mixed with another law of the effect, and drifts. A linear base has more
# relaxation than its model. On exact rigs, the fitted numbers of the judgement would be overconfident.
"""Form errors: differences of the laws of a rig from the laws of all candidates."""
import dataclasses

import numpy as np

from .base import Base, maxwell_response

ONE_FORM = ("inertia", "time_delay", "force_offset", "force_drift", "sensor_gain")  # these have one form on any rig
WAVES = 5              # waves of a random function
EXTRA_TIMES = (0.005, 10.0)  # range of the relaxation times that a model lacks [s]
LEVEL_TIME = 2.0       # averaging time of the level of motion [s]


class SmoothFactor:
    """1 plus a smooth random function of scaled displacement, speed and level, whose RMS is about `size`."""

    def __init__(self, rng, scale, size):
        self.scale, self.size = scale, size
        self.waves = rng.normal(0.0, 1.2, (WAVES, 3))
        self.phases = rng.uniform(0.0, 2.0 * np.pi, WAVES)
        self.weights = rng.normal(0.0, 1.0, WAVES)
        self.weights *= np.sqrt(2.0) / np.linalg.norm(self.weights)

    def __call__(self, z, rate):
        speed = np.gradient(z) * rate
        window = max(1, int(LEVEL_TIME * rate))
        sums = np.concatenate(([0.0], np.cumsum(z**2)))
        first = np.maximum(np.arange(1, len(z) + 1) - window, 0)
        level = np.sqrt((sums[1:] - sums[first]) / (np.arange(1, len(z) + 1) - first))
        sizes = (z / self.scale.amplitude, speed / (2.0 * self.scale.speed), level / self.scale.amplitude)
        total = np.zeros_like(z)
        for wave, phase, weight in zip(self.waves, self.phases, self.weights):
            total += weight * np.cos(sum(w * x for w, x in zip(wave, sizes)) + phase)
        return 1.0 + np.clip(self.size * total, -0.9, 3.0)


def drifting(rng, samples, rate, fine_rate, size):
    """Return 1 plus a slow drift of about `size` over a log, with half a wave to one and a half waves."""
    t = np.arange(samples) * fine_rate / rate  # the same on every grid
    length = max(t[-1], 1.0)
    return 1.0 + size * np.sin(np.pi * rng.uniform(1.0, 3.0) * t / length + rng.uniform(0.0, 2.0 * np.pi))


def rms(forces):
    return float(np.sqrt(np.mean([np.mean(x**2) for x in forces])))


def inexact(rng, scale, effect, other, size):
    """Return the effect with a form error, if it is a force parallel to the component that depends on the motion.

    `other` is a second law of the same effect, mixed in with a share of up to 1, or None.
    """
    if effect.stage != "parallel" or effect.name in ONE_FORM:
        return effect
    factor, seed = SmoothFactor(rng, scale, size), int(rng.integers(2**31))
    drift, share, exact = rng.uniform(0.0, 0.3 * size), rng.uniform(0.2, 1.0), effect.function
    mixed = other is not None and other.stage == "parallel"
    ratio = []

    def run(z, rate):
        forces = exact(z, rate)
        if mixed:
            others = other.function(z, rate)
            if not ratio:
                ratio.append(share * rms(forces) / max(rms(others), 1e-30))
            forces = [a + ratio[0] * b for a, b in zip(forces, others)]
        course = np.random.default_rng(seed)
        return [f * factor(x, rate) * drifting(course, len(x), rate, scale.rate, drift) for f, x in zip(forces, z)]

    law = effect.law + ("+" + other.law if mixed else "") + ", inexact"
    parameters = dict(effect.parameters, form_error=size, drift=drift)
    return dataclasses.replace(effect, law=law, function=run, parameters=parameters)


@dataclasses.dataclass
class OffLadder(Base):
    """A linear base with more relaxation than its model, given by `extra_k` [N/m] and `extra_tau` [s]."""

    extra_k: list = dataclasses.field(default_factory=list)
    extra_tau: list = dataclasses.field(default_factory=list)

    def _memory(self, z, rate):
        rest = super()._memory(z, rate)
        for k, tau in zip(self.extra_k, self.extra_tau):
            rest += k * maxwell_response(z, tau, rate)
        return rest


def off_ladder(rng, base, ruler, wanted):
    """Return the base with four more Maxwell elements that leave the visible gap `wanted`, measured by the ruler.

    A larger gap would be the effect `relaxation`. The elements have at most a tenth of the static stiffness.
    """
    k = 0.1 * base.k0 * rng.dirichlet(np.ones(4))
    tau = np.exp(rng.uniform(*np.log(EXTRA_TIMES), 4))
    fields = {f.name: getattr(base, f.name) for f in dataclasses.fields(Base)}
    most = OffLadder(**fields, extra_k=k.tolist(), extra_tau=tau.tolist())
    force = most.force(ruler.rig.z, ruler.rig.rate)
    left = ruler.visible([a - b for a, b in zip(force, ruler.reference)], force)
    return dataclasses.replace(most, extra_k=(k * min(wanted / left, 1.0)).tolist())
