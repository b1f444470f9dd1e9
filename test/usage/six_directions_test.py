#!/usr/bin/python3
"""Diagnoses single directions of a bush with the commands. The bush has friction in x only, and its model has none.

Usage: six_directions_test.py FOLDER_OF_THE_COMMANDS
"""
import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
COORDINATES = ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg")
WRENCH = ("Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm")
SAMPLES, STEP = 3000, 0.004
FRICTION = 150.0  # friction in the file [N], at the factor 1.2 of the preload
# The bush is away from the origins of both bodies, so the force in x causes a moment about z.
MODEL = """components:
  bush:
    directions:
      x:
        model: maxwell
        specification: {static_stiffness: 1 kN/mm, dynamic_stiffness: 1.3 kN/mm, nominal_frequency: 4 Hz, break_frequency: 3 Hz}
      z:
        model: maxwell
        specification: {static_stiffness: 0.6 kN/mm, dynamic_stiffness: 0.9 kN/mm, nominal_frequency: 4 Hz, break_frequency: 3 Hz}
      rz: {model: elements, elements: [{type: spring, stiffness: 250 N m/rad}, {type: dashpot, damping: 2 N m s/rad}]}
    frame: {a: {position: [0, 2 cm, 0]}, b: {position: [0, 2 cm, 0]}}
    preload: {z: 5 kN}
    stiffness_by_preload: [{direction: x, by: z, preload: [0 kN, 10 kN], factor: [1.0, 1.4]}]
"""
ADDED = f"        add: [{{type: friction, maximum_force: {FRICTION} N, displacement: 0.15 mm}}]\n      z:\n"


def run(command, *arguments):
    answer = subprocess.run([PROGRAMS / command, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False)
    return answer.returncode, answer.stdout, answer.stderr


def write(path, columns, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([("time_s",) + columns, *rows])


def motion(path, seed):
    """Write a motion of x, z and rz with different frequencies, and with amplitudes of up to 2 mm and 1.5 deg."""
    generator = random.Random(seed)
    phases = [generator.uniform(0.0, 2.0 * math.pi) for _ in range(3)]
    rows = []
    for i in range(SAMPLES):
        time = i * STEP
        moved = []
        for k in range(3):
            frequency = 3.5 + 2.8 * math.sin((0.8 + 0.11 * k) * time + 2 * seed + k)
            phases[k] += 2.0 * math.pi * frequency * STEP
            moved.append((1.1 + 0.9 * math.sin((1.1 + 0.17 * k) * time + seed + k)) * math.sin(phases[k]))
        rows.append((f"{time:.3f}", moved[0], 0, moved[1], 0, 0, 0.75 * moved[2]))
    write(path, COORDINATES, rows)


def measure(simulated, measured, seed):
    """Add noise of the sensors of 10 N and 0.2 N m to a simulated log."""
    generator = random.Random(seed)
    with open(simulated, newline="") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    for row in rows:
        for k in range(6):
            row[7 + k] += generator.gauss(0.0, 10.0 if k < 3 else 0.2)
    write(measured, ("x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad") + WRENCH, rows)


class SixDirections(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="six.")
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.model = cls.folder / "bush.yaml"
        cls.model.write_text(MODEL)
        truth = cls.folder / "truth.yaml"
        truth.write_text(MODEL.replace("      z:\n", ADDED, 1))
        cls.logs = []
        for seed in (1, 2):
            programme, simulated, log = (cls.folder / f"{name}_{seed}.csv" for name in ("programme", "simulated", "log"))
            motion(programme, seed)
            status, _, errors = run("replay", "--config", truth, "--log", programme, "--output", simulated)
            assert status == 0, errors
            measure(simulated, log, seed)
            cls.logs.append(log)
        cls.report = cls.folder / "report"
        status, cls.said, errors = run("diagnose", "--config", cls.model, "--log", *cls.logs, "--output", cls.report,
                                       "--direction", "x", "--direction", "z")
        assert status == 0, errors

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def gaps(self, config):
        """Return the gap of each direction, as replay prints it."""
        status, said, errors = run("replay", "--config", config, "--log", self.logs[0], "--output", self.folder / "out.csv")
        self.assertEqual(status, 0, errors)
        return {name: float(gap) for name, gap in re.findall(r"gap in (\w+) ([\d.]+)", said)}

    def test_friction_is_named_in_x_alone(self):
        reports = {name: json.loads((self.report / name / "report.json").read_text()) for name in ("x", "z")}
        self.assertEqual((reports["x"]["verdict"], reports["x"]["effects"]), ("named", ["friction"]))
        self.assertEqual((reports["z"]["verdict"], reports["z"]["effects"]), ("none", []))
        whole = json.loads((self.report / "report.json").read_text())
        self.assertEqual([row["verdict"] for row in whole["directions"]], ["named", "none"])
        self.assertRegex(self.said, r"(?m)^x: The model lacks friction")
        self.assertRegex(self.said, r"(?m)^z: The model agrees")

    def test_nothing_couples(self):
        shares = json.loads((self.report / "report.json").read_text())["cross_map"]["shares"]
        self.assertEqual([(row["of"], row["by"]) for row in shares],
                         [(of, by) for of in ("x", "z") for by in ("x", "y", "z", "rx", "ry", "rz") if of != by])
        for row in shares:
            if row["by"] in ("y", "rx", "ry"):  # these directions do not move
                self.assertIsNone(row["share"])
            else:
                self.assertLess(row["share"], 0.05)
        self.assertIn("No displacement predicts 10 %", self.said)

    def test_the_augmented_component_has_the_smaller_gap(self):
        before, after = self.gaps(self.model), self.gaps(self.report / "augmented.yaml")
        self.assertLess(after["x"], 0.5 * before["x"])
        self.assertAlmostEqual(after["z"], before["z"], delta=1e-3)
        text = (self.report / "augmented.yaml").read_text()
        self.assertRegex(text, r"# x: named\. Gap ")
        force = float(re.search(r"type: iwan, .*maximum_force: ([\d.]+) N", text).group(1))  # without preload factor
        # On a settled loop, Iwan's law has up to 2.37/1.99 times the force of Berg's law with the same parameters.
        self.assertTrue(0.95 * 1.99 / 2.37 * FRICTION < force < 1.05 * FRICTION, force)
        self.assertIn("stiffness_by_preload", text)

    def test_a_direction_has_to_be_named(self):
        status, _, errors = run("diagnose", "--config", self.model, "--log", self.logs[0], "--output", self.folder / "none")
        self.assertEqual(status, 2)
        self.assertIn("bush.yaml: component 'bush' has six directions; accepted: --direction with one or more of x, z, rz", errors)

    def test_a_log_without_wrenches_is_refused(self):
        status, _, errors = run("diagnose", "--config", self.model, "--log", self.folder / "programme_1.csv", "--output",
                                self.folder / "none", "--direction", "x")
        self.assertEqual(status, 1)
        self.assertIn("programme_1: the log has no measured wrench; accepted: ", errors)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
