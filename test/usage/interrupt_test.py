#!/usr/bin/python3
"""Tests of Ctrl-C: a command writes each file completely or not at all, and leaves no other files.

Usage: interrupt_test.py FOLDER_OF_THE_COMMANDS

Each command runs to its end once. Then it runs repeatedly, and SIGINT is sent to it and its child processes as a
terminal does: after given shares of its duration, and as soon as it begins to write.
"""
import importlib.util
import json
import math
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from usage_test import CONFIG, PROGRAMS, SHEET

SCRIPTS = CONFIG.parent / "scripts"
SHARES = (0.3, 0.8)  # shares of the duration of a command
SAMPLES = 20_000

# Commands that end by themselves. Their folder contains component.yaml, log.csv (long), short.csv, run.bag,
# half_bogie.yaml, sheet.yaml, jobs.yaml and a completed campaign. They write to `out`.
CALLS = (
    "bag_to_csv --log run.bag --output out/run.csv",
    "csv_to_bag --component bush --log log.csv --output out/run.bag",
    "replay --config component.yaml --log log.csv --output out/force.csv --plot out/force.svg",
    "export --format table --config component.yaml --frequencies 1 4 16 --amplitudes 1e-4 1e-3 --output out/table.csv",
    "export --format adams_bus --config component.yaml --largest-displacement 0.01 --frequency 4 --amplitude 1e-3 --output out/b.bus",
    "export --format fmu2 --config component.yaml --output out/bush.fmu",
    "reproduce_paper --output out/figures",
    "estimate --data-sheet sheet.yaml --output out/bush.yaml",
    "estimate --config component.yaml --from-log short.csv --output out/found.yaml --plot out/found.png",
    "diagnose --config component.yaml --plan short.csv --output out/plan",
    "diagnose --config component.yaml --log short.csv --most-samples 2000 --output out/report",
    "half_bogie --config half_bogie.yaml --track track.csv --output out/vehicle.csv --plot out/vehicle.svg",
    "campaign make --jobs jobs.yaml --output out/campaign",
    "campaign collect campaign",
    "generate_track --output out/track.csv --plot out/track.svg --duration 600",
)


def write_log(path, samples, rate):
    with open(path, "w", encoding="ascii") as file:
        file.write("time_s,displacement_mm,force_kN\n")
        for i in range(samples):
            t = i / rate
            x = math.sin(2 * math.pi * 3 * t) + 0.3 * math.sin(2 * math.pi * 0.7 * t)
            file.write(f"{t:.6f},{x:.6f},{0.95 * x + 0.02 * math.copysign(1, math.cos(2 * math.pi * 3 * t)):.6f}\n")


def program(name):
    return SCRIPTS / name if (SCRIPTS / name).exists() else PROGRAMS / name


def start(line, folder):
    name, *arguments = line.split()
    return subprocess.Popen([program(name), *arguments], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                            text=True, start_new_session=True)


def files_in(folder):
    """Return the sizes of files, except for files that a running program renames meanwhile."""
    sizes = {}
    for path in folder.rglob("*"):
        try:
            if path.is_file():
                sizes[path.relative_to(folder)] = path.stat().st_size
        except FileNotFoundError:
            continue
    return sizes


def is_complete(path, size):
    """Return True if a file is complete: HTML and JSON by their ends, others by the size of a complete run."""
    if path.suffix == ".html":
        return path.read_text(encoding="utf-8").rstrip().endswith("</html>")
    if path.suffix == ".json":
        return bool(json.loads(path.read_text(encoding="utf-8")))
    return path.stat().st_size == size


class Interrupt(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        shutil.copy(CONFIG / "diagnosis_example" / "component.yaml", cls.folder)
        shutil.copy(CONFIG / "half_bogie.yaml", cls.folder)
        (cls.folder / "sheet.yaml").write_text(SHEET, encoding="ascii")
        write_log(cls.folder / "log.csv", SAMPLES, 1000.0)
        write_log(cls.folder / "short.csv", 1500, 100.0)
        write_log(cls.folder / "track.csv", 2000, 1000.0)
        (cls.folder / "jobs.yaml").write_text(
            "jobs:\n  one:\n    command: replay\n    config: component.yaml\n    log: short.csv\n", encoding="ascii")
        (cls.folder / "out").mkdir()
        for line in ("csv_to_bag --component bush --log log.csv --output run.bag",
                     "campaign make --jobs jobs.yaml --output campaign", "campaign run campaign"):
            cls.run_to_the_end(line)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def run_to_the_end(cls, line):
        process = start(line, cls.folder)
        errors = process.communicate(timeout=600)[1]
        if process.returncode != 0:
            raise AssertionError(f"{line}: {errors}")

    def empty(self):
        shutil.rmtree(self.folder / "out")
        (self.folder / "out").mkdir()

    def interrupt(self, line, when):
        """Run a command until `when(process)` returns, send Ctrl-C, and return the exit status."""
        process = start(line, self.folder)
        when(process)
        try:
            os.killpg(process.pid, signal.SIGINT)
        except ProcessLookupError:
            pass
        process.communicate(timeout=120)
        return process.returncode

    def check(self, line, before, reference, returncode):
        for path, _ in files_in(self.folder).items():
            if path not in reference:
                self.assertIn(path, before, f"{line}: {path} is left (exit status {returncode})")
            elif path not in before:
                self.assertTrue(is_complete(self.folder / path, reference[path]), f"{line}: {path} is cut off")
        for path, size in before.items():
            if path.suffix == ".html" and not (self.folder / path).exists():
                continue  # an old page is removed before new data are written; the new page is drawn at the end
            self.assertTrue(is_complete(self.folder / path, reference.get(path, size)), f"{line}: {path} is damaged")

    def begins_to_write(self, known):
        def wait(process):
            end = time.monotonic() + 60
            while process.poll() is None and time.monotonic() < end and set(files_in(self.folder)) <= known:
                time.sleep(0.001)
        return wait

    def test_leaves_no_half_files(self):
        for line in CALLS:
            if not program(line.split()[0]).exists():  # half_bogie needs Simbody
                continue
            if "reproduce_paper" in line and not importlib.util.find_spec("rubber_suspension_core"):
                continue  # the Python module was not built
            with self.subTest(line):
                self.empty()
                before = files_in(self.folder)
                begin = time.monotonic()
                self.run_to_the_end(line)
                duration = time.monotonic() - begin
                reference = files_in(self.folder)
                self.assertTrue(set(reference) - set(before) or "collect" in line, "nothing was written")
                # Existing files stay or are replaced.
                self.check(line, reference, reference, self.interrupt(line, self.begins_to_write(set(reference))))
                for share in SHARES:
                    self.empty()
                    status = self.interrupt(line, lambda process, share=share: time.sleep(share * duration))
                    self.check(line, before, reference, status)
                    self.assertIn(status, (0, -signal.SIGINT, 128 + signal.SIGINT), line)
                self.empty()
                self.check(line, before, reference, self.interrupt(line, self.begins_to_write(set(before))))


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class InterruptPlayback(unittest.TestCase):
    """Recordings of a playback contain complete rows for all samples that were answered."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        shutil.copy(CONFIG / "diagnosis_example" / "component.yaml", self.folder)
        write_log(self.folder / "log.csv", 20_000, 200.0)
        port = free_port()
        self.environment = {**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_HOSTNAME": "127.0.0.1",
                            "ROS_HOME": str(self.folder / "ros")}
        self.start("rosmaster", "--core", "-p", str(port))
        self.start(PROGRAMS / "simulate", "_config_file:=component.yaml")

    def start(self, *words, stderr=subprocess.DEVNULL):
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL,
                                   stderr=stderr, text=True, start_new_session=True)
        self.addCleanup(process.wait, 60)
        self.addCleanup(process.terminate)
        return process

    def interrupt(self, *words):
        """Send Ctrl-C one second after the program has begun to write, and return its stderr."""
        process = self.start(*words, stderr=subprocess.PIPE)
        out = self.folder / "out"
        end = time.monotonic() + 60
        while not any(out.iterdir()) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        time.sleep(1)
        os.killpg(process.pid, signal.SIGINT)
        return process.communicate(timeout=60)[1]

    def test_play_log(self):
        (self.folder / "out").mkdir()
        errors = self.interrupt(PROGRAMS / "play_log", "--component", "primary_bush", "--log", "log.csv",
                                "--playback-speed", "1", "--output", "out/force.csv", "--bag", "out/run.bag", "--plot",
                                "out/force.svg")
        self.assertIn(": each sample so far had exactly one force", errors)
        self.assertNotIn("not every sample", errors)
        left = {path.name for path in (self.folder / "out").iterdir()}
        self.assertLessEqual(left, {"force.csv", "run.bag"})
        if "force.csv" in left:
            text = (self.folder / "out" / "force.csv").read_text(encoding="ascii")
            self.assertTrue(text.endswith("\n"))
            self.assertEqual({line.count(",") for line in text.splitlines()}, {2})

    def test_check_force(self):
        (self.folder / "out").mkdir()
        process = self.start(PROGRAMS / "check_force", "--component", "primary_bush", "--log", "log.csv", "--playback-speed",
                             "1", "--tolerance", "1", "--plot", "out/force.svg", "--gtest_output", "xml:out/report.xml")
        time.sleep(3)
        os.killpg(process.pid, signal.SIGINT)
        process.wait(60)
        left = {path.name for path in (self.folder / "out").iterdir()}
        self.assertLessEqual(left, {"report.xml"})
        if left:
            self.assertTrue((self.folder / "out" / "report.xml").read_text(encoding="utf-8").rstrip().endswith("</testsuites>"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
