#!/usr/bin/python3
"""Tests of scripts/reproduce_paper: the curves pass through every number in the paper, to its digits."""
import importlib.machinery
import importlib.util
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from scipy.signal import lfilter

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "reproduce_paper"
sys.path.insert(0, str(SCRIPT.parent))  # folder of the module that the script imports
LOADER = importlib.machinery.SourceFileLoader("reproduce_paper", str(SCRIPT))
SPEC = importlib.util.spec_from_loader("reproduce_paper", LOADER)
paper = importlib.util.module_from_spec(SPEC)
LOADER.exec_module(paper)

# Parameters of the models in kN, mm and s: k0, c0, k1, break frequency [Hz], maximum force and z2 of the friction.
M1, M2, M3, M4, M5, M6 = OWN = [(4.2, 0.016711, 0, 1, 0, 1), (3.0, 0, 1.329463, 1.43, 0, 1), (3.0, 0.01076, 1.198, 0.5, 0, 1),
                                (3.0, 0, 0, 1, 6.0475, 2.1760), (3.0, 0.003326, 0, 1, 7.4700, 3.1976),
                                (3.0, 0, 0.26087, 1.45, 4.9209, 2.2109)]


def friction(maximum_force, z2, z, amplitude, upwards):
    """Return the force on both branches of Berg's settled loop, by the equations of 1997."""
    peak = maximum_force / (2 * z2) * (math.sqrt(z2**2 + amplitude**2 + 6 * z2 * amplitude) - z2 - amplitude)
    mu = peak / maximum_force if maximum_force else 0.0
    travel = numpy.where(upwards, z + amplitude, amplitude - z)
    force = -peak + travel * (maximum_force + peak) / (z2 * (1 + mu) + travel)
    return numpy.where(upwards, force, -force)


def integrated(model, frequency, amplitude, steps=4000):
    """Return K [kN/mm] and loss angle [deg] by Eqs. 1 and 2. The Maxwell element uses the midpoint rule."""
    k0, c0, k1, break_frequency, maximum_force, z2 = model
    omega, rate, dt = 2 * math.pi * frequency, 2 * math.pi * break_frequency, 1 / (frequency * steps)
    phase = 2 * math.pi / steps * numpy.arange(1, steps * (2 + int(20 * frequency / rate)) + 1)
    middle = omega * amplitude * numpy.sin(phase - math.pi / steps)
    half = 0.5 * rate * dt
    maxwell = lfilter([k1 * dt / (1 + half)], [1, -(1 - half) / (1 + half)], middle)[-steps:]
    z, velocity = -amplitude * numpy.cos(phase[-steps:]), omega * amplitude * numpy.sin(phase[-steps:])
    force = k0 * z + c0 * velocity + maxwell + friction(maximum_force, z2, z, amplitude, velocity >= 0)
    span = force.max() - force.min()
    area = numpy.sum(force * velocity) * dt
    return span / (2 * amplitude), math.degrees(math.asin(area / (0.25 * math.pi * span * 2 * amplitude)))


def at(points, frequency):
    return next(point for point in points if point[0] == frequency)


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = {number: paper.make(number) for number in paper.NUMBERS}
        cls.curves = {number: [points for _, points in curves] for number, (curves, _) in made.items()}
        cls.axes = {number: figure["axes"] for number, (_, figure) in made.items()}

    def check(self, points, model, stride=17):
        """Compare points with the integrated model, whose parameters have four or five digits."""
        for frequency, amplitude, stiffness, angle in points[stride // 2::stride]:
            own_stiffness, own_angle = integrated(model, frequency, 1e3 * amplitude)
            self.assertAlmostEqual(stiffness * 1e-6 / own_stiffness, 1, delta=5e-4, msg=(model, frequency, amplitude))
            self.assertAlmostEqual(math.degrees(angle) / own_angle, 1, delta=5e-3, msg=(model, frequency, amplitude))

    def test_3_are_surfaces_of_four_models(self):
        for points, model in zip(self.curves[3], (M1, M2, M4, M6), strict=True):
            self.check(points, model, 79)
        self.assertEqual([len(axes["maps"][0]["values"]) for axes in self.axes[3]], [625] * 8)
        for points in self.curves[3][:2]:  # linear models
            self.assertAlmostEqual(points[7][2], points[607][2], delta=1e-6, msg="another amplitude")

    def test_4_has_all_models_over_frequency_and_over_amplitude(self):
        self.assertEqual((len(self.curves[4]), len(self.axes[4])), (12, 4))
        for points, model in zip(self.curves[4], OWN + OWN, strict=True):
            self.check(points, model)
        self.assertEqual({points[0][1] for points in self.curves[4][:6]}, {2e-3})
        self.assertEqual({points[0][0] for points in self.curves[4][6:]}, {4.0})

    def test_4_meets_the_working_point(self):
        # K_n of M1 is the storage stiffness, so its K is 0.5 % larger. M5 has K_n between the turning points, and 0.03
        # % more at the peak. The break frequency of M2 is rounded, so its loss angle has two correct digits.
        for i, accuracy in enumerate((6e-3, 1e-5, 1e-5, 1e-5, 4e-4, 1e-5)):
            _, _, stiffness, angle = at(self.curves[4][i], 4.0)
            self.assertAlmostEqual(stiffness / 4.2e6, 1, delta=accuracy, msg=i)
            self.assertAlmostEqual(math.degrees(angle), 5.71, delta=0.06 if i == 1 else 0.01, msg=i)

    def test_5_is_at_constant_product(self):
        for points, model in zip(self.curves[5], OWN, strict=True):
            self.check(points, model)
            for frequency, amplitude, _, _ in points:
                self.assertAlmostEqual(frequency * amplitude, 8e-3, delta=1e-15)
        for curve, stiffness in ((1, 4.32e6), (3, 5.10e6), (4, 4.92e6), (5, 4.95e6)):
            self.assertAlmostEqual(at(self.curves[5][curve], 20.0)[2], stiffness, delta=0.005e6, msg=curve)

    def test_6_is_one_maxwell_element_for_six_break_frequencies(self):
        rows = ((0.5, 1.2160, 2.04), (1.0, 1.2638, 4.06), (1.43, 1.329463, 5.76), (2.0, 1.4497, 7.94), (4.0, 2.1264, 14.66),
                (8.0, 4.2250, 23.73))
        for points, (break_frequency, stiffness, angle) in zip(self.curves[6], rows, strict=True):
            self.check(points, (3.0, 0, stiffness, break_frequency, 0, 1))
            self.assertAlmostEqual(math.degrees(at(points, 4.0)[3]), angle, delta=0.005)
            self.assertAlmostEqual(at(points, 4.0)[2], 4.2e6, delta=1.0)

    def test_8_begins_with_one_element_from_the_maximum_stiffness(self):
        break_frequency = 4 * math.sqrt((4.9**2 - 4.2**2) / (4.2**2 - 3**2))
        self.check(self.curves[8][0], (3.0, 0, 1.9, break_frequency, 0, 1))
        self.check(self.curves[8][3], M6)

    def test_8_has_the_known_numbers(self):
        frequencies = (0.5, 1, 2, 4, 8, 12, 20)
        rows = (((3.12, 3.38, 3.80, 4.20, 4.50, 4.63, 4.76), (6.74, 10.2, 11.2, 9.55, 7.22, 5.87, 4.31)),
                ((3.64, 3.81, 3.99, 4.20, 4.41, 4.54, 4.69), (5.58, 5.82, 5.97, 5.98, 5.61, 5.26, 4.40)),
                ((3.28, 3.51, 3.84, 4.20, 4.55, 4.74, 4.95), (4.88, 6.45, 6.72, 5.71, 4.29, 3.45, 2.51)))
        for points, (stiffnesses, angles) in zip(self.curves[8][1:], rows, strict=True):
            for frequency, stiffness, angle in zip(frequencies, stiffnesses, angles, strict=True):
                _, _, found, found_angle = at(points, frequency)
                self.assertAlmostEqual(found, stiffness * 1e6, delta=0.005e6)
                self.assertAlmostEqual(math.degrees(found_angle), angle, delta=0.05 if angle >= 10 else 0.005)


class Command(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name) / "new"

    def run_script(self, *arguments):
        return subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False)

    def test_writes_numbers_and_pictures(self):
        paper.write_figures(self.folder, (8,))
        self.assertEqual({path.name for path in self.folder.iterdir()}, {f"figure_8.{kind}" for kind in ("csv", "png", "svg")})
        for path in self.folder.iterdir():
            self.assertGreater(path.stat().st_size, 1000)
        self.assertEqual((self.folder / "figure_8.csv").read_text(encoding="ascii").count("\n"), 1 + 4 * 60)

    def test_refuses_a_file_of_another_kind(self):
        self.folder.mkdir()
        (self.folder / "figure_5.csv").write_text("mine\n", encoding="ascii")
        answer = self.run_script("--output", self.folder)
        self.assertEqual(answer.returncode, 2)
        self.assertRegex(answer.stderr, r"\Areproduce_paper: --output: .*figure_5.csv exists .*--force.*\n\Z")
        self.assertEqual(os.listdir(self.folder), ["figure_5.csv"])

    def test_says_what_cannot_be_written(self):
        answer = self.run_script("--output", "/proc/nowhere")
        self.assertEqual(answer.returncode, 1)
        self.assertRegex(answer.stderr, r"\Areproduce_paper: .*/proc/nowhere.*\n\Z")


if __name__ == "__main__":
    unittest.main()
