#!/usr/bin/python3
"""Checks the files of bench.launch: forces of all samples in both passes, equal to replay, the gap, and a picture."""
import csv
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

import rospy
import rostest

COMPONENTS = ("left_secondary", "right_secondary")
PASSES = 2


def wait_until(condition, patience=100.0):
    """Wait until the condition is true, and return False after a time limit [s]."""
    end = time.monotonic() + patience
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def nanoseconds(text):
    seconds, fraction = text.split(".")
    return int(seconds) * 10**9 + int(fraction.ljust(9, "0"))


def run(command, *arguments):
    """Run a program as rosrun finds it. rosrun does not search the folder build/ of the package."""
    spaces = [pathlib.Path(space) for space in os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)]
    programs = [space / "lib" / "rubber_suspension" / command for space in spaces]
    program = next(path for path in programs if path.exists())
    subprocess.run([str(program)] + [str(a) for a in arguments], check=True, stdout=subprocess.DEVNULL)


class BenchLaunch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(rospy.get_param("~folder"))
        cls.records = cls.folder / "records"
        cls.log = rows(rospy.get_param("~log"))
        # The player registers before it opens its files, and unregisters when they are complete.
        last = cls.records / (COMPONENTS[-1] + ".bag")
        if not wait_until(lambda: last.exists() and rospy.get_master().lookupNode("/play_log")[0] != 1):
            raise AssertionError("the playback does not come to its end")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)

    def expected_stamps(self):
        stamps = [nanoseconds(row["time_s"]) for row in self.log]
        period = stamps[-1] - stamps[0] + (stamps[-1] - stamps[0]) // (len(stamps) - 1)
        return [stamp + period * i for i in range(PASSES) for stamp in stamps]

    def test_every_sample_of_every_pass_has_one_force(self):
        for component in COMPONENTS:
            forces = rows(self.records / (component + "_force.csv"))
            self.assertEqual([nanoseconds(row["time_s"]) for row in forces], self.expected_stamps())

    def test_forces_are_those_of_replay(self):
        looped = self.folder / "looped.csv"
        for component in COMPONENTS:
            live = self.records / (component + "_force.csv")
            with open(looped, "w") as file:
                file.write("time_s,displacement_m\n")
                file.writelines("%(time_s)s,%(displacement_m)s\n" % row for row in rows(live))
            offline = self.folder / "offline.csv"
            run("replay", "--config", rospy.get_param("~config"), "--component", component, "--log", looped,
                "--output", offline)
            self.assertEqual(live.read_bytes(), offline.read_bytes())

    def test_gap_is_recorded_up_to_the_last_sample(self):
        for component in COMPONENTS:
            gaps = rows(self.records / (component + "_gap.csv"))
            self.assertEqual(nanoseconds(gaps[-1]["time_s"]), self.expected_stamps()[-1])
            for row in gaps:
                self.assertIn(row["level"], "0123")
            shares = [float(gaps[-1]["share_" + name]) for name in ("stiffness", "loss", "harmonics", "mean", "drift")]
            self.assertAlmostEqual(sum(shares), 1.0, places=6)  # the shares are written with nine digits
            rating = {key[9:]: float(value) for key, value in gaps[-1].items() if key.startswith("iso18571_")}
            parts = 0.4 * rating["corridor"] + 0.2 * (rating["phase"] + rating["magnitude"] + rating["slope"])
            self.assertGreater(parts, 0.0)
            self.assertAlmostEqual(rating["total"], parts, places=6)

    def test_bag_holds_the_logs_again(self):
        for component in COMPONENTS:
            again = self.folder / "again.csv"
            run("bag_to_csv", "--component", component, "--log", self.records / (component + ".bag"), "--output", again)
            measured = [1e3 * float(row["force_kN"]) for row in self.log] * PASSES
            recorded = [float(row["force_N"]) for row in rows(again)]
            self.assertEqual(len(recorded), len(measured))
            for one, other in zip(recorded, measured):
                self.assertAlmostEqual(one, other, delta=1e-9 * abs(other) + 1e-12)

    def test_live_plot_draws(self):
        picture = self.folder / "live.png"
        self.assertTrue(wait_until(picture.exists))
        content = picture.read_bytes()  # the file is complete, because it is renamed into place
        self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(content[-8:-4], b"IEND")


if __name__ == "__main__":
    rospy.init_node("bench_launch")
    rostest.rosrun("rubber_suspension", "bench_launch", BenchLaunch, sys.argv)
