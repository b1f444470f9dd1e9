# A small check of the fleet statistics on virtual test pieces, from logs to verdicts, and tests of its scorer.
# fleet_trial_test.py CAMPAIGN: the path of the command.
"""Tests of the fleet statistics on simulated logs."""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import score  # noqa: E402

PIECES = 8
FLEETS = ("scatter", "wrong_values", "effect_in_some", "outliers", "soft_rig_soft", "soft_rig_stiff")


class FleetTest(unittest.TestCase):
    """Six fleets of eight test pieces. Thresholds are what such small fleets have to reach, not what they can."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="rubber_suspension_fleets_")
        fleets = [word for fleet in FLEETS for word in ("--fleet", fleet)]
        subprocess.run([sys.executable, os.path.join(HERE, "run.py"), "--campaign", FleetTest.campaign, "--pieces",
                        str(PIECES), "--draws", "1", "--seed", "4", "--output", cls.folder.name, *fleets], check=True,
                       stdout=subprocess.DEVNULL)
        cls.pieces, cls.fleet = score.load(cls.folder.name, os.path.join(cls.folder.name, "campaign"))
        cls.result = score.score(cls.pieces, cls.fleet)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_piece_is_diagnosed(self):
        self.assertEqual((self.result["pieces"], self.result["failed"]), (PIECES * len(FLEETS), 0))
        self.assertFalse([p.row["test_piece"] for p in self.pieces if p.verdict == "check_bench"])

    def test_scatter_is_told_from_an_effect(self):
        causes = self.result["causes"]
        self.assertGreaterEqual(causes["effect named"]["hits"], 2, causes)  # of 3
        self.assertLessEqual(causes["effect named where there is none"]["hits"], 1, causes)
        row = self.result["changes"]["scatter"]
        self.assertGreaterEqual(row["right"], PIECES // 2, row)
        self.assertEqual((row["wrong"], row["left"]), ({}, 0))

    def test_a_wrong_value_common_to_a_type_is_told_from_scatter(self):
        # Where one factor does as well for a piece, a gain stays open unless the few types on the rig exclude it.
        row = self.result["changes"]["wrong_values"]
        self.assertGreaterEqual(row["right"], PIECES // 2 + 1, row)
        self.assertEqual((row["right"] + row["left"], row["wrong"]), (PIECES, {}))

    def test_outliers_stand_out_and_keep_their_verdict(self):
        out = [p for p in self.pieces if p.label["outlier"]]
        self.assertEqual(len(out), 1)
        self.assertTrue(out[0].stands_out)
        self.assertIsNone(out[0].changed_to)
        self.assertEqual(self.result["stand_outs"]["others that stand out"]["hits"], 0)

    def test_a_rig_that_gives_way_takes_more_of_the_stiff_type(self):
        means = {row["type"].rsplit("_", 1)[0]: row["mean"] for row in self.fleet["rigs"]
                 if row["parameter"] == "static_stiffness"}
        # 2.5e-8 m/N take log(1 + 2.5e-8 K): 2.5 % of 1 MN/m, 11.8 % of 5 MN/m, the scatter of eight pieces aside.
        self.assertLess(means["soft_rig_stiff"], means["soft_rig_soft"] - 0.05)
        self.assertEqual(self.result["changes"]["soft_rig_stiff"]["wrong"], {})


class ScoreTest(unittest.TestCase):
    """The scorer on findings whose score is known."""

    @staticmethod
    def piece(fleet, verdict, changed_to=None, **label):
        full = {"fleet": fleet, "draw": 0, "outlier": False, "effect": "", "wrong": {}, "compliance": 0.0, **label}
        piece = score.Piece(full, {"values": {"verdict": verdict, "effects": ""}, "status": "done"})
        piece.changed_to = changed_to
        return piece

    def test_right_and_wrong_changes(self):
        wrong = dict.fromkeys(score.STIFFNESSES, 0.1)
        pieces = [self.piece("scatter", "parameter_error", score.SCATTERS, wrong=dict.fromkeys(score.STIFFNESSES, 0.0)),
                  self.piece("wrong_values", "parameter_error", score.SCATTERS, wrong=wrong),
                  self.piece("wrong_values", "parameter_error", None, wrong=wrong),
                  self.piece("outliers", "parameter_error", score.SCATTERS, outlier=True, wrong=wrong)]
        rows = score.changes(pieces)
        self.assertEqual((rows["scatter"]["right"], rows["scatter"]["wrong"]), (1, {}))
        self.assertEqual((rows["wrong_values"]["right"], rows["wrong_values"]["left"]), (0, 1))
        self.assertEqual(rows["wrong_values"]["wrong"], {score.SCATTERS: 1})
        self.assertEqual(rows["outliers"]["right"], 0)

    def test_coverage(self):
        wrong = dict.fromkeys(score.STIFFNESSES, 0.1)
        found = {"name": "static_stiffness", "mean": 0.09, "mean_interval_95": [0.06, 0.12],
                 "scatter_interval_95": [0.05, 0.09]}
        fleet = {"types": [{"name": "wrong_values_0", "parameters": [found]}]}
        row = score.coverage([self.piece("wrong_values", "parameter_error", wrong=wrong)], fleet)["static_stiffness"]
        self.assertEqual(row, {"mean": {"hits": 1, "of": 1}, "scatter": {"hits": 0, "of": 1}})  # the truth is 0.04

    def test_the_page_has_a_row_for_each_fleet(self):
        pieces = [self.piece(kind, "none", wrong={"static_stiffness": 0.0}) for kind in score.FLEETS]
        fleet = {"types": [], "rigs": []}
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            print(score.markdown(score.score(pieces, fleet)))
        for kind in score.FLEETS:
            self.assertIn(f"| `{kind}` | 1 |", text.getvalue())


if __name__ == "__main__":
    FleetTest.campaign = sys.argv.pop(1)
    unittest.main()
