#!/usr/bin/python3
"""Tests of state files, reports, component files and records of a campaign after a power cut or kill -9.

Usage: power_cut_test.py FOLDER_OF_THE_COMMANDS [KILLS]

With strace, each file must be on the disk before it is renamed, and its folder after that. With kill -9 at random
moments, every file under its final name must be complete: the old file or the new one.
"""
import os
import pathlib
import random
import re
import shutil
import signal
import sys
import tempfile
import time
import unittest

KILLS = int(sys.argv.pop(2)) if len(sys.argv) > 2 else 20
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "wire"))

import interrupt_test  # noqa: E402
import tcpros  # noqa: E402
from interrupt_test import files_in, is_complete, program, start  # noqa: E402
from usage_test import CONFIG, PROGRAMS  # noqa: E402

DIAGNOSE = "diagnose --config component.yaml --log short.csv --most-samples 1000 --output out/report"
REPLAY = "replay --config component.yaml --log short.csv --output out/force.csv"
CAMPAIGN = "campaign run out/campaign"
TRACED = ("strace", "-f", "-y", "-qq", "-s", "4096", "-e", "trace=fsync,rename", "-o")


def unsynced(trace):
    """Return the renamed files without fsync of the file before or of the folder after, and all renamed files."""
    calls = [line.split(" ", 1)[1].strip() for line in trace.read_text().splitlines()]
    synced = [re.match(r"fsync\(\d+<([^>]*)>\) += 0", call) for call in calls]
    wrong, renamed = [], []
    for i, call in enumerate(calls):
        match = re.match(r'rename\("([^"]*)", "([^"]*)"\) += 0', call)
        if not match or match[1].endswith(".new"):  # the heartbeat of a campaign is not needed after a power cut
            continue
        written, target = match.groups()
        renamed.append(os.path.basename(target))
        before = any(sync and sync[1] == written for sync in synced[:i])
        after = any(sync and sync[1] == os.path.dirname(target) for sync in synced[i + 1:])
        if not (before and after):
            wrong.append(target)
    return wrong, renamed


class PowerCut(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        shutil.copy(CONFIG / "diagnosis_example" / "component.yaml", self.folder)
        interrupt_test.write_log(self.folder / "short.csv", 1500, 100.0)
        (self.folder / "jobs.yaml").write_text(
            "jobs:\n  one:\n    command: diagnose\n    config: component.yaml\n    log: short.csv\n", encoding="ascii")
        self.make()

    def make(self):
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        (self.folder / "out").mkdir()
        self.run_to_the_end("campaign make --jobs jobs.yaml --output out/campaign")

    def run_to_the_end(self, line):
        process = start(line, self.folder)
        errors = process.communicate(timeout=600)[1]
        self.assertEqual(process.returncode, 0, f"{line}: {errors}")

    def test_commands_sync_file_and_folder(self):
        trace = self.folder / "trace"
        for line, wanted in ((DIAGNOSE, {"report.json", "augmented.yaml"}), (CAMPAIGN, {"report.json", "augmented.yaml"}),
                             (REPLAY, {"force.csv"})):
            name, *arguments = line.split()
            process = interrupt_test.subprocess.run([*TRACED, trace, program(name), *arguments], cwd=self.folder,
                                                    capture_output=True, text=True, check=False)
            self.assertEqual(process.returncode, 0, process.stderr)
            wrong, renamed = unsynced(trace)
            self.assertEqual(wrong, [], line)
            self.assertLessEqual(wanted, set(renamed), line)
            self.assertTrue(line != CAMPAIGN or any(re.fullmatch(r"[0-9a-f]{32,}\.json", name) for name in renamed), line)

    def test_the_node_syncs_its_state(self):
        network = tcpros.Network(str(self.folder))
        self.addCleanup(network.close)
        trace, state = self.folder / "trace", self.folder / "state.json"
        node = network.start([*TRACED, str(trace), str(PROGRAMS / "simulate"),
                              f"_config_file:={self.folder / 'component.yaml'}", f"_state_file:={state}"], "simulate")
        tcpros.until(lambda: tcpros.trigger(network.call("/simulate/save_state"))[0], "a saved state")
        self.assertTrue(state.exists())
        wrong, renamed = unsynced(trace)
        self.assertEqual(wrong, [])
        self.assertIn(state.name, renamed)
        os.killpg(node.process.pid, signal.SIGKILL)  # kills both strace and the node

    def test_a_kill_leaves_old_or_new(self):
        lines = (DIAGNOSE, REPLAY, CAMPAIGN)
        durations = {}
        for line in lines:
            begin = time.monotonic()
            self.run_to_the_end(line)
            durations[line] = time.monotonic() - begin
        reference = files_in(self.folder)
        moments = random.Random(1)
        caught = 0
        for kill in range(KILLS):
            line = lines[kill % len(lines)]
            if line == CAMPAIGN or kill % 2:
                self.make()
            process = start(line, self.folder)
            time.sleep(moments.uniform(0.0, durations[line]))
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate(timeout=60)
            caught += process.returncode == -signal.SIGKILL
            for path in files_in(self.folder):
                if not path.name.startswith(".") and path in reference:
                    self.assertTrue(is_complete(self.folder / path, reference[path]), f"{line}: {path} is half")
        print(f"{caught} of {KILLS} kills came before the end")
        self.assertGreater(caught, KILLS // 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
