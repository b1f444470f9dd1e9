# Tests of the virtual rigs, their generator and the scorer: python3 -m unittest in this folder.
# Short logs keep it quick; every number expected here comes from the theory or from the request itself.
"""Tests of the blind trial's own machinery."""
import filecmp
import json
import math
import os
import sys
import tempfile
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy as np  # noqa: E402

import generate  # noqa: E402
import refit  # noqa: E402
import score  # noqa: E402
from virtual_rig import base, case, effect, excitation, form_error, laws, rig, sealed  # noqa: E402

EXAMPLE = {"static_stiffness": 3.0, "dynamic_stiffness": 4.2, "nominal_frequency": 4.0}


def small_rig(seed=0, seconds=8.0, model="multi_maxwell"):
    """A component with three short logs, and the sizes that laws are drawn by."""
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
    """The base components meet the published example (K in kN/mm, f in Hz)."""

    def test_five_input_estimation(self):
        b = base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0, maxwell_elements=3))
        np.testing.assert_allclose(b.k, [1.0573, 0.5532, 0.2895], atol=6e-5)
        np.testing.assert_allclose(1 / (2 * np.pi * np.array(b.tau)), [1.582, 5.091, 16.384], atol=6e-4)

    def test_stiffness_in_time_is_that_of_the_table(self):
        b = base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0))
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
        b = base.kelvin_voigt(dict(EXAMPLE, loss_angle=0.1))
        self.assertAlmostEqual(b.c0 * 2 * np.pi * 4.0 / b.k0, math.tan(0.1))
        b = base.berg(dict(EXAMPLE, nominal_amplitude=2.0, loss_angle=math.atan(0.1), break_frequency=1.45))
        # The reference rounds differently where friction and Maxwell force are added: 0.05 % is their distance.
        np.testing.assert_allclose([b.friction_force, b.friction_z2, b.k[0]], [4.9209, 2.2109, 0.26087], rtol=5e-4)

    def test_friction_has_the_loss_energy_that_the_dashpot_leaves(self):
        for share, model in ((0.0, base.friction), (0.3, base.friction_dashpot)):
            b = model(dict(EXAMPLE, nominal_amplitude=2.0, loss_angle=0.12, viscous_share=share))
            peak, energy = base.berg_steady_state(2.0, b.friction_z2)
            loss = math.pi * 4.2 * math.sin(0.12) * 2.0**2
            self.assertAlmostEqual(b.k0 * 2.0 + b.friction_force * peak, 4.2 * 2.0)
            self.assertAlmostEqual(b.friction_force * energy, (1.0 - share) * loss)
            self.assertAlmostEqual(math.pi * b.c0 * 2 * np.pi * 4.0 * 2.0**2, share * loss)

    def test_specification_without_solution_is_refused(self):
        with self.assertRaises(base.Unsolvable):
            base.multi_maxwell(dict(EXAMPLE, maximum_stiffness=4.9, high_frequency=25.0, maxwell_elements=2))


class LawTest(unittest.TestCase):
    """Every law of every effect."""

    def test_every_law_reaches_a_gap_and_stays_finite(self):
        component, z, rate, scale = small_rig()
        for name, makers in [*laws.LAWS.items(), *sealed.LAWS.items()]:
            for law_name, maker, _ in makers:
                with self.subTest(effect=name, law=law_name):
                    one = maker(np.random.default_rng(1), scale)
                    self.assertEqual((one.name, one.law), (name, law_name))
                    ruler = rig.Ruler(rig.Rig(component, z, rate, [one]), case.FINE)
                    strength, (full, visible) = ruler.strength_for(one, 0.05, False)
                    if strength < one.strongest:
                        self.assertAlmostEqual(full, 0.05, delta=0.05 * 0.03)
                    self.assertGreater(full, 0.01)
                    self.assertLessEqual(visible, full * 1.1)
                    # The gap of the fine grid is that of the coarse one on which the strength was found.
                    both = rig.Rig(component, z, rate, [one])
                    force = both.force({id(one): strength})
                    again = rig.gap([a - b for a, b in zip(force, both.base_force())], force)
                    self.assertAlmostEqual(again, full, delta=0.06 * full)

    def test_friction_closes_minor_dissipates_and_starts_at_zero(self):
        t = np.arange(8000) / 1000.0
        z = 1e-3 * np.sin(2 * np.pi * t)
        _, _, _, scale = small_rig()
        for law_name, maker, _ in laws.LAWS["friction"] + sealed.LAWS["friction"]:
            with self.subTest(law=law_name):
                h = maker(np.random.default_rng(2), scale).function([z], 1000.0)[0]
                self.assertAlmostEqual(h[0], 0.0, places=12)
                last = slice(-1001, None)
                self.assertGreater(np.sum(0.5 * (h[last][1:] + h[last][:-1]) * np.diff(z[last])), 0.0)

    def test_softening_is_carried_through_training_and_new_in_hold_out(self):
        z = [np.array([0.0, 2.0, -1.0]), np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 0.5])]
        peaks = laws.running_peaks(z, training=2)
        np.testing.assert_array_equal(np.concatenate(peaks), [0, 2, 2, 2, 2, 3, 0, 1, 1])

    def test_some_laws_are_held_back_from_the_bank(self):
        names = {True: set(), False: set()}
        _, _, _, scale = small_rig()
        for test_set in names:
            rng = np.random.default_rng(3)
            for effect_name in laws.available(laws.EFFECTS, test_set):
                names[test_set] |= {laws.draw(rng, scale, effect_name, test_set).law for _ in range(12)}
        held_back = {n for makers in laws.LAWS.values() for n, _, only in makers if only}
        self.assertFalse(names[False] & held_back)
        self.assertTrue(names[True] & held_back)
        self.assertGreater(len(laws.available(laws.UNKNOWN, True)), len(laws.available(laws.UNKNOWN, False)))


class FormErrorTest(unittest.TestCase):
    """Laws that are nobody's, on a base off its ladder."""

    def test_a_law_is_off_by_about_the_size_and_grows_with_its_strength(self):
        _, z, rate, scale = small_rig()
        plain = laws.draw(np.random.default_rng(5), scale, "friction", False)
        off = form_error.inexact(np.random.default_rng(6), scale, plain, None, 0.2)
        shares = [f.function(z, rate) for f in (plain, off)]
        difference = form_error.rms([a - b for a, b in zip(*shares)]) / form_error.rms(shares[0])
        # RMS of the drawn function over the path of these logs, which see a part of it, and of a drift of 6 % at most.
        self.assertTrue(0.08 < difference < 0.4, difference)
        again = off.function(z, rate)
        for a, b in zip(shares[1], again):
            np.testing.assert_array_equal(a, b)

    def test_what_has_one_form_stays_exact(self):
        _, _, _, scale = small_rig()
        for name in form_error.ONE_FORM:
            if name in laws.LAWS:
                plain = laws.draw(np.random.default_rng(7), scale, name, False)
                self.assertIs(form_error.inexact(np.random.default_rng(8), scale, plain, None, 0.3), plain)

    def test_two_laws_are_mixed(self):
        _, z, rate, scale = small_rig()
        rng = np.random.default_rng(9)
        one, other = (laws.draw(rng, scale, "friction", False) for _ in range(2))
        both = form_error.inexact(np.random.default_rng(10), scale, one, other, 0.0)
        self.assertIn("+", both.law)
        size = [form_error.rms(f.function(z, rate)) for f in (one, both)]
        self.assertGreater(abs(size[1] / size[0] - 1.0), 0.05)

    def test_the_base_is_off_its_ladder_and_the_file_is_not(self):
        rng = np.random.default_rng(11)
        component, z, rate, _ = small_rig()
        off = form_error.off_ladder(rng, component, 0.1, 10.0, 0.005)
        self.assertAlmostEqual(sum(off.extra_k), 0.1 * component.k0)
        gap = rig.gap([a - b for a, b in zip(off.force(z, rate), component.force(z, rate))], component.force(z, rate))
        self.assertTrue(0.005 < gap < 0.1, gap)
        self.assertEqual(case.element_entries(off, 0.0), case.element_entries(component, 0.0))

    def test_a_case_has_it_only_where_it_is_asked_for(self):
        layout = case.Layout(duration=0.2)
        exact, inexact = (case.build("bank", 12, 0, "single", ("friction",), False, layout, which)
                          for which in (False, True))
        self.assertNotIn("inexact", exact["label"]["laws"]["friction"])
        self.assertIn("inexact", inexact["label"]["laws"]["friction"])
        self.assertTrue(inexact["label"]["base_error"] and not exact["label"]["base_error"])


class CaseTest(unittest.TestCase):
    """Whole cases."""

    def test_plan_has_every_effect_and_its_quota(self):
        kinds = case.plan("bank", 150, 5)
        singles = [effects[0] for kind, effects, _ in kinds if kind == "single"]
        self.assertEqual(set(singles), set(laws.EFFECTS))
        self.assertEqual([sum(k == kind for k, _, _ in kinds) for kind in ("single", "pair", "none", "unknown")],
                         [90, 18, 12, 18])
        self.assertEqual(kinds, case.plan("bank", 150, 5))
        self.assertNotEqual(kinds, case.plan("test", 150, 5))

    def test_same_seed_same_files_and_labels_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            job = ("bank", 4, 0, ("single", ("creep",), False))
            for run in ("a", "b"):
                generate.one(job + (os.path.join(folder, run), os.path.join(folder, run + "_labels")))
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
            built = case.build("test", 7, number, "single", (name,), wanted_small)
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
        built = case.build("bank", 8, 3, "none", (), False)
        self.assertEqual(built["label"]["effects"], [])
        component = base.from_specification(built["model"], built["specification"])
        for name, text in (("elements", case.elements_yaml("a", case.element_entries(component, 1e-6))),
                           (built["model"], case.component_yaml(built["rng"], "a", built["model"],
                                                                built["specification"]))):
            self.assertIn(f"model: {name}\n", text)
        # The rig's own grid is four times finer than the log: that is all the difference there may be.
        for (_, _, measured), true in zip(built["logs"], built["true"]):
            self.assertLess(np.std(measured - true) / np.std(true), 0.1)
        self.assertLess(built["label"]["gap"]["as_configured"], 2e-3)
        self.assertGreater(component.k0, 0.0)

    def test_parameter_error_is_gone_with_the_rig_s_own_base(self):
        sizes = []
        for number in range(3):
            label = case.build("bank", 9, number, "parameter_error", (), False)["label"]
            self.assertIn(label["parameter_error"]["level"], ("element", "specification"))
            sizes.append(label["gap"]["as_configured"])
        self.assertGreater(min(sizes), 0.005)


class RefitTest(unittest.TestCase):
    """When evidence and fit are repeated."""

    def test_the_tree_s_numbers_are_read(self):
        numbers = refit.read_numbers()
        self.assertLessEqual(refit.positive_numbers(), set(numbers))
        self.assertIn('rates["friction"]', numbers)
        self.assertNotIn("effect", refit.positive_numbers())

    def test_a_number_moves_by_a_share_of_itself_and_odds_by_a_share_of_the_odds(self):
        old = {"sharpness": 10.0, "effect": -4.0, "second": -0.01}
        self.assertEqual(refit.moved(old, {"sharpness": 10.4, "effect": -4.04, "second": 0.03}, {"sharpness"}), {})
        self.assertEqual(set(refit.moved(old, {"sharpness": 10.6, "effect": -4.1}, {"sharpness"})),
                         {"sharpness", "effect", "second"})


class ScoreTest(unittest.TestCase):
    """The scorer on reports whose score is known."""

    @staticmethod
    def label(number, kind, effects, unknown=None):
        return {"case": f"case_{number:03d}", "kind": kind, "effects": effects, "unknown": unknown,
                "laws": {e: "x" for e in effects}, "programme": "rich", "model": "maxwell", "parameter_error": None,
                "gap": {"wanted": 0.1, "visible": 0.1, "full": 0.1,
                        "single": {e: {"visible": 0.1, "full": 0.1} for e in effects}}, "noise": {"floor": 0.01, "floor_hold_out": 0.01}}

    def cases(self, report):
        labels = [self.label(0, "single", ["friction"]), self.label(1, "single", ["creep"]),
                  self.label(2, "pair", ["friction", "creep"]), self.label(3, "none", []),
                  self.label(4, "parameter_error", []), self.label(5, "unknown", [], "hum")]
        return [score.Case(label, report(label), None) for label in labels]

    @staticmethod
    def figures(cases):
        return {row["name"]: row["figure"] for row in score.score(cases)["goals"]}

    def test_perfect_reports(self):
        def report(label):
            verdict = {"single": "named", "pair": "named"}.get(label["kind"], label["kind"])
            return {"verdict": verdict, "effects": label["effects"], "confounded": [[e] for e in label["effects"]],
                    "candidates": [{"effect": e, "probability": 1.0} for e in label["effects"]],
                    "gap": {"re_estimated": 0.11, "augmented": 0.01},
                    "closed": {"fraction": 1.0, "interval_95": [0.98, 1.0]}}
        figures = self.figures(self.cases(report))
        for name in ("right effect first, single effects", "both named, pairs", "exact verdict on none",
                     "effect outside the list refused (verdict unknown)",
                     "intervals of the gap closed that cover the truth"):
            self.assertEqual(figures[name]["rate"], 1.0, name)
        self.assertEqual(figures["effect named on none or parameter error"]["rate"], 0.0)
        self.assertEqual(figures["expected calibration error of the first name"]["value"], 0.0)

    def test_a_report_that_always_says_friction(self):
        def report(_):
            return {"verdict": "named", "effects": ["friction"], "confounded": [["friction", "creep"]],
                    "candidates": [{"effect": "friction", "probability": 0.9}],
                    "gap": {"re_estimated": 0.11, "augmented": 0.06},
                    "closed": {"fraction": 0.9, "interval_95": [0.85, 0.95]}}
        cases = self.cases(report)
        figures = self.figures(cases)
        self.assertEqual(figures["right effect first, single effects"]["rate"], 0.5)
        self.assertEqual(figures["truth in the ambiguity set, single effects"]["rate"], 1.0)
        self.assertEqual(figures["mean size of the ambiguity set"]["value"], 2.0)
        self.assertEqual(figures["both named, pairs"]["rate"], 0.0)
        self.assertEqual(figures["effect named on none or parameter error"]["rate"], 1.0)
        # Right in two of six, said 0.9; and half of the gap was closed, not 0.9.
        self.assertAlmostEqual(figures["expected calibration error of the first name"]["value"], 0.9 - 2 / 6)
        self.assertEqual(figures["intervals of the gap closed that cover the truth"]["rate"], 0.0)
        self.assertEqual(score.score(cases)["classes"]["creep"]["instead"], {"friction": 1})

    def test_missing_reports_are_failures(self):
        figures = self.figures(self.cases(lambda label: None))
        self.assertEqual(figures["right effect first, single effects"]["rate"], 0.0)
        self.assertEqual(figures["effect named on none or parameter error"]["rate"], 1.0)
        self.assertEqual(figures["effect outside the list, nothing named"]["rate"], 0.0)


if __name__ == "__main__":
    unittest.main()
