# Trial 2: sealed laws on every base model, one to eight logs, 100 Hz to 10 kHz, as measured cleanly and as benches are.
# Every factor is dealt like cards, so that each of its levels comes as often as any other; the label names them all.
"""Cases of trial 2."""
import dataclasses
import math

import numpy as np

from . import base as bases
from . import bench, case, sealed
from .laws import draw, log_uniform
from .rig import gap

SET = 41          # of the seeds
FURTHER = 8       # logs that no diagnosis sees, to judge by how far a report closes the gap
SHARES = {"single": 0.34, "small": 0.14, "pair": 0.12, "triple": 0.07, "mixed": 0.08, "unknown": 0.09, "none": 0.09,
          "parameter_error": 0.07}
GAPS = {"single": 0.10, "small": 0.03, "pair": 0.15, "triple": 0.20, "mixed": 0.15, "unknown": 0.10}
RATES = (100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0)
LOGS = tuple(range(1, 9))
HOLD_OUT = (2, 2, 0)
MODELS = ("kelvin_voigt", "maxwell", "maxwell_dashpot", "friction", "friction_dashpot", "berg", "multi_maxwell",
          "elements")
BENCH = ("running_start", "zeros", "spikes", "pink", "gain")
DASHPOTS = ("kelvin_voigt", "maxwell_dashpot", "friction_dashpot")
# A model that has the law already cannot lack it. Behind a series compliance or a contact, the force of a dashpot is
# not found by iteration on a fine grid.
UNSUITED = {"friction": ("friction", "friction_dashpot", "berg"), "relaxation": ("multi_maxwell",),
            "viscous_damping": DASHPOTS, "series_compliance": DASHPOTS, "lift_off": DASHPOTS}
# Effects that show only where logs differ.
NEEDS_LOGS = {"sensor_gain": 3, "temperature": 2}
HOPELESS = case.HOPELESS + ({"sensor_gain", "temperature"}, {"sensor_gain", "force_offset"},
                            {"self_heating", "temperature"}, {"backlash", "viscous_damping"},
                            {"backlash", "relaxation"}, {"series_compliance", "backlash"},
                            {"series_compliance", "viscous_damping"})


@dataclasses.dataclass
class Plan:
    """One case before it is drawn."""

    kind: str         # one of SHARES
    effects: tuple    # names, one of which may be `unknown:...`
    model: str
    rate: float       # of the logs [Hz]
    logs: int
    hold_out: int
    benched: bool


class Deck:
    """Deals the levels of a factor in rounds, each shuffled."""

    def __init__(self, rng, levels):
        self._rng, self._levels, self._left = rng, levels, []

    def deal(self, suits=lambda level: True):
        """The next level that suits."""
        for _ in range(2):
            for i, level in enumerate(self._left):
                if suits(level):
                    return self._left.pop(i)
            self._left += [self._levels[i] for i in self._rng.permutation(len(self._levels))]
        raise ValueError("no level suits")


def plan(cases, seed):
    """The plans of all cases, shuffled."""
    rng = np.random.default_rng(np.random.SeedSequence([SET, seed, 10**6]))
    decks = {"effects": Deck(rng, sealed.EFFECTS), "unknown": Deck(rng, sealed.UNKNOWN), "model": Deck(rng, MODELS),
             "rate": Deck(rng, RATES), "logs": Deck(rng, LOGS), "hold_out": Deck(rng, HOLD_OUT)}
    # One deck for each kind: all kinds are clean as often as not.
    benches = {kind: Deck(rng, (False, True)) for kind in SHARES}
    plans = [plan_case(decks, kind, benches[kind].deal()) for kind in kinds(cases)]
    return [plans[i] for i in rng.permutation(len(plans))]


def kinds(cases):
    """As many of each kind as its share says, by largest remainders."""
    counts = {kind: int(share * cases) for kind, share in SHARES.items()}
    behind = sorted(SHARES, key=lambda kind: counts[kind] - SHARES[kind] * cases)
    for kind in behind[:cases - sum(counts.values())]:
        counts[kind] += 1
    return [kind for kind, count in counts.items() for _ in range(count)]


def plan_case(decks, kind, benched):
    listed = {"single": 1, "small": 1, "pair": 2, "triple": 3, "mixed": 1}.get(kind, 0)
    effects = ()
    for _ in range(listed):
        effects += (decks["effects"].deal(lambda e: can_join(e, effects, listed)),)
    if kind in ("mixed", "unknown"):
        effects += (decks["unknown"].deal(),)
    model = decks["model"].deal(lambda m: not any(m in UNSUITED.get(e, ()) for e in effects))
    least = max([1] + [NEEDS_LOGS.get(e, 1) for e in effects])
    return Plan(kind, effects, model, decks["rate"].deal(), decks["logs"].deal(lambda n: n >= least),
                decks["hold_out"].deal(), benched)


def can_join(effect, effects, count):
    """Whether logs could tell the effect from those that are there already, of `count` in all."""
    alone = count > 1 and effect in case.ALONE
    return effect not in effects and not alone and not any(h <= {effect, *effects} for h in HOPELESS)


# ---- the case --------------------------------------------------------------------------------------------------------


def build(seed, number, planned, duration=1.0):
    """Everything about a case in memory, as `case.build` has it; logs last the share `duration` of the usual time."""
    rng = np.random.default_rng(np.random.SeedSequence([SET, seed, number]))
    layout = draw_layout(rng, planned, duration)
    wanted = GAPS.get(planned.kind, 0.0) * rng.uniform(1.0, 1.1)
    recipe = case.Recipe(lambda rng, effects, pace: draw_component(rng, planned, pace, layout.rate),
                         lambda rng, scale, name: draw(rng, scale, name, True, sealed.LAWS), wanted, True)
    kind = {"small": "single"}.get(planned.kind, planned.kind)
    drawn = dict(case.best_of(rng, planned.effects, recipe, layout), kind=kind)
    drawn["as_elements"] = planned.model == "elements" or (drawn["base"].friction_force > 0.0 and rng.random() < 0.4)
    case.apply_parameter_error(drawn)
    drawn["base"].friction_rate = drawn["file_base"].friction_rate = layout.rate
    measure(drawn)
    built = case.finish(drawn, "trial_2", seed, number)
    as_benches_are(built, planned, np.random.default_rng([seed, number, SET]))
    set_floors(drawn, built["label"])
    built["label"]["factors"] = {
        "bench": "as benches are" if planned.benched else "clean", "logs": planned.logs, "hold_out": planned.hold_out,
        "sampling_rate": planned.rate, "samples": sum(len(z) for _, z, _ in built["logs"]),
        "base_model": "elements" if drawn["as_elements"] else planned.model, "kind": planned.kind}
    built["label"]["where"] = where_by_log(drawn)
    built["label"]["file"] = ({"elements": built["elements"]} if drawn["as_elements"] else
                              {"model": built["model"], "specification": built["specification"]})
    return built


def measure(drawn):
    """Sensors whose noise does not hide what the case is about, or else the command in place of the displacement: to
    friction without a dead band, the least noise is a reversal."""
    largest = max(0.25 * drawn["wanted"], 0.012)
    for _ in range(4):
        case.measure(drawn)
        if sampled_floor(drawn, range(len(drawn["force"]))) < largest:
            return
    drawn["displacement"] = [x.copy() for x in drawn["coarse"]]
    drawn["noise"] = dict(drawn["noise"], displacement=0.0)


def draw_layout(rng, planned, duration):
    """Rigs of a high sampling rate are fast ones, or sample densely; a log has no more samples than usual then."""
    dense = log_uniform(rng, 400.0, 2000.0)  # samples in what is a second at the usual pace
    return case.Layout(rate=planned.rate, pace=planned.rate / dense, training=planned.logs, hold_out=planned.hold_out,
                       further=FURTHER, duration=duration * min(1.0, case.RATE / dense))


def draw_component(rng, planned, pace, rate):
    """(model, specification, base, amplitude), the friction of the base on the samples of the log."""
    if planned.model == "elements":
        drawn = draw_elements(rng, planned.effects, pace)
    else:
        extra = {"maxwell_elements": int(rng.choice([3, 5]))} if planned.model == "multi_maxwell" else {}
        drawn = case.specified(rng, pace, planned.model, extra)
    drawn[2].friction_rate = rate
    return drawn


def draw_elements(rng, effects, pace):
    """A list of elements that no specification would give: none to two Maxwell elements, a dashpot or friction."""
    stiffness, amplitude = case.FAMILIES[int(rng.integers(len(case.FAMILIES)))]
    k0, amplitude = log_uniform(rng, *stiffness), log_uniform(rng, *amplitude)
    count = int(rng.integers(0, 2 if "relaxation" in effects else 3))
    component = bases.Base(k0, [k0 * log_uniform(rng, 0.1, 0.6) for _ in range(count)],
                           [1.0 / (2.0 * math.pi * pace * log_uniform(rng, 0.3, 30.0)) for _ in range(count)])
    if not {"viscous_damping", "series_compliance", "lift_off"} & set(effects) and rng.random() < 0.4:
        component.c0 = k0 * rng.uniform(0.02, 0.1) / (2.0 * math.pi * 6.0 * pace)
    if "friction" not in effects and rng.random() < 0.4:
        component.friction_z2 = amplitude * log_uniform(rng, 0.05, 0.4)
        component.friction_force = k0 * amplitude * rng.uniform(0.05, 0.25)
    return "elements", {}, component, amplitude


def where_by_log(drawn):
    """Share of each log in the squared gap of the file's component, without zeros; empty where there is no gap."""
    layout, kinds = drawn["layout"], drawn["kinds"]
    true = drawn["true"][:layout.training]
    reference = drawn["file_base"].force(drawn["coarse"][:layout.training], layout.rate)
    sizes = [float(np.var(a - b) / np.var(a)) for a, b in zip(true, reference)]
    names = [f"log_{i + 1}_{kinds[i]}" for i in range(layout.training)]
    return {n: s / sum(sizes) for n, s in zip(names, sizes)} if sum(sizes) > 1e-6 * layout.training else {}


# ---- the bench, and what noise it leaves -----------------------------------------------------------------------------


def as_benches_are(built, planned, rng):
    """What a bench does to the logs; further logs have its noise alone: what else it does is taken out of gaps."""
    if not planned.benched:
        return
    size = float(rng.choice([0.7, 1.0, 1.3]))
    built["logs"], built["label"]["bench"] = bench.apply(built["logs"], BENCH, size, rng)
    built["further"], _ = bench.apply(built["further"], ("pink",), size, rng)


def set_floors(drawn, label):
    """The floors of the label: as `case.noise_floor`, with what the samples of a log do not tell of the motion between
    them, and with the coloured noise of the bench."""
    layout = drawn["layout"]
    pink = bench.NUISANCES["pink"] * label["bench"]["size"] if "bench" in label else 0.0
    logs = {"floor": range(layout.seen), "floor_further": range(layout.seen, layout.seen + layout.further)}
    logs["floor_hold_out"] = range(layout.training, layout.seen) or logs["floor"]
    for name, numbers in logs.items():
        label["noise"][name] = math.hypot(sampled_floor(drawn, numbers), pink)


def sampled_floor(drawn, numbers):
    """Gap of the rig's own base in a simulation that sees the samples of the log alone."""
    base, rate, difference = drawn["base"], drawn["layout"].rate, []
    model = dataclasses.replace(base, dead_band=drawn["dead_band"], c0=0.0)
    fine = drawn["rig"].base_force()
    for i in numbers:
        seen = drawn["displacement"][i]
        simulated = model.force([seen], rate)[0] + base.c0 * rate * np.diff(seen, prepend=seen[0])
        noise = drawn["force"][i] - drawn["true"][i]
        difference.append(noise + fine[i][::case.FINE] - simulated)
    return gap(difference, [drawn["force"][i] for i in numbers])
