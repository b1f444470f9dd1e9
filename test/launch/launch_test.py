#!/usr/bin/python3
"""Starts launch files with only the arguments that have no default, as a user does, and checks the written files.

    launch_test.py FOLDER_OF_LAUNCH_FILES [TEST ...]    # in an environment in which roslaunch finds the package
"""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from geometry_msgs.msg import PoseStamped

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "wire"))
import tcpros  # noqa: E402: provides a free port for the master

SAMPLES = 200
LAUNCH = ""
CONFIG = """components:
  left_secondary: {model: kelvin_voigt, specification: {dynamic_stiffness: 4.2e6, nominal_frequency: 4,
                                                        relative_damping: 0.05}}
"""
BUSH = """components:
  bush:
    directions: {x: &e {model: elements, elements: [{type: spring, stiffness: 1 kN/mm}, {type: dashpot, damping: 2 kN s/m}]}, y: *e,
                 rz: {model: elements, elements: [{type: spring, stiffness: 250 N m/rad}]}}
    frame: {b: {position: [0, 1 cm, 0]}}
"""


def program(command):
    """Return a program as rosrun finds it. rosrun does not search the folder build/ of the package."""
    spaces = [pathlib.Path(space) for space in os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)]
    return next(path for path in (space / "lib" / "rubber_suspension" / command for space in spaces) if path.exists())


class Launch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="launch.")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.log = self.folder / "a log.csv"
        rows = (f"{0.001 * i:.3f},{1e-4 * math.sin(0.05 * i)}\n" for i in range(SAMPLES))
        self.log.write_text("time_s,displacement_m\n" + "".join(rows))

    def launch(self, name, **arguments):
        """Run until the required node ends, and return all output. roslaunch does not pass on the node's status."""
        environment = {**os.environ, "ROS_HOME": str(self.folder / "ros_home")}
        words = [f"{key}:={value}" for key, value in arguments.items()]
        done = subprocess.run(["roslaunch", "-p", str(tcpros.free_port()), os.path.join(LAUNCH, name), *words],
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertNotIn("exit code", done.stdout)
        return done.stdout

    def forces(self, path, said, column):
        self.assertTrue(path.exists(), said)
        with path.open(newline="") as file:
            return [float(row[column]) for row in csv.DictReader(file)]

    def test_replay(self):
        config = self.folder / "components.yaml"
        config.write_text(CONFIG)
        output, bag = self.folder / "forces.csv", self.folder / "forces of it.bag"
        for more in ({}, {"bag": bag}):
            said = self.launch("replay.launch", config=config, component="left_secondary", log=self.log, output=output, **more)
            forces = self.forces(output, said, "force_N")
            self.assertEqual(len(forces), SAMPLES, said)
            self.assertGreater(max(forces), 300.0)  # 0.1 mm at 4.2 kN/mm
            self.assertEqual(bag.exists(), bool(more), said)

    def test_replay_reads_as_it_is_told(self):
        """Replays the second of two logs in a file, whose numbers may have decimals or thousands."""
        config, log, output = (self.folder / name for name in ("components.yaml", "two.csv", "forces.csv"))
        config.write_text(CONFIG)
        head = "Time [ms];Travel [um]\n"
        rows = [f"{5 * i};{1 + i // 100},{10 * (i % 100):03d}\n" for i in range(100, 160)]
        rows[20] = f"{5 * 120};\n"
        log.write_text(head + "0;1\n5;2\n" + "\n" + head + "".join(rows))
        said = self.launch("replay.launch", config=config, component="left_secondary", log=log, output=output,
                           decimal=",", segment=2, bridge=1)
        displacements = self.forces(output, said, "displacement_m")
        self.assertEqual(len(displacements), 59, said)
        self.assertAlmostEqual(displacements[0], 2.0e-6, delta=1e-12)

    def test_bench_plays_poses(self):
        """Plays text and bag of a component of six directions: its wrenches equal replay to the last bit."""
        config, text, bag = (self.folder / name for name in ("bush.yaml", "poses.csv", "poses.bag"))
        config.write_text(BUSH)
        turns = [(1e-3 * math.sin(0.05 * i), 0.05 * math.sin(0.03 * i)) for i in range(SAMPLES)]
        rows = (f"{1e-3 * i:.3f},{1e3 * x},0,0,0,0,{angle}\n" for i, (x, angle) in enumerate(turns))
        text.write_text("time_s,x_mm,y_mm,z_mm,rx_rad,ry_rad,rz_rad\n" + "".join(rows))
        with rosbag.Bag(str(bag), "w") as file:
            for i, (x, angle) in enumerate(turns):
                pose = PoseStamped()
                pose.header.stamp = rospy.Time(0, 1000000 * (i + 1))
                pose.pose.position.x = x
                pose.pose.orientation.w, pose.pose.orientation.z = math.cos(angle / 2), math.sin(angle / 2)
                file.write("/bush/pose", pose, pose.header.stamp)
        for log in (text, bag):
            records, offline = self.folder / f"{log.suffix[1:]}_run", self.folder / "offline.csv"
            said = self.launch("bench.launch", config=config, component="bush", log=log, output=records, rotation="vector",
                               playback_speed=0)
            self.assertEqual(len(self.forces(records / "bush_force.csv", said, "Mz_Nm")), SAMPLES, said)
            subprocess.run([program("replay"), "--config", config, "--log", log, "--output", offline],
                           stdout=subprocess.DEVNULL, check=True)
            self.assertEqual((records / "bush_force.csv").read_bytes(), offline.read_bytes())

    def test_vehicle(self):
        output, plot = self.folder / "vehicle.csv", self.folder / "vehicle.svg"
        for more in ({}, {"output": output, "plot": plot}):
            said = self.launch("vehicle.launch", track=self.log, **more)
            self.assertEqual(output.exists() and plot.exists(), bool(more), said)


if __name__ == "__main__":
    LAUNCH = sys.argv.pop(1)
    unittest.main(verbosity=2)
