# Sealed laws of what depends on the displacement, or on it and its speed where a stop is hit.
# Arguments are displacements over the largest one; strengths are scaled from outside.
"""Progressive and asymmetric stiffness, stops, play."""
import numpy as np
from scipy.special import erf

from ..laws import Effect, elastic_effect, play_effect, stop_effect
from .registry import law


@law("progressive_stiffness", "knowles")
def knowles(rng, scale, name, law_name):
    """Generalised neo-Hookean shear (Knowles 1977, Int. J. Fracture 13): x (1 + b x^2 / n)^(n - 1) - x."""
    n, b = rng.uniform(1.4, 2.6), rng.uniform(0.5, 3.0)
    return elastic_effect(name, law_name, lambda x: x * (1.0 + b * x**2 / n) ** (n - 1.0) - x, scale, {"n": n, "b": b})


@law("progressive_stiffness", "tissue")
def tissue(rng, scale, name, law_name):
    """x (exp(a x^2) - 1), after Fung 1967 (Am. J. Physiol. 213)."""
    a = rng.uniform(0.6, 2.2)
    return elastic_effect(name, law_name, lambda x: x * np.expm1(a * np.minimum(x**2, 1.5)), scale, {"a": a})


@law("asymmetric_stiffness", "toda")
def toda(rng, scale, name, law_name):
    """The exponential bond of Toda 1967 (J. Phys. Soc. Japan 22), less its tangent: stiff one way, soft the other."""
    s = rng.uniform(0.4, 1.3) * rng.choice([-1.0, 1.0])
    return elastic_effect(name, law_name, lambda x: (np.expm1(s * np.clip(x, -1.5, 1.5)) - s * x) / s, scale, {"s": s})


@law("asymmetric_stiffness", "wound_liner")
def wound_liner(rng, scale, name, law_name):
    """The stiffness differs by direction near the centre alone, as where a liner is clamped on one side."""
    w, side = rng.uniform(0.3, 0.9), rng.choice([-1.0, 1.0])
    return elastic_effect(name, law_name, lambda x: side * x**2 / (x**2 + w**2), scale, {"w": w, "side": side}, 0.7)


@law("bump_stop", "foam")
def foam(rng, scale, name, law_name):
    """Cellular bumper: it gives in at first, then densifies (Rusch 1969, J. Appl. Polymer Sci. 13)."""
    solid, plateau, early = rng.uniform(0.55, 0.9), rng.uniform(0.05, 0.2), rng.uniform(0.02, 0.08)

    def contact(d):
        d = np.clip(d, 0.0, 0.9 * solid)
        return plateau * -np.expm1(-d / early) + (d / solid) ** 2 / (1.0 - d / solid)
    return stop_effect(rng, scale, name, law_name, contact, {"solid": solid, "plateau": plateau, "early": early})


@law("bump_stop", "lossy_impact")
def lossy_impact(rng, scale, name, law_name):
    """d^1.5 (1 + loss * closing speed), never pulling (Hunt and Crossley 1975, J. Appl. Mech. 42)."""
    at, loss = rng.uniform(0.55, 0.85), rng.uniform(0.1, 0.5)
    sides = ((1.0, -1.0), (1.0,), (-1.0,))[int(rng.integers(3))]

    def run(z, rate):
        out = []
        for x in z:
            speed = np.gradient(x) * rate / scale.speed
            out.append(sum(side * np.maximum(side * x / scale.amplitude - at, 0.0) ** 1.5
                           * np.maximum(1.0 + loss * side * speed, 0.0) for side in sides) / (1.0 - at) ** 1.5)
        return out
    return Effect(name, law_name, "parallel", run, 6.0 * scale.stiffness * scale.amplitude,
                  {"at": at * scale.amplitude, "loss": loss, "sides": sides})


@law("free_play", "worn_pin")
def worn_pin(rng, scale, name, law_name):
    """A pin in a hole worn like a bell: z - g erf(sqrt(pi) z / 2 g), which has no edge anywhere."""
    return play_effect(name, law_name, scale, lambda z, g: z - g * erf(0.5 * np.sqrt(np.pi) * z / max(g, 1e-15)), {})


@law("free_play", "squeezed_film")
def squeezed_film(rng, scale, name, law_name):
    """A lip of rubber fills the clearance and stiffens with a power of the displacement until it is flat."""
    n = rng.uniform(2.0, 4.0)

    def run(z, g):
        inside = np.clip(z / max(g, 1e-15), -1.0, 1.0)
        return z - g * inside + g * np.sign(inside) * np.abs(inside) ** n / n
    return play_effect(name, law_name, scale, run, {"n": n})
