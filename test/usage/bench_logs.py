#!/usr/bin/python3
# The virtual bench of docs/example.md: a bush that its data sheet does not describe completely, on a bench that writes
# German text. It shares no code with the package.
"""Write the specification of a bush and logs of a virtual bench: bench_logs.py EFFECT FOLDER."""
import argparse
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "blind_trial"))
from virtual_rig import base  # noqa: E402

RATE = 500.0  # [Hz]
SPECIFICATION = {"static_stiffness": 1.6e6, "dynamic_stiffness": 2.0e6, "nominal_frequency": 5.0,
                 "maximum_stiffness": 2.6e6, "high_frequency": 25.0, "maxwell_elements": 5}
COMPONENT = """components:
  gummilager:
    model: multi_maxwell
    specification:
      static_stiffness: 1.6 kN/mm
      dynamic_stiffness: 2.0 kN/mm
      nominal_frequency: 5 Hz
      maximum_stiffness: 2.6 kN/mm
      high_frequency: 25 Hz
"""


def eased(z):
    """Make the motion start and end with a second of standstill and a second of transition."""
    n = int(RATE)
    ramp = 0.5 - 0.5 * np.cos(np.pi * np.arange(n) / n)
    z[:n], z[-n:] = z[:n] * ramp, z[-n:] * ramp[::-1]
    return np.concatenate([np.zeros(n), z, np.zeros(n)])


def programme():
    """Return the displacements [m]: a sweep at the highest speed, sines at three levels, a track-like test."""
    t = np.arange(int(30 * RATE)) / RATE
    rise = np.log(20.0 / 0.3) / t[-1]
    frequency = 0.3 * np.exp(rise * t)
    logs = {"sweep": np.minimum(5e-3, 0.06 / (2 * np.pi * frequency)) * np.sin(2 * np.pi * (frequency - 0.3) / rise)}
    for f in (1, 3, 5):
        levels = np.array([0.3e-3, 1.0e-3, min(5e-3, 0.1 / (2 * np.pi * f))])
        level = np.interp(t, [0, 9, 10, 19, 20, 30], levels.repeat(2))  # one second of transition between levels
        logs[f"sinus_{f}Hz"] = level * np.sin(2 * np.pi * f * t)
    rng = np.random.default_rng(5)
    lines = rng.uniform(0.3, 8.0, 30)
    test = sum(np.sin(2 * np.pi * f * t + p) / f for f, p in zip(lines, rng.uniform(0, 6.28, 30)))
    logs["pruefung"] = 4.8e-3 * test / np.max(np.abs(test))
    return {name: eased(z) for name, z in logs.items()}


def dahl(z, limit=250.0, length=0.15e-3):
    """Return Dahl's friction: dF/dz = limit/length (1 - F/limit sign(dz))."""
    force = np.zeros_like(z)
    for i, step in enumerate(np.diff(z), 1):
        side = 1.0 if step > 0.0 else -1.0
        force[i] = side * limit + (force[i - 1] - side * limit) * np.exp(-abs(step) / length)
    return force


def stop(z):
    """Return the force of a stop of 3 kN/mm beyond 4 mm on both sides."""
    return 3e6 * np.sign(z) * np.maximum(np.abs(z) - 4e-3, 0.0)


def warm(z, force):
    """Return the force of warming rubber: 1 % less per 15 J of heat, which decays with a time constant of 120 s."""
    loss = np.cumsum(force * np.gradient(z))
    heat, decay = np.zeros_like(z), np.exp(-1.0 / (RATE * 120.0))
    smooth = np.convolve(np.diff(loss, prepend=0.0), np.full(int(RATE), 1.0 / RATE), "same")
    for i in range(1, len(z)):
        heat[i] = max(0.0, decay * heat[i - 1] + smooth[i])
    return force * (1.0 - 0.01 * heat / 15.0)


EFFECTS = {"friction": lambda z, f: f + dahl(z), "stop": lambda z, f: f + stop(z), "heating": warm,
           "gain": lambda z, f: 1.05 * f, "both": lambda z, f: f + dahl(z) + stop(z)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("effect", choices=EFFECTS)
    parser.add_argument("folder")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    bush, rng = base.from_specification("multi_maxwell", SPECIFICATION), np.random.default_rng(1)
    for name, z in programme().items():
        force = EFFECTS[arguments.effect](z, bush.force([z], RATE)[0]) + 5.0 * rng.standard_normal(len(z))
        rows = zip(np.arange(len(z)) / RATE, 1e3 * z + 1e-3 * rng.standard_normal(len(z)), 1e-3 * force)
        text = "Zeit [s];Weg [mm];Kraft [kN]\n" + "".join("%.3f;%.5f;%.5f\n" % row for row in rows).replace(".", ",")
        with open(os.path.join(arguments.folder, name + ".csv"), "w", encoding="utf-8") as file:
            file.write(text)
    with open(os.path.join(arguments.folder, "component.yaml"), "w", encoding="utf-8") as file:
        file.write(COMPONENT)


if __name__ == "__main__":
    main()
