#!/usr/bin/python3
"""Tests of scripts/generate_track: its spectrum and its vehicle agree with independent calculations."""

import importlib.machinery
import importlib.util
import math
import pathlib
import sys
import unittest

import numpy

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "generate_track"
sys.path.insert(0, str(SCRIPT.parent))  # folder of the module that the script imports
LOADER = importlib.machinery.SourceFileLoader("generate_track", str(SCRIPT))
SPEC = importlib.util.spec_from_loader("generate_track", LOADER)
generate_track = importlib.util.module_from_spec(SPEC)
LOADER.exec_module(generate_track)


def options(*arguments):
    return generate_track.parse(["--output", "unused", *arguments])


class Track(unittest.TestCase):
    def test_spectrum_has_its_published_form(self):
        # The spectrum is A / Wr^2 far below both corner frequencies and A Wc^2 / W^4 far above, up to second order.
        low = 4.032e-7
        self.assertAlmostEqual(generate_track.spectrum(1e-6, "low") / (low / 0.0206**2), 1, delta=1e-6)
        self.assertAlmostEqual(generate_track.spectrum(1e3, "low") / (low * 0.8246**2 / 1e12), 1, delta=1e-5)
        self.assertAlmostEqual(
            generate_track.spectrum(0.3, "high") / generate_track.spectrum(0.3, "low"), 1.080 / 0.4032, delta=1e-12
        )

    def test_variance_is_the_integral_of_the_spectrum(self):
        given = options("--track", "--duration", "600", "--sampling-rate", "200")
        wavenumber = numpy.linspace(2 * math.pi / given.longest, 2 * math.pi / given.shortest, 200001)
        expected = numpy.trapz(generate_track.spectrum(wavenumber, "low"), wavenumber)
        variances = []
        for seed in range(20):
            given.seed = seed
            variances.append(numpy.mean(generate_track.generate(given) ** 2))
        # The standard error of the mean of twenty draws follows from their scatter. The tolerance is five standard
        # errors, plus 0.2 % for the fade-in of one second in 600.
        tolerance = 5 * numpy.std(variances, ddof=1) / math.sqrt(20) + 0.002 * expected
        self.assertLess(abs(numpy.mean(variances) - expected), tolerance)
        self.assertLess(tolerance, 0.3 * expected)  # otherwise the test would accept too much

    def test_measured_density_is_the_expected_one(self):
        # Each value is the mean of 16 periodograms, whose standard deviation equals their mean. So the ratio is close
        # to 1 over all lines of the band. Neighbouring lines of a Hann window share 1.5 lines.
        given = options("--duration", "600", "--sampling-rate", "200")
        frequency, density = generate_track.measured_density(generate_track.generate(given), given.sampling_rate)
        # The edges of the band are excluded, because the window spreads them.
        band = (frequency > 1.5 * given.speed / given.longest) & (frequency < 0.9 * given.speed / given.shortest)
        ratio = density[band] / generate_track.expected_density(given, frequency[band])
        self.assertLess(abs(numpy.mean(ratio) - 1), 5 / math.sqrt(16 * numpy.count_nonzero(band) / 1.5))

    def test_vehicle_answers_as_its_equations_of_motion_say(self):
        # The equations are integrated under a sine of the track until transients have decayed.
        box = generate_track.AxleBox()
        for frequency in (1.0, 2.5, 8.0):
            amplitude = self.integrated_amplitude(box, frequency)
            expected = abs(box.compression(numpy.array([frequency]))[0])
            self.assertAlmostEqual(amplitude / expected, 1, delta=2e-3, msg="%g Hz" % frequency)

    @staticmethod
    def integrated_amplitude(box, frequency):
        omega = 2 * math.pi * frequency

        def rate(time, state):
            bogie, bogie_rate, body, body_rate = state
            track, track_rate = math.sin(omega * time), omega * math.cos(omega * time)
            primary = box.primary_stiffness * (track - bogie) + box.primary_damping * (track_rate - bogie_rate)
            secondary = box.secondary_stiffness * (bogie - body) + box.secondary_damping * (bogie_rate - body_rate)
            return numpy.array(
                [bogie_rate, (primary - secondary) / box.bogie_mass, body_rate, secondary / box.body_mass]
            )

        # The slowest transient (body on secondary) falls by exp(-1/s) or faster, so it is below 1e-5 after 15 s.
        step, state, peak = 1.0 / frequency / 400, numpy.zeros(4), 0.0
        for i in range(int(15 / step)):
            time = i * step
            k1 = rate(time, state)
            k2 = rate(time + step / 2, state + step / 2 * k1)
            k3 = rate(time + step / 2, state + step / 2 * k2)
            k4 = rate(time + step, state + step * k3)
            state = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            if time > 15 - 2 / frequency:
                peak = max(peak, abs(math.sin(omega * (time + step)) - state[0]))
        return peak

    def test_same_seed_gives_the_same_log(self):
        given = options("--duration", "5")
        self.assertTrue(numpy.array_equal(generate_track.generate(given), generate_track.generate(given)))

    def test_band_without_a_line_is_refused(self):
        with self.assertRaisesRegex(ValueError, "no line of the spectrum"):
            generate_track.generate(options("--shortest", "3", "--longest", "2"))


if __name__ == "__main__":
    unittest.main()
