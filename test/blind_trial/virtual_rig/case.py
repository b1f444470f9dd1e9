# One case of the trial: draws component, programme, effects and noise, runs the rig, and writes the folder and the
# label. All draws depend on seed and number only. The label is in another folder, hidden from the diagnosis.
"""Cases of the blind trial."""
import dataclasses
import json
import math
import os

import numpy as np

from . import base as bases
from . import excitation, form_error, laws
from .effect import Scale
from .rig import Rig, Ruler, gap

RATE = 500.0          # sampling rate of the logs [Hz]
FINE = 4              # samples of the rig's grid per sample of a log
TRAINING, HOLD_OUT = 6, 2
SEEN = TRAINING + HOLD_OUT  # logs that a diagnosis sees
BANK = 11             # part of all seeds
# For rigs with form error: RMS error of each law, probability of a mixed law, gap that re-estimation of the base leaves.
FORM_ERROR, MIXED, BASE_ERROR = (0.10, 0.30), 0.5, (0.001, 0.01)


NAMES = ("left_secondary", "right_secondary", "bush_1", "engine_mount", "emergency_spring", "chevron", "traction_rod",
         "primary_spring", "torsion_bush", "yaw_damper_mount", "strut_mount", "conical_spring")

# Families of components, with ranges of stiffness [N/m] and of the largest amplitude [m].
FAMILIES = (((1e5, 6e5), (3e-4, 1.5e-3)), ((8e5, 6e6), (3e-4, 2e-3)), ((5e5, 1.2e7), (1e-3, 6e-3)),
            ((3e5, 3e6), (5e-3, 2e-2)))

# Pairs that no log can distinguish from a single effect, or whose effects cancel each other.
HOPELESS = ({"relaxation", "creep"}, {"relaxation", "series_compliance"}, {"viscous_damping", "time_delay"},
            {"relaxation", "viscous_damping"}, {"creep", "force_drift"}, {"force_offset", "asymmetric_stiffness"},
            {"creep", "series_compliance"}, {"force_offset", "force_drift"}, {"progressive_stiffness", "bump_stop"},
            {"friction", "backlash"}, {"inertia", "fluid_inertia"}, {"relaxation", "payne_effect"},
            {"friction", "payne_effect"})  # in these last four, the second effect contains the first
# Coupling is named only if no two effects explain the gap, and a contact needs its own programmes. Neither is paired.
ALONE = ("rate_amplitude_coupling", "lift_off")
PAIRED = [effect for effect in laws.EFFECTS if effect not in ALONE]


def plan(cases, seed):
    """Shuffle the kinds of all cases: 60 % single effects, 12 % pairs, 8 % none, 8 % parameter error, 12 % unknown."""
    rng = np.random.default_rng(np.random.SeedSequence([BANK, seed, 10**6]))
    quota = {"single": 0.60, "pair": 0.12, "none": 0.08, "parameter_error": 0.08, "unknown": 0.12}
    kinds = []
    for kind, share in quota.items():
        kinds += [kind] * int(round(share * cases))
    kinds = (kinds + ["single"] * cases)[:cases]
    order = {"single": list(rng.permutation(laws.EFFECTS)), "unknown": list(rng.permutation(laws.UNKNOWN))}
    counters = {"single": 0, "unknown": 0}
    out = []
    for kind in kinds:
        if kind in order:
            effects = (str(order[kind][counters[kind] % len(order[kind])]),)
            small = kind == "single" and (counters[kind] // len(laws.EFFECTS)) % 4 == 0
            counters[kind] += 1
        elif kind == "pair":
            effects, small = draw_pair(rng), False
        else:
            effects, small = (), False
        out.append((kind, effects, small))
    return [out[i] for i in rng.permutation(len(out))]


def draw_pair(rng):
    while True:
        pair = tuple(str(e) for e in rng.choice(PAIRED, size=2, replace=False))
        if set(pair) not in HOPELESS:
            return pair


# ---- the component ---------------------------------------------------------------------------------------------------


def draw_specification(rng, effects):
    """Draw (model, specification, base, amplitude) of a component that its model describes exactly."""
    model, extra = draw_model(rng, effects)
    for _ in range(1000):
        family = FAMILIES[int(rng.integers(len(FAMILIES)))]
        static = laws.log_uniform(rng, *family[0])
        amplitude = laws.log_uniform(rng, *family[1])
        s = {"static_stiffness": static, "dynamic_stiffness": static * rng.uniform(1.12, 1.6),
             "nominal_frequency": float(rng.uniform(2.0, 10.0))}
        s["maximum_stiffness"] = s["dynamic_stiffness"] * rng.uniform(1.06, 1.35)
        s.update(extra)
        if model == "multi_maxwell":
            s["high_frequency"] = float(rng.uniform(18.0, 45.0))
        elif model != "maxwell":
            del s["maximum_stiffness"]
            s["loss_angle"] = float(rng.uniform(0.06, 0.16))
            s["break_frequency"] = s["nominal_frequency"] * laws.log_uniform(rng, 0.12, 1.0)
        if model == "berg":
            s["nominal_amplitude"] = amplitude * rng.uniform(0.3, 0.8)
        s = {k: v if k == "maxwell_elements" else float(f"{v:.5g}") for k, v in s.items()}
        try:
            return model, s, bases.from_specification(model, s), amplitude
        except bases.Unsolvable:
            continue
    raise RuntimeError("no component could be drawn")


def draw_model(rng, effects):
    """Draw a model without the effects. Additional Maxwell elements show best on models with few."""
    names, weights = ["multi_maxwell_5", "multi_maxwell_3", "maxwell", "berg", "maxwell_dashpot"], [5, 4, 1.5, 1.5, 0.5]
    if "relaxation" in effects:
        weights = [0.7, 2.0, 5, 1.0, 0]
    if "series_compliance" in effects:
        weights = [1.5, 1.0, 0.5, 5, 0]
    if "lift_off" in effects:
        weights[4] = 0  # a dashpot would act as behind a compliance
    if "friction" in effects:
        weights[3] = 0
    if "viscous_damping" in effects:
        weights[4] = 0
    name = str(rng.choice(names, p=np.array(weights) / sum(weights)))
    if name.startswith("multi_maxwell"):
        return "multi_maxwell", {"maxwell_elements": int(name[-1])}
    return name, {}


def wrong_specification(rng, model, s, spread):
    """Return a solvable specification with values off by about `spread`, the factors of the values, and its base."""
    for _ in range(200):
        factors = {k: bases.sheet_factor(rng, spread) for k in s
                   if k not in ("maxwell_elements", "nominal_amplitude")}
        other = {k: float(f"{v * factors.get(k, 1.0):.5g}") if k != "maxwell_elements" else v for k, v in s.items()}
        try:
            return other, factors, bases.from_specification(model, other)
        except bases.Unsolvable:
            continue
    return dict(s), {}, bases.from_specification(model, s)


# ---- the programme ---------------------------------------------------------------------------------------------------


def draw_logs(rng, amplitude, further, duration):
    """Return the displacements on the fine grid, their kinds, the programme, the repeated log and the actuator."""
    rig = excitation.Actuator(rng, amplitude, RATE * FINE)
    kinds, held, programme, repeat = excitation.draw_programme(rng, rig, TRAINING, HOLD_OUT + further)
    z = [excitation.make(rng, rig, k, duration * float(int(rng.uniform(30.0, 60.0)))) for k in kinds + held]
    if repeat is not None:
        z[repeat[1]] = z[repeat[0]].copy()
    return z, kinds, held, programme, repeat, rig


def loaded_to_one_side(rng, z, amplitude, rate):
    """Shift each log to a preload of one sign, because without a preload no contact stays closed."""
    side = rng.choice([-1.0, 1.0])
    rise = 0.5 - 0.5 * np.cos(np.pi * np.minimum(np.arange(max(len(x) for x in z)) / rate, 1.0))
    return [x + side * amplitude * rng.uniform(0.4, 0.9) * rise[:len(x)] for x in z]


# ---- the whole case --------------------------------------------------------------------------------------------------


def build(seed, number, kind, effect_names, small, further=0, duration=1.0, inexact=False):
    """Build a case in memory: a dict with logs, component file and label.

    `further` is the number of logs of the same rig that are hidden from the diagnosis, `duration` a share of the usual
    30 to 60 s. `inexact` rigs have form errors, and a base with more relaxation than its model.
    """
    rng = np.random.default_rng(np.random.SeedSequence([BANK, seed, number]))
    wanted = rng.uniform(0.028, 0.034) if small else laws.log_uniform(rng, 0.05, 0.30)
    by_visible = bool(rng.random() < 0.7)
    form = np.random.default_rng([BANK, seed, number, 1]) if inexact else None
    attempts = (arrange(rng, effect_names, wanted, by_visible, further, duration, form) for _ in range(4))
    case = dict(best_of(attempts, wanted, 0.85 if by_visible else 0.3), rng=rng, kind=kind, wanted=wanted,
                by_visible=by_visible, further=further)
    # One component in eight is described by its elements. With friction the share is larger.
    share = {"berg": 0.6, "maxwell_dashpot": 0.3}.get(case["model"], 0.12)
    case["as_elements"] = bool(rng.random() < share)
    apply_parameter_error(case)
    measure(case)
    return finish(case, seed, number)


def best_of(attempts, wanted, enough):
    """Return the first rig whose effects have enough of the wanted gap, or else the rig that comes closest."""
    best, most = None, -1.0
    for attempt in attempts:
        reached = attempt["visible"] / wanted if attempt["effects"] else 1.0
        if reached > most:
            best, most = attempt, reached
        if reached > enough:
            break
    return best


def draw_effect(rng, scale, name, form):
    """Draw one of the laws of an effect. It gets a form error if `form` is a generator."""
    effect = laws.draw(rng, scale, name)
    if form is None:
        return effect
    other = laws.draw(form, scale, name) if form.random() < MIXED else None
    return form_error.inexact(form, scale, effect, other, form.uniform(*FORM_ERROR))


def arrange(rng, effect_names, wanted, by_visible, further, duration, form):
    """Draw component, programme and effects, and find the strengths of the effects."""
    model, specification, base, amplitude = draw_specification(rng, effect_names)
    z, kinds, held, programme, repeat, actuator = draw_logs(rng, amplitude, further, duration)
    rate = RATE * FINE
    if "lift_off" in effect_names:
        z = loaded_to_one_side(rng, z, amplitude, rate)
    ruler = Ruler(Rig(base, z[:SEEN], rate, []), FINE)
    if form is not None:
        base = form_error.off_ladder(form, base, ruler, form.uniform(*BASE_ERROR))
        ruler = Ruler(Rig(base, z[:SEEN], rate, []), FINE)
    scale = scale_of(z, rate, specification["dynamic_stiffness"], ruler.reference, actuator.top_frequency)
    effects = [draw_effect(rng, scale, name, form) for name in effect_names]
    rig = Rig(base, z, rate, effects)
    ruler.rig.effects = rig.effects
    strengths, single = {}, {}
    for effect, share in zip(effects, shares_of(rng, len(effects))):
        strengths[id(effect)], single[effect.name] = strength_of(ruler, effect, wanted * share, by_visible)
    full, visible = ruler.gaps(strengths) if effects else (0.0, 0.0)
    return {"model": model, "specification": specification, "base": base, "z": z, "kinds": kinds + held,
            "programme": programme, "repeat": repeat, "rig": rig, "effects": effects, "strengths": strengths,
            "single": single, "full": full, "visible": visible, "scale": scale}


def strength_of(ruler, effect, wanted, by_visible):
    """Return the strength for the wanted gap. A contact gets its full strength; less would be a compliance."""
    if effect.stage == "contact":
        return effect.strongest, ruler.gaps({id(effect): effect.strongest})
    return ruler.strength_for(effect, wanted, by_visible)


def scale_of(z, rate, stiffness, force, top_frequency):
    """Return the sizes of motion and force in the logs that a diagnosis sees, and the lengths of all logs."""
    seen = z[:SEEN]
    peaks = [float(np.max(np.abs(x))) for x in seen]
    return Scale(stiffness=stiffness, amplitude=max(peaks), least_amplitude=min(peaks),
                 speed=float(np.sqrt(np.mean([np.mean((np.gradient(x) * rate) ** 2) for x in seen]))),
                 force=float(np.mean([np.std(f) for f in force])), top_frequency=top_frequency,
                 training=TRAINING, lengths=[len(x) for x in z], rate=rate,
                 side=-1.0 if sum(float(np.mean(x)) for x in seen) < 0.0 else 1.0)


def shares_of(rng, count):
    """Draw the shares of a pair in the gap. Their squares add up to 1, and neither is below half of the other."""
    if count < 2:
        return [1.0]
    angle = rng.uniform(math.atan(0.5), math.atan(2.0))
    return [math.cos(angle), math.sin(angle)]


def apply_parameter_error(case):
    """Make the values of the file wrong, except in cases without a gap."""
    rng, kind = case["rng"], case["kind"]
    case["file_specification"], case["parameter_error"] = case["specification"], None
    case["file_base"] = bases.Base(**{f.name: getattr(case["base"], f.name) for f in dataclasses.fields(bases.Base)})
    if kind == "parameter_error" and rng.random() < 0.5:
        worn, factors = case["base"].scaled(rng, rng.uniform(0.05, 0.30))
        case["parameter_error"] = {"level": "element", "factors": factors}
        case["base"] = worn
        case["rig"] = Rig(worn, case["z"], case["rig"].rate, [])
    elif kind != "none":
        wrong_file(case, rng.uniform(0.05, 0.30) if kind == "parameter_error" else rng.uniform(0.01, 0.08))


def wrong_file(case, spread):
    """Make the values of the file wrong by about `spread`. The values of the rig stay the same."""
    s, factors, base = wrong_specification(case["rng"], case["model"], case["specification"], spread)
    case["file_specification"], case["file_base"] = s, base
    case["parameter_error"] = {"level": "specification", "factors": factors}


def measure(case):
    """Run the rig, and add the coloured noise and the quantisation of the sensors."""
    rng, z = case["rng"], case["z"]
    true = [f[::FINE] for f in case["rig"].force(case["strengths"])]
    coarse = [x[::FINE] for x in z]
    typical = math.sqrt(np.mean([np.var(f) for f in true]))
    ratio = laws.log_uniform(rng, 0.001, 0.01)
    sensor = 0.0 if rng.random() < 0.15 else case["scale"].amplitude * laws.log_uniform(rng, 1e-5, 4e-4)
    colour = rng.uniform(0.2, 0.6) if rng.random() < 0.3 else 0.0
    steps = (0.0, 0.0)
    if rng.random() < 0.35:
        steps = (case["scale"].amplitude * laws.log_uniform(rng, 5e-5, 4e-4), typical * laws.log_uniform(rng, 2e-4, 3e-3))
    force, displacement = [], []
    for f, x in zip(true, coarse):
        force.append(quantised(f + typical * ratio * noise(rng, len(f), colour), steps[1]))
        displacement.append(quantised(x + sensor * rng.standard_normal(len(x)), steps[0]))
    # A file that lists elements may have a dead band for friction of six times the sensor noise.
    banded = case["as_elements"] and case["base"].friction_force > 0.0
    case["dead_band"] = max(6.0 * sensor, 2.0 * steps[0]) if banded else 0.0
    case.update(true=true, coarse=coarse, force=force, displacement=displacement,
                noise={"force_ratio": ratio, "displacement": sensor, "colour": colour, "steps": steps})


def noise(rng, n, colour):
    """Return noise with a standard deviation of 1. The share `colour` of it is slow (first order, about 8 Hz)."""
    white = rng.standard_normal(n)
    if colour == 0.0:
        return white
    slow = laws.lfilter([1.0], [1.0, -0.9], rng.standard_normal(n))
    return math.sqrt(1.0 - colour) * white + math.sqrt(colour) * slow * math.sqrt(1.0 - 0.81)


def quantised(x, step):
    return x if step == 0.0 else np.round(x / step) * step


def noise_floor(case, logs):
    """Return the gap of a perfect model of the base with the measured displacement, which no model can close.

    The measured displacement has noise. A dashpot differentiates this noise, and a Berg element without a dead band
    takes it for reversals, which change its path.
    """
    base, rate, difference = case["base"], RATE, []
    model_base = dataclasses.replace(base, dead_band=case["dead_band"], c0=0.0)
    for i in logs:
        seen, clean = case["displacement"][i], case["coarse"][i]
        model, bare = (b.force([x], rate)[0] for b, x in ((model_base, seen), (dataclasses.replace(base, c0=0.0), clean)))
        error = seen - clean
        model = model - bare + base.c0 * rate * np.diff(error, prepend=error[0])
        difference.append(case["force"][i] - case["true"][i] - model)
    return gap(difference, [case["force"][i] for i in logs])


def finish(case, seed, number):
    """Assemble the logs for the diagnosis, and the label."""
    rng, further = case["rng"], case["further"]
    everything = list(range(SEEN))
    held = everything[TRAINING:]
    reference = case["file_base"].force(case["coarse"][:SEEN], RATE)
    configured = gap([a - b for a, b in zip(case["true"], reference)], case["true"][:SEEN])
    order = sorted(case["single"], key=lambda name: -case["single"][name][1])
    unlisted = [name.split(":")[1] for name in order if name.startswith("unknown:")]
    label = {
        "case": f"case_{number:03d}", "set": "bank", "seed": seed, "kind": case["kind"],
        "effects": [name for name in order if not name.startswith("unknown:")],
        "unknown": unlisted[0] if unlisted else None,
        "laws": {e.name: e.law for e in case["effects"]}, "parameters": {e.name: e.parameters for e in case["effects"]},
        "strengths": {e.name: case["strengths"][id(e)] for e in case["effects"]},
        "gap": {"wanted": case["wanted"] if case["effects"] else 0.0, "by_visible": case["by_visible"],
                "full": case["full"], "visible": case["visible"], "as_configured": configured,
                "single": {k: {"full": v[0], "visible": v[1]} for k, v in case["single"].items()}},
        "noise": dict(case["noise"], floor=noise_floor(case, everything), floor_hold_out=noise_floor(case, held)),
        "parameter_error": case["parameter_error"], "model": case["model"], "as_elements": case["as_elements"],
        "programme": case["programme"], "base_error": list(getattr(case["base"], "extra_k", [])),
        "kinds": case["kinds"], "repeat": case["repeat"],
    }
    elements = element_entries(case["file_base"], case["dead_band"]) if case["as_elements"] else None
    if further:
        label["noise"]["floor_further"] = noise_floor(case, range(SEEN, SEEN + further))
        label["file"] = {"model": case["model"], "specification": case["file_specification"], "elements": elements}
    logs = list(zip(case["kinds"], case["displacement"], case["force"]))
    return {"label": label, "logs": logs[:SEEN], "further": logs[SEEN:],
            "true": case["true"][:SEEN], "rng": rng, "model": case["model"],
            "specification": case["file_specification"], "elements": elements}


# ---- files -----------------------------------------------------------------------------------------------------------

UNITS_Z = (("m", 1.0, 9), ("mm", 1e3, 6), ("um", 1e6, 3))
UNITS_F = (("N", 1.0, 3), ("kN", 1e-3, 6), ("MN", 1e-6, 9))


def write(case, folder, label_folder):
    """Write the folder of the case (component.yaml, logs, case.json) and the sealed label (JSON, true forces)."""
    rng, label = case["rng"], case["label"]
    os.makedirs(folder, exist_ok=True)
    os.makedirs(label_folder, exist_ok=True)
    name = str(rng.choice(NAMES))
    z_unit, f_unit = UNITS_Z[int(rng.choice(3, p=[0.2, 0.65, 0.15]))], UNITS_F[int(rng.choice(3, p=[0.3, 0.6, 0.1]))]
    # Room temperature. It is omitted if the specimen heats itself, because a thermometer would show that.
    warm = 20.0 + rng.uniform(-3, 6) if rng.random() < 0.2 and "self_heating" not in label["effects"] else None
    ambient = label["parameters"].get("temperature")  # given if temperature is the effect
    files = []
    for i, (kind, z, f) in enumerate(case["logs"]):
        prefix, before = ("log", 0) if i < TRAINING else ("hold_out", TRAINING)
        files.append(f"{prefix}_{i + 1 - before}_{kind}.csv")
        course = warm if ambient is None else ambient["start"][i] + ambient["rise"][i] * np.linspace(0.0, 1.0, len(z))
        write_log(os.path.join(folder, files[-1]), RATE, z, f, z_unit, f_unit,
                  None if course is None else course + 0.05 * rng.standard_normal(len(z)))
    with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as out:
        if case["elements"]:
            out.write(elements_yaml(name, case["elements"]))
        else:
            out.write(component_yaml(rng, name, case["model"], case["specification"]))
    with open(os.path.join(folder, "case.json"), "w", encoding="utf-8") as out:
        json.dump({"component": name, "logs": files[:TRAINING], "hold_out": files[TRAINING:]}, out,
                  indent=1)
    with open(os.path.join(label_folder, label["case"] + ".json"), "w", encoding="utf-8") as out:
        json.dump(label, out, indent=1)
    sealed = {f"hold_out_{i + 1}": x for i, x in enumerate(case["true"][TRAINING:])}
    for i, (_, z, f) in enumerate(case["further"]):
        sealed.update({f"further_{i + 1}_displacement": z, f"further_{i + 1}_force": f})
    np.savez_compressed(os.path.join(label_folder, label["case"] + ".npz"),
                        **{k: x.astype(np.float32) for k, x in sealed.items()})


def write_log(path, rate, z, f, z_unit, f_unit, temperature):
    columns = [np.arange(len(z)) / rate, z * z_unit[1], f * f_unit[1]]
    digits = max(3, math.ceil(math.log10(rate)))  # digits of the time [s]
    header, row = f"time_s,displacement_{z_unit[0]},force_{f_unit[0]}", f"%.{digits}f,%.{z_unit[2]}f,%.{f_unit[2]}f\n"
    if temperature is not None:
        columns.append(temperature)
        header, row = header + ",temperature_degC", row[:-1] + ",%.2f\n"
    with open(path, "w", encoding="utf-8") as out:
        out.write(header + "\n")
        out.write(row * len(z) % tuple(np.stack(columns, axis=1).ravel().tolist()))


def component_yaml(rng, name, model, s):
    """Return the component file. Its stiffnesses are sometimes texts with a unit."""
    lines = ["components:", f"  {name}:", f"    model: {model}", "    specification:"]
    with_units = rng.random() < 0.3
    for key, value in s.items():
        if key == "maxwell_elements":
            text = str(int(value))
        elif with_units and key.endswith("stiffness"):
            text = f"{value * 1e-6:.9g} kN/mm"
        elif with_units and key == "nominal_amplitude":
            text = f"{value * 1e3:.9g} mm"
        else:
            text = repr(float(value))
        lines.append(f"      {key}: {text}")
    return "\n".join(lines) + "\n"


def element_entries(base, dead_band):
    """Return the elements of the base as (type, parameters), for `elements` in a component file."""
    entries = [("spring", {"stiffness": base.k0})]
    entries += [("maxwell", {"stiffness": k, "break_frequency": 1.0 / (2.0 * math.pi * tau)})
                for k, tau in zip(base.k, base.tau)]
    if base.c0 > 0.0:
        entries.append(("dashpot", {"damping": base.c0}))
    if base.friction_force > 0.0:
        friction = {"maximum_force": base.friction_force, "displacement": base.friction_z2}
        entries.append(("friction", dict(friction, dead_band=dead_band) if dead_band > 0.0 else friction))
    return entries


def elements_yaml(name, entries):
    lines = ["components:", f"  {name}:", "    model: elements", "    elements:"]
    for kind, parameters in entries:
        text = ", ".join(f"{k}: {float(v)!r}" for k, v in parameters.items())
        lines.append(f"      - {{type: {kind}, {text}}}")
    return "\n".join(lines) + "\n"
