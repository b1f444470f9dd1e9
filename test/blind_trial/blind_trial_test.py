# Tests of the virtual rigs, their generator, the rules of reports and the scorer: python3 -m unittest in this folder.
# Logs are short to save time. Every expected number follows from the theory or from the request itself.
"""Tests of the programs of the blind trial itself."""
import filecmp
import json
import math
import os
import tempfile
import types
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np  # noqa: E402

import generate  # noqa: E402
import invariants  # noqa: E402
import machines  # noqa: E402
import replayed  # noqa: E402
import score  # noqa: E402
from virtual_rig import base, case, effect, excitation, form_error, laws, rig  # noqa: E402

EXAMPLE = {"static_stiffness": 3.0, "dynamic_stiffness": 4.2, "nominal_frequency": 4.0}


def small_rig(seed=0, seconds=8.0, model="multi_maxwell"):
    """Return a component with four short logs, and the scale from which laws are drawn."""
    rng = np.random.default_rng(seed)
    specification = {"static_stiffness": 3e6, "dynamic_stiffness": 4.2e6, "nominal_frequency": 4.0,
                     "maximum_stiffness": 4.9e6, "high_frequency": 25.0, "maxwell_elements": 3}
    component = base.from_specification(model, specification)
    actuator = excitation.Actuator(rng, 2e-3, case.RATE * case.FINE)
    z = [excitation.make(rng, actuator, kind, seconds) for kind in ("sines", "track", "amplitude_sweep", "holds")]
    rate = case.RATE * case.FINE
    peaks = [float(np.max(np.abs(x))) for x in z]
    force = component.force(z, rate)
    scale = effect.Scale(stiffness=4.2e6, amplitude=max(peaks), least_amplitude=min(peaks),
                         speed=float(np.sqrt(np.mean([np.mean((np.gradient(x) * rate) ** 2) for x in z]))),
                         force=float(np.mean([np.std(f) for f in force])), top_frequency=actuator.top_frequency,
                         training=3, lengths=[len(x) for x in z], rate=rate)
    return component, z, rate, scale


class BaseTest(unittest.TestCase):
    """The base components agree with the published example (K in kN/mm, f in Hz)."""

    def test_five_input_estimation(self):
        b = base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0, maxwell_elements=3))
        np.testing.assert_allclose(b.k, [1.0573, 0.5532, 0.2895], atol=6e-5)
        np.testing.assert_allclose(1 / (2 * np.pi * np.array(b.tau)), [1.582, 5.091, 16.384], atol=6e-4)

    def test_stiffness_in_time_is_that_of_the_table(self):
        b = base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0, maxwell_elements=5))
        rate, n = 2000.0, 20000
        for f, stiffness, angle in ((2.0, 3.99, 5.97), (4.0, 4.20, 5.98), (12.0, 4.54, 5.26)):
            z = np.sin(2 * np.pi * f * np.arange(n) / rate)
            force = b.force([z], rate)[0][n // 2:]
            k = 2.0 * np.mean(force * np.exp(-2j * np.pi * f * np.arange(n // 2, n) / rate)) * 1j
            self.assertAlmostEqual(abs(k), stiffness, delta=0.006)
            self.assertAlmostEqual(math.degrees(np.angle(k)), angle, delta=0.06)

    def test_berg_steady_state(self):
        peak, energy = base.berg_steady_state(2.0, 0.5)
        self.assertAlmostEqual(1.5 * peak, 1.05234, places=5)
        self.assertAlmostEqual(1.5 * energy, 4.44002, places=5)
        z = 2.0 * np.sin(2 * np.pi * np.arange(40001) / 1000.0)
        loop = 1.5 * base.berg_response(z, 0.5)[-1001:]
        self.assertAlmostEqual(0.5 * (loop.max() - loop.min()), 1.05234, delta=1e-3)
        self.assertAlmostEqual(np.sum(0.5 * (loop[1:] + loop[:-1]) * np.diff(z[-1001:])), 4.44002, delta=5e-3)

    def test_single_maxwell_and_berg_meet_their_targets(self):
        b = base.maxwell(dict(EXAMPLE, maximum_stiffness=4.9))
        r = 1j * 2 * np.pi * 4.0 * b.tau[0]
        self.assertAlmostEqual(abs(b.k0 + b.k[0] * r / (1 + r)), 4.2, places=9)
        b = base.berg(dict(EXAMPLE, nominal_amplitude=2.0, loss_angle=math.atan(0.1), break_frequency=1.45))
        # The reference rounds the sum of friction and Maxwell force differently, which changes it by 0.05 %.
        np.testing.assert_allclose([b.friction_force, b.friction_z2, b.k[0]], [4.9209, 2.2109, 0.26087], rtol=5e-4)

    def test_specification_without_solution_is_refused(self):
        with self.assertRaises(base.Unsolvable):
            base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0, maxwell_elements=2))


class LawTest(unittest.TestCase):
    """Tests of every law of every effect."""

    def test_every_law_reaches_a_gap_and_stays_finite(self):
        component, z, rate, scale = small_rig()
        for name, makers in laws.LAWS.items():
            for maker in makers:
                one = maker(np.random.default_rng(1), scale)
                with self.subTest(effect=name, law=one.law):
                    self.assertEqual(one.name, name)
                    ruler = rig.Ruler(rig.Rig(component, z, rate, [one]), case.FINE)
                    strength, (full, visible) = ruler.strength_for(one, 0.05, False)
                    if strength < one.strongest:
                        self.assertAlmostEqual(full, 0.05, delta=0.05 * 0.03)
                    self.assertGreater(full, 0.01)
                    self.assertLessEqual(visible, full * 1.1)
                    # The strength was found on the coarse grid. On the fine grid it must give the same gap.
                    both = rig.Rig(component, z, rate, [one])
                    force = both.force({id(one): strength})
                    again = rig.gap([a - b for a, b in zip(force, both.base_force())], force)
                    self.assertAlmostEqual(again, full, delta=0.06 * full)

    def test_friction_closes_minor_dissipates_and_starts_at_zero(self):
        t = np.arange(8000) / 1000.0
        z = 1e-3 * np.sin(2 * np.pi * t)
        _, _, _, scale = small_rig()
        for maker in laws.LAWS["friction"]:
            one = maker(np.random.default_rng(2), scale)
            with self.subTest(law=one.law):
                h = one.function([z], 1000.0)[0]
                self.assertAlmostEqual(h[0], 0.0, places=12)
                last = slice(-1001, None)
                self.assertGreater(np.sum(0.5 * (h[last][1:] + h[last][:-1]) * np.diff(z[last])), 0.0)

    def test_softening_is_carried_through_training_and_new_in_hold_out(self):
        z = [np.array([0.0, 2.0, -1.0]), np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 0.5])]
        peaks = laws.running_peaks(z, training=2)
        np.testing.assert_array_equal(np.concatenate(peaks), [0, 2, 2, 2, 2, 3, 0, 1, 1])


class FormErrorTest(unittest.TestCase):
    """Tests of laws with form errors, on a base component with more relaxation than its model."""

    def test_a_law_is_off_by_about_the_size_and_grows_with_its_strength(self):
        _, z, rate, scale = small_rig()
        plain = laws.draw(np.random.default_rng(5), scale, "friction")
        off = form_error.inexact(np.random.default_rng(6), scale, plain, None, 0.2)
        shares = [f.function(z, rate) for f in (plain, off)]
        difference = form_error.rms([a - b for a, b in zip(*shares)]) / form_error.rms(shares[0])
        # The limits cover the RMS of the drawn function over parts of its domain, and a drift of at most 6 %.
        self.assertTrue(0.08 < difference < 0.4, difference)
        again = off.function(z, rate)
        for a, b in zip(shares[1], again):
            np.testing.assert_array_equal(a, b)

    def test_what_has_one_form_stays_exact(self):
        _, _, _, scale = small_rig()
        for name in form_error.ONE_FORM:
            if name in laws.LAWS:
                plain = laws.draw(np.random.default_rng(7), scale, name)
                self.assertIs(form_error.inexact(np.random.default_rng(8), scale, plain, None, 0.3), plain)

    def test_two_laws_are_mixed(self):
        _, z, rate, scale = small_rig()
        rng = np.random.default_rng(9)
        one, other = (laws.draw(rng, scale, "friction") for _ in range(2))
        both = form_error.inexact(np.random.default_rng(10), scale, one, other, 0.0)
        self.assertIn("+", both.law)
        size = [form_error.rms(f.function(z, rate)) for f in (one, both)]
        self.assertGreater(abs(size[1] / size[0] - 1.0), 0.05)

    def test_the_base_is_off_its_ladder_and_the_file_is_not(self):
        rng = np.random.default_rng(11)
        component, z, rate, _ = small_rig()
        ruler = rig.Ruler(rig.Rig(component, z, rate, []), 1)
        off = form_error.off_ladder(rng, component, ruler, 0.004)
        difference = [a - b for a, b in zip(off.force(z, rate), component.force(z, rate))]
        self.assertAlmostEqual(ruler.visible(difference, off.force(z, rate)), 0.004, delta=0.001)
        self.assertLessEqual(sum(off.extra_k), 0.1 * component.k0)
        self.assertEqual(case.element_entries(off, 0.0), case.element_entries(component, 0.0))

    def test_a_case_has_it_only_where_it_is_asked_for(self):
        exact, inexact = (case.build(12, 0, "single", ("friction",), False, 0, 0.2, which) for which in (False, True))
        self.assertNotIn("inexact", exact["label"]["laws"]["friction"])
        self.assertIn("inexact", inexact["label"]["laws"]["friction"])
        self.assertTrue(inexact["label"]["base_error"] and not exact["label"]["base_error"])


class CaseTest(unittest.TestCase):
    """Tests of whole cases."""

    def test_plan_has_every_effect_and_its_quota(self):
        kinds = case.plan(150, 5)
        singles = [effects[0] for kind, effects, _ in kinds if kind == "single"]
        self.assertEqual(set(singles), set(laws.EFFECTS))
        self.assertEqual([sum(k == kind for k, _, _ in kinds) for kind in ("single", "pair", "none", "unknown")],
                         [90, 18, 12, 18])
        self.assertEqual(kinds, case.plan(150, 5))
        self.assertNotEqual(kinds, case.plan(150, 6))

    def test_same_seed_same_files_and_labels_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            for run in ("a", "b"):
                words = ["--cases", "1", "--seed", "4", "--output", os.path.join(folder, run)]
                generate.one(generate.parsed(words), (0, ("single", ("creep",), False)))
            files = sorted(os.listdir(os.path.join(folder, "a", "case_000")))
            self.assertEqual(len(files), 2 + case.TRAINING + case.HOLD_OUT)
            for file in files:
                paths = [os.path.join(folder, run, "case_000", file) for run in ("a", "b")]
                self.assertTrue(filecmp.cmp(*paths, shallow=False), file)
                if not file.endswith(".csv"):
                    with open(paths[0], encoding="utf-8") as text:
                        self.assertNotIn("creep", text.read())
            with open(os.path.join(folder, "a_labels", "case_000.json"), encoding="utf-8") as text:
                self.assertEqual(json.load(text)["effects"], ["creep"])

    def test_size_is_as_asked_and_logs_differ(self):
        for number, (name, wanted_small) in enumerate((("friction", True), ("asymmetric_stiffness", False))):
            built = case.build(7, number, "single", (name,), wanted_small)
            label = built["label"]
            size = label["gap"]["visible" if label["gap"]["by_visible"] else "full"]
            self.assertLessEqual(size, label["gap"]["wanted"] * 1.05)
            self.assertGreaterEqual(size, label["gap"]["wanted"] * 0.8)
            self.assertTrue(0.028 <= label["gap"]["wanted"] <= 0.034 or not wanted_small)
            self.assertTrue(8e-4 < label["noise"]["floor"] < 0.05)
            repeat = set(label["repeat"] or ())
            for i, (_, z, force) in enumerate(built["logs"]):
                self.assertTrue(30 <= len(z) / case.RATE <= 60)
                self.assertLess(abs(z[0]), 0.01 * np.max(np.abs(z)))
                for j in range(i):
                    if {i, j} != repeat:
                        self.assertFalse(np.array_equal(z, built["logs"][j][1]))

    def test_gap_free_case_is_the_file_s_component(self):
        built = case.build(8, 3, "none", (), False)
        self.assertEqual(built["label"]["effects"], [])
        component = base.from_specification(built["model"], built["specification"])
        for name, text in (("elements", case.elements_yaml("a", case.element_entries(component, 1e-6))),
                           (built["model"], case.component_yaml(built["rng"], "a", built["model"],
                                                                built["specification"]))):
            self.assertIn(f"model: {name}\n", text)
        # The only difference is the grid of the rig, which is four times finer than the log.
        for (_, _, measured), true in zip(built["logs"], built["true"]):
            self.assertLess(np.std(measured - true) / np.std(true), 0.1)
        self.assertLess(built["label"]["gap"]["as_configured"], 2e-3)
        self.assertGreater(component.k0, 0.0)

    def test_parameter_error_is_gone_with_the_rig_s_own_base(self):
        sizes = []
        for number in range(3):
            label = case.build(9, number, "parameter_error", (), False)["label"]
            self.assertIn(label["parameter_error"]["level"], ("element", "specification"))
            sizes.append(label["gap"]["as_configured"])
        self.assertGreater(min(sizes), 0.005)


    def test_further_logs_have_the_noise_of_the_bench(self):
        words = ["--cases", "1", "--seed", "6", "--output", "unused", "--duration", "0.1", "--further", "2"]
        floors = []
        for bench in ([], ["--bench", "pink,gain", "--size", "2"]):
            arguments = generate.parsed(words + bench)
            built = case.build(6, 1, "none", (), False, arguments.further, 0.1)
            if bench:
                generate.on_bench(built, arguments.bench.split(","), arguments.size, np.random.default_rng(1))
            floors.append(built["label"]["noise"]["floor_further"])
            self.assertEqual((len(built["logs"]), len(built["further"])), (8, 2))
        self.assertAlmostEqual(floors[1], np.hypot(floors[0], 0.01))


class MachineTest(unittest.TestCase):
    """Tests of the model that is made for a measured log."""

    def test_spring_and_dashpot_of_a_log_are_found(self):
        t = np.arange(3000) * 0.01
        z = np.sin(2 * np.pi * 0.5 * t) * (1.0 + t)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "log.csv")
            np.savetxt(path, np.stack([t, z, 2.0 * z + 0.1 * np.gradient(z) / 0.01 + 0.5], 1), "%.6f", ",",
                       header="time_s,displacement_mm,force_kN", comments="")
            self.assertEqual(machines.spring_and_dashpot([path]), (2e6, 1e5))


# ---- reports ---------------------------------------------------------------------------------------------------------


def report_of(verdict, effects=(), **changes):
    """Return a report without any contradiction."""
    naming = bool(effects)
    says = {"none": "none", "parameter_error": "parameter_error", "unknown": "none_of_these"}.get(verdict, "effects")
    left = 0.05 if verdict == "partly" else 0.011
    before = {"none": 0.011, "parameter_error": 0.011}.get(verdict, 0.11)
    gap = {"as_configured": 0.12 if verdict != "none" else 0.011, "re_estimated": before,
           "augmented": left if naming else before, "noise_floor": 0.01}
    closed = (before - gap["augmented"]) / (before - 0.01)
    posterior = dict.fromkeys(("none", "parameter_error", "effects", "none_of_these"), 0.0)
    report = {"verdict": verdict, "effects": list(effects), "confounded": [list(effects)] if naming else [], "gap": gap,
              "sentence": "", "probability": 1.0, "alternatives": [],
              "closed": {"fraction": closed, "interval_95": [closed - 0.02, min(1.0, closed + 0.02)]},
              "candidates": [{"effect": e, "probability": 1.0, "gap": 0.02} for e in effects] or
                            [{"effect": "creep", "probability": 0.0, "gap": 0.12}],
              "posterior": dict(posterior, **{says: 1.0}), "where": [{"share": 0.4}, {"share": 0.6}],
              "next_experiment": "A sine.", "surrogate": {"gap": 0.04}}
    removed = {"values": 1.0 - before / gap["as_configured"]}
    removed.update({e: (before - gap["augmented"]) / gap["as_configured"] / len(effects) for e in effects})
    return dict(report, share_of_configured_gap=removed, **changes)


class InvariantsTest(unittest.TestCase):
    """Tests of the rules that every report must obey."""

    def test_contradictions_are_found(self):
        self.assertTrue(all(holds is not False for r in (report_of("named", ["creep"]), report_of("unknown"))
                            for holds in invariants.checked(r).values()))
        gap = report_of("named", ["creep"])["gap"]
        for name, changes in (
                ("no set contains an improbable effect", {"confounded": [["creep"], ["friction"]]}),
                ("the first set in the list is the named set", {"confounded": [["friction"]]}),
                ("the probabilities of effects agree with the sets that contain them", {
                    "candidates": [{"effect": "creep", "probability": 0.5, "gap": 0.02}]}),
                ("alternatives are sorted by probability", {"alternatives": [{"probability": 0.1}, {"probability": 0.2}]}),
                ("the headline has the largest change", {
                    "sentence": "K_n is 10 % too low in the component file",
                    "model_sizes": [{"configured": 1.0, "value": v, "interval_95": [0.9 * v, 1.02 * v]}
                                    for v in (2.0, 1.1)]}),
                ("an interval that ends at a bound is marked", {
                    "effect_sizes": [{"value": 2.0, "interval_95": [0.0, 3.0], "at_bound": [False, False]}]}),
                ("the share closed agrees with the gaps", {"gap": dict(gap, augmented=0.06)}),
                ("no other fit predicts unseen data better", {
                    "trials": [{"effects": [], "in_sample": 0.07, "held_out": 0.02, "chi_squared": 0.0}]}),
                ("the noise floor is not above any gap", {"gap": dict(gap, noise_floor=0.05)}),
                ("effects are named if and only if the verdict names effects", {"effects": []}),
                ("the verdict is the most probable explanation", {
                    "posterior": {"none": 0.6, "parameter_error": 0.0, "effects": 0.4, "none_of_these": 0.0}}),
                ("the shares in `where` add up to 1", {"where": [{"share": 0.5}]}),
                ("the interval contains the share closed", {"closed": {"fraction": 0.99, "interval_95": [0.2, 0.5]}})):
            self.assertIs(invariants.checked(dict(report_of("named", ["creep"]), **changes))[name], False, name)
        self.assertIs(invariants.checked(report_of("defect", defect="the shares in `where` add up to 1"))[
            "no invariant was broken within the diagnosis"], False)
        self.assertIs(invariants.checked(report_of("unknown", next_experiment=""))[
            "a next experiment where confounded or unknown"], False)


class ScoreTest(unittest.TestCase):
    """Tests of the figures of reports with a known score."""

    @staticmethod
    def case(report, further=None, run=None):
        label = {"case": "case_000", "noise": {"floor_further": 0.01}}
        return types.SimpleNamespace(label=label, report=report, further=further, run=run)

    def test_rows(self):
        good = self.case(report_of("named", ["creep"]), {"re_estimated": 0.11, "augmented": 0.011, "surrogate": 0.06})
        too_sure = self.case(report_of("named", ["creep"]), {"re_estimated": 0.11, "augmented": 0.06})
        refused = self.case(report_of("unknown"), {"error": "refused"})
        self.assertAlmostEqual(score.closed_on_further(good), 0.99)
        self.assertAlmostEqual(score.closed_on_further(good, "surrogate"), 0.5)
        self.assertEqual([score.is_covered(case) for case in (good, too_sure, refused)], [True, False, None])
        run = {"seconds": 2.0, "peak_memory_bytes": 2**20, "exit_status": 0, "timed_out": False}
        result = score.score([good, self.case(report_of("defect", defect="x"), run=run), self.case(None)])
        self.assertEqual(result["rows"]["cases with a report"]["hits"], 2)
        self.assertEqual(result["rows"]["reports without a defect"]["hits"], 1)
        self.assertEqual(result["rows"]["rule: the shares in `where` add up to 1"]["rate"], 1.0)
        self.assertIn("| rule: the shares in `where` add up to 1 | 100 % (2/2, 34 to 100 %) |", score.markdown(result))
        self.assertIn("median 2.0 s, 95 % below 2.0 s, longest 2.0 s; peak memory 1 MiB", score.markdown(result))


class FurtherTest(unittest.TestCase):
    """Tests of gaps on further logs, without running `replay`."""

    def test_re_estimated_component(self):
        file = {"model": "maxwell", "specification": {"static_stiffness": 2.0, "dynamic_stiffness": 3.0}, "elements": None}
        content = json.loads(replayed.re_estimated(file, "a", {"static_stiffness": 1.5}))["components"]["a"]
        self.assertEqual(content["specification"], {"static_stiffness": 3.0, "dynamic_stiffness": 3.0})
        file = {"elements": [["spring", {"stiffness": 2.0}], ["dashpot", {"damping": 4.0}]]}
        content = json.loads(replayed.re_estimated(file, "a", {"dashpot[1].damping": 0.5}))["components"]["a"]
        self.assertEqual(content["elements"],
                         [{"type": "spring", "stiffness": 2.0}, {"type": "dashpot", "damping": 2.0}])
        with self.assertRaises(ValueError):
            replayed.re_estimated(file, "a", {"spring[1].stiffness": 2.0})


if __name__ == "__main__":
    unittest.main()
