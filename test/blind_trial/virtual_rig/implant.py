# Known effects implanted in measured logs: a sealed law, computed from the measured displacement, is added to the
# measured force or alters either channel. What the machine itself does stays, and is seen in a control case.
"""Implants in measured logs, which are read where they lie and written nowhere but to the folder of the cases."""
import dataclasses
import json
import os

import numpy as np
from scipy.signal import savgol_filter

from . import case, sealed
from .base import Base
from .effect import Scale
from .laws import draw

SET = 43
SIZES = (0.12, 0.25)  # gaps, of the force's standard deviation, that no spring and dashpot can hide
UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "N": 1.0, "kN": 1e3, "MN": 1e6}


@dataclasses.dataclass
class Machine:
    """Logs of one machine, and what it is not known to do by itself."""

    folder: str
    logs: tuple
    hold_out: tuple
    dashpot: bool     # whether its simple model has one
    effects: tuple    # that may be implanted


MACHINES = {
    "bearing": Machine("hdrb", ("hdrb_shear_4amplitudes.csv",), (), True,
                       ("time_delay", "force_drift", "force_offset", "bump_stop", "free_play", "asymmetric_stiffness",
                        "inertia")),
    "damper": Machine("mr_damper", ("low_1.csv", "low_4.csv", "low_7.csv"), ("low_10.csv",), True,
                      ("progressive_stiffness", "asymmetric_stiffness", "bump_stop", "inertia", "force_drift")),
    "energised_damper": Machine("mr_damper", ("high_1.csv", "high_3.csv", "high_5.csv", "high_7.csv"), ("high_9.csv",),
                                True, ("progressive_stiffness", "bump_stop", "inertia", "force_drift")),
    "film": Machine("adhesive_film", ("shear_relaxation_1.csv", "shear_relaxation_2.csv"), ("shear_relaxation_5.csv",),
                    False, ("force_offset", "force_drift", "bump_stop", "time_delay")),
    "seal": Machine("rod_seal", ("o_ring_3_bar.csv",), (), True,
                    ("progressive_stiffness", "bump_stop", "viscous_damping", "force_drift")),
}
# What a motion to one side of zero cannot tell apart.
ALIKE_ON_ONE_SIDE = ("progressive_stiffness", "asymmetric_stiffness")


def data_folder():
    """Where measured logs lie: RUBBER_SUSPENSION_DATA, or else data/ of the package."""
    package = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    return os.environ.get("RUBBER_SUSPENSION_DATA") or os.path.join(package, "data")


def available():
    """The machines whose logs are all there."""
    return [name for name, m in MACHINES.items()
            if all(os.path.isfile(os.path.join(data_folder(), m.folder, f)) for f in m.logs + m.hold_out)]


def plan(cases, seed):
    """(machine, effect, gap) of each implant, after a control without effect for each machine that is in use."""
    rng = np.random.default_rng(np.random.SeedSequence([SET, seed, 10**6]))
    found = available()
    deals = {name: rng.permutation(MACHINES[name].effects) for name in found}
    implants = []
    for i in range(cases if found else 0):
        name, turn = found[i % len(found)], i // len(found)
        effects = deals[name]
        size = SIZES[(turn // len(effects) + turn) % len(SIZES)]
        implants.append((name, str(effects[turn % len(effects)]), size))
    return [(name, None, 0.0) for name in found if any(name == i[0] for i in implants)] + implants


# ---- measured logs ---------------------------------------------------------------------------------------------------


class Measured:
    """The logs of a machine at their stamps, and on one even grid, where the displacement is smoothed."""

    def __init__(self, machine):
        paths = [os.path.join(data_folder(), machine.folder, f) for f in machine.logs + machine.hold_out]
        self.t, self.z, self.force = zip(*(read_log(path) for path in paths))
        self.rate = 1.0 / min(float(np.median(np.diff(t))) for t in self.t)
        self.grids = [np.arange(t[0], t[-1] + 0.5 / self.rate, 1.0 / self.rate) for t in self.t]
        self.smooth = [savgol_filter(np.interp(g, t, z), 9, 3) for g, t, z in zip(self.grids, self.t, self.z)]
        self.even_force = [np.interp(g, t, f) for g, t, f in zip(self.grids, self.t, self.force)]
        self.base = self._simple_model(machine.dashpot)
        self.scale = self._sizes(len(machine.logs))

    def _columns(self, z, dashpot):
        """Spring, dashpot where there is one, zero."""
        dashpots = [np.gradient(z) * self.rate] if dashpot else []
        return np.stack([z, *dashpots, np.ones_like(z)], axis=1)

    def _simple_model(self, dashpot):
        """Spring and dashpot by least squares, to two digits, as somebody would write them down."""
        matrix = np.concatenate([self._columns(z, dashpot) for z in self.smooth])
        k, *c, _ = np.linalg.lstsq(matrix, np.concatenate(self.even_force), rcond=None)[0]
        spring = max(k, 0.02 * np.std(np.concatenate(self.even_force)) / np.std(np.concatenate(self.smooth)))
        return Base(float(f"{spring:.2g}"), [], [], c0=float(f"{max(c[0], 0.0):.2g}") if c else 0.0)

    def _sizes(self, training):
        peaks = [float(np.max(np.abs(z))) for z in self.smooth]
        speed = float(np.sqrt(np.mean([np.mean(np.gradient(z) ** 2) for z in self.smooth]))) * self.rate
        spread = float(np.mean([np.std(z) for z in self.smooth]))
        force = float(np.mean([np.std(f) for f in self.force]))
        return Scale(stiffness=force / spread, amplitude=max(peaks), least_amplitude=min(peaks), speed=speed,
                     force=force, top_frequency=2.0 * speed / spread / (2.0 * np.pi), training=training,
                     lengths=[2 * len(g) for g in self.grids], rate=2.0 * self.rate)

    @property
    def one_sided(self):
        z = np.concatenate(self.smooth)
        return abs(np.max(z) + np.min(z)) > 0.5 * np.ptp(z)

    def at_stamps(self, changes):
        return [np.interp(t, g, x) for t, g, x in zip(self.t, self.grids, changes)]

    def with_effect(self, effect, strength):
        """(changes of the displacement, changes of the force) on the even grid; by the stage of the effect."""
        nothing = [np.zeros_like(z) for z in self.smooth]
        if effect.stage in ("parallel", "added"):
            return nothing, [strength * x for x in effect.function(self.smooth, self.rate)]
        if effect.stage == "transducer":
            return nothing, [a - b for a, b in zip(effect.function(self.even_force, self.rate, strength),
                                                   self.even_force)]
        if effect.stage == "play":
            return [before_play(effect, z, strength) - z for z in self.smooth], nothing
        raise ValueError(f"{effect.law} cannot be implanted at the stage {effect.stage}")

    def visible_gap(self, changes, effect_name):
        """What the changes add that no spring, dashpot or zero can hide, over the force's standard deviation."""
        left = []
        for z, f, dz, df in zip(self.smooth, self.force, *changes):
            acting = df - self.base.k0 * dz - self.base.c0 * np.gradient(dz) * self.rate
            matrix = self._columns(z, self.base.c0 > 0.0)
            if effect_name == "force_offset":  # which is a zero
                matrix = matrix[:, :-1]
            rest = acting - matrix @ np.linalg.lstsq(matrix, acting, rcond=None)[0]
            left.append(np.mean(rest**2) / np.var(f))
        return float(np.sqrt(np.mean(left)))


def read_log(path):
    """Time [s], displacement [m], force [N]."""
    with open(path, encoding="utf-8") as file:
        units = [column.split("_")[-1] for column in file.readline().strip().split(",")]
    t, z, f = np.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1, 2)).T
    return t, z * UNITS[units[1]], f * UNITS[units[2]]


def before_play(effect, z, strength):
    """The motion that reaches the component as z through the play."""
    outer = np.linspace(-1.0, 1.0, 4001) * (1.1 * np.max(np.abs(z)) + 3.0 * strength)
    through = effect.function([outer], 1.0, strength)[0]
    return np.interp(z, through + 1e-9 * outer, outer)


# ---- cases -----------------------------------------------------------------------------------------------------------


def choose(rng, measured, name, wanted):
    """An effect of that name and its changes, at a strength with the wanted visible gap. Raises ValueError."""
    for _ in range(20):
        effect = draw(rng, measured.scale, name, True, sealed.LAWS)
        low, high = 1e-6 * effect.strongest, 20.0 * effect.strongest
        if measured.visible_gap(measured.with_effect(effect, high), name) < wanted:
            continue
        for _ in range(40):
            strength = float(np.sqrt(low * high))
            changes = measured.with_effect(effect, strength)
            low, high = (strength, high) if measured.visible_gap(changes, name) < wanted else (low, strength)
        return effect, strength, changes
    raise ValueError(f"{name} cannot be implanted with a gap of {wanted}")


def write(seed, number, planned, output, labels):
    """Write the case and its label; returns its name."""
    machine_name, effect_name, wanted = planned
    measured, machine = Measured(MACHINES[machine_name]), MACHINES[machine_name]
    rng = np.random.default_rng(np.random.SeedSequence([SET, seed, number]))
    name = f"control_{machine_name}" if effect_name is None else f"implant_{number:03d}"
    label = {"case": name, "set": "implants", "seed": seed, "machine": machine_name,
             "kind": "control" if effect_name is None else "implant", "control": f"control_{machine_name}",
             "effects": [effect_name] if effect_name else [], "accepted": [], "wanted": wanted}
    z, force = list(measured.z), list(measured.force)
    if effect_name:
        effect, strength, changes = choose(rng, measured, effect_name, wanted)
        z, force = ([a + b for a, b in zip(x, measured.at_stamps(dx))] for x, dx in zip((z, force), changes))
        alike = measured.one_sided and effect_name in ALIKE_ON_ONE_SIDE
        label.update(law=effect.law, strength=strength, parameters=effect.parameters,
                     visible=measured.visible_gap(changes, effect_name),
                     accepted=list(ALIKE_ON_ONE_SIDE if alike else [effect_name]))
    write_files(os.path.join(output, name), machine_name, measured, len(machine.logs), z, force)
    os.makedirs(labels, exist_ok=True)
    with open(os.path.join(labels, name + ".json"), "w", encoding="utf-8") as file:
        json.dump(label, file, indent=1)
    return name


def write_files(folder, component, measured, training, z, force):
    os.makedirs(folder, exist_ok=True)
    files = [f"log_{i + 1}.csv" if i < training else f"hold_out_{i + 1 - training}.csv" for i in range(len(z))]
    for path, *columns in zip(files, measured.t, z, force):
        np.savetxt(os.path.join(folder, path), np.stack(columns, axis=1), "%.9g", ",", comments="",
                   header="time_s,displacement_m,force_N")
    with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
        file.write(case.elements_yaml(component, case.element_entries(measured.base, 0.0)))
    with open(os.path.join(folder, "case.json"), "w", encoding="utf-8") as file:
        json.dump({"component": component, "logs": files[:training], "hold_out": files[training:]}, file, indent=1)
