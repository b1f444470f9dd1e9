#!/usr/bin/python3
"""Tests of messages of the scripts: why apt failed (from logs of apt-get 2.6.1 and dpkg 1.21.22 of Debian 12), the
progress of a build, and that an interrupted script prints none.

Run in this folder: python3 -m unittest scripts_test
"""
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
NETWORK = "is there a network?"


def reason(log):
    command = ["awk", "-f", SCRIPTS / "apt_reason.awk", HERE / "apt_logs" / f"{log}.txt"]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


class AptReason(unittest.TestCase):
    def test_a_package_that_cannot_be_configured(self):
        self.assertEqual(reason("postinst_fails"), [
            "bearing: cannot write /etc/bearing.conf: Read-only file system",
            "dpkg: error processing package bearing (--configure):",
            " installed bearing package post-installation script subprocess returned error exit status 1"])

    def test_a_file_of_another_package(self):
        self.assertEqual(reason("file_of_another"), [
            "dpkg: error processing archive /tmp/clash.deb (--unpack):",
            " trying to overwrite '/bin/bash', which is also in package bash 5.2.15-2+b13"])

    def test_packages_that_there_are_none_of(self):
        self.assertEqual(reason("unable_to_locate"), [f"Unable to locate package {name}"
                                                      for name in ("no-such-package", "other-missing")])

    def test_packages_that_do_not_go_together(self):
        self.assertEqual(reason("unmet"),
                         [" wants : Depends: libc6 (>= 99) but 2.36-9+deb12u14 is to be installed"])

    def test_what_apt_itself_says_where_it_was_nothing_else(self):
        self.assertEqual(reason("no_archives_folder"),
                         ["Archives directory /tmp/none/partial is missing. - Acquire (2: No such file or directory)"])

    def test_the_network_where_it_was_that(self):
        for log, said in (("no_network", "Temporary failure resolving 'deb.debian.org'"),
                          ("could_not_connect", "Could not connect to 127.0.0.1:9 (127.0.0.1)")):
            lines = reason(log)
            self.assertEqual(len(lines), 1, lines)
            self.assertIn(said, lines[0])
            self.assertIn(NETWORK, lines[0])

    def test_no_package_is_found_where_the_lists_could_not_be_fetched(self):
        lines = reason("no_lists")
        self.assertEqual(lines[0], "Unable to locate package cmake")
        self.assertIn(NETWORK, lines[1])

    def test_the_network_is_asked_about_nowhere_else(self):
        for log in ("postinst_fails", "file_of_another", "unable_to_locate", "unmet", "no_archives_folder"):
            self.assertNotIn(NETWORK, "\n".join(reason(log)), log)


class Progress(unittest.TestCase):
    def thinned(self, text):
        return subprocess.run(["bash", "-c", '. "$0"; thin_out', SCRIPTS / "lib.sh"], input=text, check=True,
                              capture_output=True, text=True).stdout.splitlines()

    def test_of_many_steps_one_at_a_time_and_the_last_is_shown(self):
        for steps in ([f"[{i}/600] Building CXX object {i}.o" for i in range(1, 601)],
                      [f"[{i:3}%] Building CXX object {i}.o" for i in range(1, 101)]):
            self.assertEqual(self.thinned("\n".join(steps) + "\n"), [steps[0], steps[-1]])

    def test_what_else_is_said_is_kept(self):
        lines = ["[1/3] Building CXX object a.o", "a.cpp:1: error: no", "[2/3] Building CXX object b.o", "FAILED: b.o"]
        self.assertEqual(self.thinned("\n".join(lines)), [lines[0], lines[1], lines[3]])


class Interrupted(unittest.TestCase):
    """A launch file that fails interrupts its other nodes, which must not print a traceback then."""

    def test_live_plot_ends_without_a_traceback(self):
        with tempfile.TemporaryDirectory() as folder:
            for imported in ("numpy", "matplotlib"):
                process = subprocess.Popen([SCRIPTS / "live_plot", "--component", "bush", "--headless", "--picture",
                                            f"{folder}/bush.png"], stderr=subprocess.PIPE, text=True,
                                           env={"PATH": "/usr/bin:/bin", "ROS_MASTER_URI": "http://127.0.0.1:9"})
                maps = pathlib.Path(f"/proc/{process.pid}/maps")
                while process.poll() is None and imported not in maps.read_text(encoding="utf-8"):
                    time.sleep(0.005)
                process.send_signal(signal.SIGINT)
                self.assertNotIn("KeyboardInterrupt", process.communicate(timeout=60)[1])


if __name__ == "__main__":
    unittest.main()
