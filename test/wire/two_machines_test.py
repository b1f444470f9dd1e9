#!/usr/bin/python3
"""Runs the commands of docs/network_and_real_time.md for a bench of two computers, unchanged, with a network namespace
for each: the player on the second computer receives its forces, and a third computer reaches no port. Requires root or
user namespaces, ip (iproute2) and, for the firewall, nft. Without them a test is skipped.

    two_machines_test.py PACKAGE    # its folder; rosrun and roslaunch have to find it
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import tcpros

PACKAGE = pathlib.Path()
SAMPLES = 200
AT_FIRST = {"ROS_IP": "10.0.0.1", "ROS_MASTER_URI": "http://10.0.0.1:11311"}
PATIENCE = 180.0  # [s], ends a wait that fails
PROBE = """
import socket, sys, concurrent.futures
def is_open(address):
    try:
        socket.create_connection(address, 1.0).close()
        return True
    except OSError:
        return False
addresses = [(host, int(port)) for host in sys.argv[1].split(",") for port in sys.argv[2:]]
with concurrent.futures.ThreadPoolExecutor(len(addresses)) as pool:
    print(*(f"{host}:{port}" for (host, port), found in zip(addresses, pool.map(is_open, addresses)) if found))
"""


def recipes():
    """Return the four blocks of commands: firewall, namespace, first and second computer."""
    page = (PACKAGE / "docs" / "network_and_real_time.md").read_text()
    section = page[page.index("### A bench of two machines"):page.index("## Real time")]
    return re.findall(r"```sh\n(.*?)```", section, re.DOTALL)


def within(namespace, command):
    # `ip netns exec` would hide a namespace that the command adds.
    return ["nsenter", f"--net=/run/netns/{namespace}", *command]


def run(command, namespace=None, **options):
    done = subprocess.run(within(namespace, command) if namespace else command, capture_output=True, text=True,
                          timeout=PATIENCE, check=False, **options)
    if done.returncode != 0:
        raise RuntimeError(f"{command}: status {done.returncode}: {done.stderr.strip()}")
    return done.stdout


class TwoMachines(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="two_machines."))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "bench.csv").write_text("time_s,displacement_m\n" + "".join(
            f"{0.01 * i:.2f},{1e-5 * i}\n" for i in range(SAMPLES)))
        self.names = ["first", "second", "third", "cable", "office", "bench"]
        for name in self.names[:-1]:
            run(["ip", "netns", "add", name])
            run(["ip", "-n", name, "link", "set", "lo", "up"])
        self.addCleanup(self.remove_namespaces)

    def remove_namespaces(self):
        for name in self.names:
            if pathlib.Path("/run/netns", name).exists():
                run(["ip", "netns", "delete", name])

    @staticmethod
    def connect(switch, *machines):
        """Connect interfaces by an Ethernet switch. Each interface has the address of a computer."""
        run(["ip", "-n", switch, "link", "add", "bridge", "type", "bridge"])
        run(["ip", "-n", switch, "link", "set", "bridge", "up"])
        for name, interface, address in machines:
            run(["ip", "-n", switch, "link", "add", name, "type", "veth", "peer", "name", interface, "netns", name])
            run(["ip", "-n", switch, "link", "set", name, "master", "bridge", "up"])
            run(["ip", "-n", name, "address", "add", address + "/24", "dev", interface])
            run(["ip", "-n", name, "link", "set", interface, "up"])

    def environment(self, **more):
        kept = {key: value for key, value in os.environ.items() if key not in ("ROS_HOSTNAME", "ROS_IP", "ROS_MASTER_URI")}
        return dict(kept, ROS_HOME=str(self.folder), ROS_LOG_DIR=str(self.folder), **more)

    def launch(self, namespace, commands):
        """Start master and node, and return the ports on which the node listens. The master is started first, because
        roslaunch waits only 10 s for a master that it starts itself."""
        self.start(namespace, "exec rosmaster --core -p 11311", r'(11311)\s.*"rosmaster"')
        return self.start(namespace, commands, r'(\d+)\s.*"simulate"', 2)  # ports for messages and slave API

    def start(self, namespace, commands, pattern, least=1):
        """Start programs. When at least `least` ports match the pattern, return all ports on which they listen."""
        log = (self.folder / "programs.log").open("a+")
        process = subprocess.Popen(within(namespace, ["bash", "-ec", commands]), stdout=log, stderr=subprocess.STDOUT,
                                   cwd=PACKAGE, env=self.environment(**AT_FIRST), start_new_session=True)
        self.addCleanup(log.close)
        self.addCleanup(self.end, process)
        end = time.monotonic() + PATIENCE
        while True:
            listening = run(["ss", "-Htlnp"], namespace)
            if len(re.findall(pattern, listening)) >= least:
                return sorted(set(re.findall(r":(\d+)\s", listening)))
            if time.monotonic() > end or process.poll() is not None:
                log.seek(0)
                self.fail(f"{commands}: status {process.poll()}, {listening}\n{log.read()}")
            time.sleep(0.05)

    @staticmethod
    def end(process):
        if process.poll() is not None:
            return
        os.killpg(process.pid, signal.SIGINT)
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def play(self, commands):
        """Play a log on the second computer, and check that each sample has its force."""
        run(["bash", "-ec", commands], "second", cwd=self.folder, env=self.environment())
        rows = (self.folder / "forces.csv").read_text().splitlines()
        self.assertEqual(len(rows), 1 + SAMPLES)

    @staticmethod
    def reached(ports, hosts):
        """Return the addresses to which the third computer can connect."""
        return run([sys.executable, "-c", PROBE, ",".join(hosts), *ports], "third").split()

    def test_by_a_firewall(self):
        if not shutil.which("nft"):
            self.skipTest("nft is absent (nftables)")
        firewall, _, first, second = recipes()
        self.connect("cable", ("first", "eth1", "10.0.0.1"), ("second", "eth1", "10.0.0.2"), ("third", "eth1", "10.0.0.3"))
        ports = self.launch("first", first)
        self.assertEqual(len(self.reached(ports, ["10.0.0.1"])), len(ports), "without the rules all are open")
        run(["bash", "-ec", firewall], "first")
        self.play(second)
        self.assertEqual(self.reached(ports, ["10.0.0.1"]), [])

    def test_by_a_network_namespace(self):
        _, namespace, first, second = recipes()
        self.connect("cable", ("first", "eth1", "10.0.0.1"), ("second", "eth1", "10.0.0.2"))
        self.connect("office", ("first", "eth0", "10.1.0.1"), ("third", "eth0", "10.1.0.3"))
        run(["ip", "-n", "third", "route", "add", "10.0.0.0/24", "via", "10.1.0.1"])
        run(["sh", "-c", "echo 1 >/proc/sys/net/ipv4/ip_forward"], "first")
        run(["bash", "-ec", namespace], "first")
        ports = self.launch("bench", first)
        self.play(second)
        self.assertEqual(self.reached(ports, ["10.0.0.1", "10.1.0.1"]), [])

    def test_a_launch_file_keeps_its_node_to_itself(self):
        """The launch file is started without an address, and the master has its address from the environment."""
        self.connect("cable", ("first", "eth1", "10.0.0.1"), ("third", "eth1", "10.0.0.3"))
        self.launch("first", "roslaunch rubber_suspension simulate.launch config:=$PWD/config/example.yaml")
        ports = re.findall(r':(\d+)\s.*"simulate"', run(["ss", "-Htlnp"], "first"))
        # The node restricts its slave API to the loopback interface during its start, which may not be complete.
        tcpros.until(lambda: not self.reached(ports, ["10.0.0.1"]), "the node to be out of reach", PATIENCE)


def enter(arguments):
    """Restart in new namespaces, so that the namespaces of the computer are not changed."""
    own = ["unshare", *([] if os.getuid() == 0 else ["--user", "--map-root-user"]), "--mount", "--net"]
    ready = "mount -t tmpfs tmpfs /run && mkdir /run/netns"
    if not shutil.which("ip"):
        refusal = "ip is absent (iproute2)"
    else:
        refusal = subprocess.run([*own, "sh", "-c", f"{ready} && ip netns add own"], stderr=subprocess.PIPE, text=True,
                                 check=False).stderr.strip()
    if refusal:
        print(f"Skipped: network namespaces need root or user namespaces, and ip: {refusal}")
        sys.exit(77)
    os.execvp(own[0], [*own, "sh", "-c", ready + ' && exec "$@"', "sh", sys.executable, *arguments, "entered"])


if __name__ == "__main__":
    if sys.argv[-1] != "entered":
        enter(sys.argv)
    PACKAGE = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[2:-1]], verbosity=2)
