#!/usr/bin/python3
"""Attacks that a node must withstand: masters that hang or lie, messages with excessive sizes, stopped processes,
stalled subscribers, files with wrong content. Each test has its own master and node, and speaks the protocols of ROS to
them without ROS.

    attacks_test.py PROGRAMS [NODE [TEST ...]]    # folder of the programs; another program in place of simulate, or ''
"""

import math
import os
import re
import shutil
import signal
import struct
import sys
import tempfile
import threading
import time
import unittest
import xmlrpc.server

import tcpros

PROGRAMS = ""
SIMULATE = ""
SANITIZED = False
NODE = "/simulate"
MEBIBYTE = 1 << 20
FRAME = tcpros.FRAME
FORCE_SIZE = tcpros.FORCE_SIZE
sample = tcpros.sample


def processor_seconds(node):
    with open(f"/proc/{node.process.pid}/stat") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")  # user and system time


class Attack(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="attack.")
        self.addCleanup(shutil.rmtree, self.folder)
        self.network = tcpros.Network(self.folder)
        self.addCleanup(self.network.close)

    def components(self, names):
        path = os.path.join(self.folder, "components.yaml")
        with open(path, "w") as file:
            file.write("components:\n")
            for name in names:
                file.write(f"  {name}:\n    model: elements\n    elements:\n"
                           "      - {type: spring, stiffness: 3.0e6}\n"
                           "      - {type: friction, maximum_force: 6000.0, displacement: 0.0022}\n")
        return path

    def start(self, names=("left", "right"), config=None, before=(), environment=None, **parameters):
        """Start the node. `before` is a command that runs it, for example with other limits."""
        arguments = [f"_config_file:={config or self.components(names)}"]
        arguments += [f"_{key}:={value}" for key, value in parameters.items()]
        return self.network.start([*before, SIMULATE, *arguments], "simulate", **(environment or {}))

    def lie(self, method, answer):
        """Return the URI of a master that gives a wrong answer to one method, and forwards all others."""
        network = self.network

        class Liar(xmlrpc.server.SimpleXMLRPCServer):
            def _dispatch(self, name, arguments):
                return answer if name == method else getattr(tcpros.proxy(network.uri), name)(*arguments)

        server = Liar((tcpros.HOST, 0), logRequests=False, allow_none=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        return f"http://{tcpros.HOST}:{server.server_address[1]}"

    def forces_of(self, name, **connection):
        """Subscribe to a component's forces, once the node has subscribed to its displacements. Before that time, the
        node drops subscribers without counting their undelivered forces."""
        tcpros.until(lambda: self.takes(name), f"the node to take displacements of {name}")
        return self.network.subscribe(NODE, f"/{name}/force", **connection)

    def takes(self, name):
        _, subscribed, _ = self.network.master.getSystemState(tcpros.CALLER)[2]
        return any(topic == f"/{name}/displacement" and NODE in nodes for topic, nodes in subscribed)

    def counts(self, report, name, key, wanted, reports=15):
        """Return the value of a counter when it is as wanted, or after some reports, which come once per second."""
        value = None
        for _ in range(reports):
            value = self.values(report, name).get(key)
            if value == str(wanted):
                break
        return int(value)

    @staticmethod
    def values(report, name):
        """Return the values of the next report with this component, which the report at the start does not contain."""
        while True:
            statuses = tcpros.diagnostics(tcpros.next_message(report))
            if name in statuses:
                return statuses[name][2]

    def registrations(self):
        state = self.network.master.getSystemState(tcpros.CALLER)[2]
        return [name for part in state for name, nodes in part if NODE in nodes]

    def exits(self, node, limit):
        """Return the exit status and check the time limit [s], which is longer for a node with sanitizers."""
        begin = time.monotonic()
        status = node.process.wait(tcpros.PATIENCE)
        self.assertLess(time.monotonic() - begin, limit * (5 if SANITIZED else 1))
        return status


class Flood:
    """Sends samples to components and reads their forces in threads, with two connections per component."""

    def __init__(self, network, names):
        self.links = [(network.publish(f"/{name}/displacement", "rubber_suspension/Displacement"),
                       network.subscribe(NODE, f"/{name}/force")) for name in names]
        self.received = [0] * len(names)
        self.threads = []
        for i, (_, reader) in enumerate(self.links):
            self.threads.append(threading.Thread(target=self.read, args=(i, reader), daemon=True))
            self.threads[-1].start()

    def read(self, i, reader):
        reader.settimeout(None)
        try:
            while data := reader.recv(1 << 18):
                self.received[i] += len(data)
        except OSError:
            pass

    def send(self, data):
        """Send the same bytes to all components, as fast as the node reads them."""
        senders = [threading.Thread(target=writer.sendall, args=(data,)) for writer, _ in self.links]
        for sender in senders:
            sender.start()
        return senders

    def forces(self, i):
        return self.received[i] // FORCE_SIZE


class Answers(Attack):
    """Tests that every accepted sample has a force, and that samples and forces dropped by queues are counted."""

    def accounted(self, flood, names, sent):
        """Check that all samples and forces arrive or are counted as lost, and return the number of lost forces."""
        report = self.network.subscribe(NODE, "/diagnostics")
        lost = 0
        for i, name in enumerate(names):
            for _ in range(30):
                values = self.values(report, name)
                accepted, missed = int(values["accepted"]), int(values["forces not delivered"])
                if accepted + int(values["lost before arrival"]) == sent and flood.forces(i) + missed == accepted:
                    break
            self.assertEqual(accepted + int(values["lost before arrival"]), sent, name)
            self.assertEqual(flood.forces(i) + missed, accepted, name)
            lost += missed
        return lost

    def test_after_the_node_was_stopped_nothing_accepted_is_lost(self):
        names = [f"c{i}" for i in range(10)]
        node = self.start(names)
        flood = Flood(self.network, names)
        flood.send(sample(0))
        tcpros.until(lambda: all(flood.forces(i) == 1 for i in range(10)), "a force each")
        node.process.send_signal(signal.SIGSTOP)
        senders = flood.send(b"".join(sample(i) for i in range(1, 14001)))  # 14 s at 1 kHz
        node.process.send_signal(signal.SIGCONT)
        for sender in senders:
            sender.join()
        flood.send(sample(14001))  # its sequence number shows how many samples were lost before
        self.assertEqual(self.accounted(flood, names, 14002), 0)

    def test_a_burst_beyond_all_queues_is_counted(self):
        names = ["left", "right"]
        self.start(names)
        flood = Flood(self.network, names)
        flood.send(sample(0))
        tcpros.until(lambda: all(flood.forces(i) == 1 for i in range(2)), "a force each")
        for sender in flood.send(b"".join(sample(i) for i in range(1, 100001))):
            sender.join()
        flood.send(sample(100001))
        self.assertEqual(self.accounted(flood, names, 100002), 0)

    def test_a_queue_of_one_loses_no_answer(self):
        self.start(["left"], queue_size=1)
        flood = Flood(self.network, ["left"])
        flood.send(sample(0))
        tcpros.until(lambda: flood.forces(0) == 1, "a force")
        for sender in flood.send(b"".join(sample(i) for i in range(1, 20001))):
            sender.join()
        # The last sample may replace the previous one in the queue, but nothing replaces the last sample.
        flood.send(sample(20001))
        self.assertEqual(self.accounted(flood, ["left"], 20002), 0)

    def test_what_a_slow_subscriber_does_not_get_is_counted(self):
        self.start(["left"])
        stalled = self.forces_of("left", receive_buffer=4096)
        flood = Flood(self.network, ["left"])
        size = 0
        while size < 300000:  # far more than fits into the queue of 40000 and the buffers of the sockets
            for sender in flood.send(b"".join(sample(i) for i in range(size, size + 2000))):
                sender.join()
            size += 2000
            tcpros.until(lambda: flood.forces(0) == size, "the other subscriber's forces")
        report = self.network.subscribe(NODE, "/diagnostics")
        # The first report after the last force may be older than this force. The second one cannot be.
        tcpros.until(lambda: int(self.values(report, "left")["forces not delivered"]) > 0, "losses that are counted")
        missed = int(self.values(report, "left")["forces not delivered"])
        received = 0
        stalled.settimeout(tcpros.PATIENCE)
        while received < (size - missed) * FORCE_SIZE:
            received += len(stalled.recv(1 << 18))
        # One more force reaches both subscribers, directly after the last force that was read.
        flood.send(sample(size))
        data = tcpros.receive(stalled, FORCE_SIZE)
        self.assertEqual(received, (size - missed) * FORCE_SIZE)
        self.assertEqual(struct.unpack_from("<d", data, FORCE_SIZE - 40)[0], 1e-3)
        self.assertEqual(struct.unpack_from("<I", data, 8)[0] * 1000 + struct.unpack_from("<I", data, 12)[0] // 1000000,
                         1000 * 1000 + size)
        self.assertEqual(self.counts(report, "left", "forces not delivered", missed), missed)

    def test_a_force_that_several_subscribers_lose_counts_once(self):
        self.start(["left"])
        slow = {"/stalled": 0, "/slow": 1000}  # forces that each subscriber reads per 2000 sent
        links = {caller: self.forces_of("left", receive_buffer=4096, caller=caller) for caller in slow}
        flood = Flood(self.network, ["left"])
        data = dict.fromkeys(slow, b"")
        size = 0
        while size < 160000:  # both queues are full by then
            self.feed(flood, size, 2000)
            size += 2000
            for caller, link in links.items():
                data[caller] += tcpros.receive(link, slow[caller] * FORCE_SIZE)
        # One more sample marks the end of the forces to be read.
        self.feed(flood, size, 1)
        lost = set()
        for caller, link in links.items():
            numbers = [number for number, in struct.iter_unpack(f"<4xI{FORCE_SIZE - 8}x", data[caller])]
            while not numbers or numbers[-1] != size:
                numbers.append(struct.unpack_from("<I", tcpros.receive(link, FORCE_SIZE), 4)[0])
            missing = set(range(size + 1)) - set(numbers)
            self.assertGreater(len(missing), 0, caller)
            lost |= missing
        report = self.network.subscribe(NODE, "/diagnostics")
        self.assertEqual(self.counts(report, "left", "forces not delivered", len(lost)), len(lost))
        for link in links.values():
            link.close()
        self.feed(flood, size + 1, 2000)  # both subscribers have left
        self.assertEqual(self.counts(report, "left", "forces not delivered", len(lost)), len(lost))

    def feed(self, flood, first, count, frame=FRAME):
        """Send samples, and wait until the reading subscriber has their forces."""
        force = FORCE_SIZE - len(FRAME) + len(frame)
        before = flood.received[0]
        for sender in flood.send(b"".join(sample(i, frame=frame) for i in range(first, first + count))):
            sender.join()
        tcpros.until(lambda: flood.received[0] == before + count * force, "the forces of who reads")

    def loses(self):
        """Return true if a force was lost to a subscriber."""
        report = self.network.subscribe(NODE, "/diagnostics")
        self.values(report, "left")  # may be older than the last force
        missed = int(self.values(report, "left")["forces not delivered"])
        report.close()
        return missed > 0

    def growth(self, frame):
        """Return the memory [bytes] that a first and a second stalled subscriber of a topic add to the node."""
        node = self.start(["left"])
        flood = Flood(self.network, ["left"])
        size = 0
        while size < 70000:  # until the memory has settled
            self.feed(flood, size, 2000, frame)
            size += 2000
        memory = [node.memory()]
        links = []
        needed = 0  # number of forces until a queue is full; the sockets buffer some MiB before that
        for caller in ("/first", "/second"):
            links.append(self.forces_of("left", receive_buffer=4096, caller=caller))
            begin = size
            full = False
            while not full:
                for _ in range(20):
                    self.feed(flood, size, 2000, frame)
                    size += 2000
                self.assertLess(size, 2000000)
                full = size - begin > needed if needed else self.loses()
            needed = size - begin
            memory.append(node.memory())
        for link in links:
            link.close()
        self.assertEqual(node.end(), 0)
        return memory[1] - memory[0], memory[2] - memory[1]

    def test_memory_of_subscribers_that_stall(self):
        if SANITIZED:
            self.skipTest("the address sanitizer takes memory of its own")
        # docs/performance.md states 7.5 and 2.8 MiB, and 17.4 and 2.5 MiB with the longest frame_id. Memory for a
        # queued force is its message, two blocks of the allocator, and an entry in each queue that contains it.
        for frame, first, further in ((FRAME, 10, 4), (b"x" * 255, 20, 4)):
            with self.subTest(len(frame)):
                growth = self.growth(frame)
                self.assertLess(growth[0], first * MEBIBYTE)
                self.assertLess(growth[1], further * MEBIBYTE)
                # The memory must be at least as large as the queued bytes.
                self.assertGreater(growth[0], 40000 * (FORCE_SIZE - len(FRAME) + len(frame)))

    def test_connections_that_come_and_go_lose_nothing(self):
        self.start(["left"])
        answers = self.forces_of("left")
        api = self.network.node_api(NODE)
        for visit in range(40):
            writer = self.network.publish("/left/displacement", "rubber_suspension/Displacement")
            for i in range(30):
                writer.sendall(sample(30 * visit + i, sequence=1000003 * visit + i))  # arbitrary first number
            for i in range(30):
                tcpros.next_message(answers)
            writer.close()
            self.network.master.unregisterPublisher(tcpros.CALLER, "/left/displacement", self.network.slave_uri)
            # Until the master reports the end of the old publisher, the node reconnects to it, and may reach the next
            # one.
            tcpros.until(lambda: "/left/displacement" not in [link[4] for link in api.getBusInfo(tcpros.CALLER)[2]],
                         "the node to leave a publisher")
        report = self.network.subscribe(NODE, "/diagnostics")  # now, because earlier reports would queue up
        self.assertEqual(self.counts(report, "left", "accepted", 1200), 1200)
        self.assertEqual(self.counts(report, "left", "lost before arrival", 0), 0)


class Masters(Attack):
    def test_a_master_that_hangs_holds_up_nothing(self):
        node = self.start()
        flood = Flood(self.network, ["left"])
        report = self.network.subscribe(NODE, "/diagnostics")
        host, _, port = self.network.master.lookupService(tcpros.CALLER, NODE + "/reset")[2][9:].partition(":")
        self.values(report, "left")
        self.network.master_process.process.send_signal(signal.SIGSTOP)
        for _ in range(6):  # six seconds; the node calls the master every two seconds
            report_of = tcpros.diagnostics(tcpros.next_message(report))
        self.assertEqual(report_of["thread serving 1"][0], 0)
        with tcpros.socket.create_connection((host, int(port)), tcpros.PATIENCE) as sock:
            tcpros.send_header(sock, {"callerid": tcpros.CALLER, "service": NODE + "/reset", "md5sum": "*"})
            tcpros.receive_header(sock)
            sock.sendall(tcpros.text(b""))
            self.assertEqual(tcpros.receive(sock, 1), b"\1")
        flood.send(sample(0))
        tcpros.until(lambda: flood.forces(0) == 1, "a force")
        node.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.exits(node, 1.0), 0)

    def test_a_master_that_lies_is_refused_in_one_line(self):
        uri = self.lie("registerSubscriber", [1, "", 5])
        node = self.start(["left"], environment={"ROS_MASTER_URI": uri})
        self.assertEqual(node.process.wait(tcpros.PATIENCE), 1)
        self.assertEqual(len(node.output().splitlines()), 1, node.output())
        self.assertIn("master", node.output())

    def test_a_signal_cancels_a_reload(self):
        """Reading the file takes far longer than 0.1 s, after which the signal is sent."""
        node = self.start()
        self.network.node_api(NODE)
        path = os.path.join(self.folder, "components.yaml")
        self.network.call(NODE + "/reset")
        with open(path, "w") as file:
            entry = "{type: creep, stiffness_per_decade: 1e5}"
            file.write("components:\n" + "".join(
                f"  c{i}: {{model: elements, elements: [{', '.join([entry] * 400)}]}}\n" for i in range(15)))
        before = processor_seconds(node)
        threading.Thread(target=self.call_until_gone, args=(NODE + "/reload",), daemon=True).start()
        tcpros.until(lambda: processor_seconds(node) > before + 0.1, "the reload to be under way")  # 0.1 s of CPU time
        node.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.exits(node, 5.0), 0)
        self.assertEqual(self.registrations(), [])
        self.assertIn("reload refused: cancelled", node.output())

    def call_until_gone(self, service):
        try:
            self.network.call(service)
        except (OSError, tcpros.WireError):
            pass

    def test_a_signal_cancels_a_look(self):
        if SANITIZED:
            self.skipTest("the diagnosis that the node loads is without sanitizers, and its matrices lie otherwise")
        node = self.start(diagnose="true")
        writer = self.network.publish("/left/displacement", "rubber_suspension/Displacement")
        measured = self.network.publish("/left/measured_force", "rubber_suspension/MeasuredForce")
        forces = self.network.subscribe(NODE, "/left/force")
        for first in range(0, 100000, 2000):  # 100 s at 1 kHz, enough for a search of all candidates
            for i in range(first, first + 2000):
                z = 1e-3 * math.sin(0.02 * i) + 4e-4 * math.sin(0.31 * i)
                measured.sendall(sample(i, 3.3e6 * z + 900.0 * math.sin(0.02 * i + 0.7) ** 3))
                writer.sendall(sample(i, z))
            for _ in range(2000):  # because measured forces far ahead of their samples are not matched
                tcpros.next_message(forces)
        tcpros.until(lambda: all(self.runs(node, "diagnosis") for _ in range(20)), "a look")
        node.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.exits(node, 5.0), 0)
        self.assertEqual(self.registrations(), [])

    @staticmethod
    def runs(node, name):
        """Return True if a thread is ready to run, 50 ms from now. With low priority it may get hardly any CPU time."""
        time.sleep(0.05)
        folder = f"/proc/{node.process.pid}/task"
        for task in os.listdir(folder):
            with open(os.path.join(folder, task, "stat")) as file:
                head, _, rest = file.read().rpartition(")")
            if head.partition("(")[2] == name:
                return rest.split()[0] == "R"
        return False

    def test_without_a_master_a_player_waits_no_longer_than_asked(self):
        log = os.path.join(self.folder, "log.csv")
        with open(log, "w") as file:
            file.write("time_s,displacement_m,force_N\n" + "".join(f"{0.01 * i},{1e-5 * i},{30.0 * i}\n" for i in range(100)))
        self.network.master_process.kill()
        for program, *options in (("play_log",), ("check_force", "--tolerance", "0.1")):
            player = self.network.start([os.path.join(PROGRAMS, program), "--component", "left", "--log", log,
                                         "--connect-timeout", "2", *options], program)
            self.assertEqual(player.process.wait(20.0), 1)
            self.assertIn(f"no master answers at {self.network.uri} within 2 s", player.output())

    def test_a_signal_ends_a_node_that_waits_for_its_master(self):
        self.network.master_process.kill()
        node = self.start()
        tcpros.until(lambda: "waiting for the master" in node.output(), "the node to say so")
        node.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.exits(node, 2.0), 0)

    def test_a_parameter_of_an_argument_goes_with_its_process(self):
        node = self.start(config="/nowhere/old.yaml")
        self.assertEqual(node.process.wait(20.0), 1)
        self.assertIn("/nowhere/old.yaml", node.output())
        self.assertIn("the argument _config_file", node.output())
        self.network.master.setParam(tcpros.CALLER, NODE + "/config_file", "/nowhere/kept.yaml")
        node = self.network.start([SIMULATE], "simulate")
        self.assertEqual(node.process.wait(20.0), 1)
        self.assertIn("/nowhere/kept.yaml", node.output())
        self.assertIn("the private parameter ~config_file, which is set at the ROS master", node.output())
        self.assertEqual(self.network.master.getParam(tcpros.CALLER, NODE + "/config_file")[2], "/nowhere/kept.yaml")
        node = self.start()
        self.network.call(NODE + "/reset")
        self.assertEqual(node.end(), 0)
        self.assertFalse(self.network.master.hasParam(tcpros.CALLER, NODE + "/config_file")[2])

    def test_services_of_twenty_components(self):
        names = [f"c{i}" for i in range(20)]
        self.start(names)
        self.network.call(NODE + "/reload")  # the answer shows that all services exist
        services = [name for name, nodes in self.network.master.getSystemState(tcpros.CALLER)[2][2] if NODE in nodes]
        self.assertLessEqual(len(services), 10, services)
        request = tcpros.text("c7")
        self.assertTrue(tcpros.trigger(self.network.call(NODE + "/reset_component", request))[0])
        self.assertTrue(tcpros.trigger(self.network.call(NODE + "/enable_component", request + b"\0"))[0])
        done, message = tcpros.trigger(self.network.call(NODE + "/reset_component", tcpros.text("c70")))
        self.assertFalse(done)
        self.assertIn("no component 'c70'", message)

    def test_all_leave_the_master_at_each_signal(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                node = self.start([f"c{i}" for i in range(10)])
                self.network.node_api(NODE)
                tcpros.until(lambda: len(self.registrations()) > 70, "all registrations")
                node.process.send_signal(number)
                self.assertEqual(self.exits(node, 5.0), 0)
                self.assertEqual(self.registrations(), [])


class Messages(Attack):
    def bundle(self, names, numbers, body=b""):
        return tcpros.text(struct.pack("<III", 0, 1000, 0) + tcpros.text(FRAME) + struct.pack("<I", names) +
                           (struct.pack("<I", numbers) if not names else b"") + body)

    def settled(self, report, count):
        self.assertEqual(self.counts(report, "bundled topics", "dropped, undecodable", count), count)

    def test_what_a_message_claims_takes_no_memory(self):
        node = self.start()
        report = self.network.subscribe(NODE, "/diagnostics")
        writer = self.network.publish("/displacements", "rubber_suspension/DisplacementArray")
        self.settled(report, 0)
        before = node.memory("VmHWM")
        for claim in (1 << 28, 1 << 31, (1 << 32) - 1):
            writer.sendall(self.bundle(0, claim))
            writer.sendall(self.bundle(claim, 0))
        self.settled(report, 6)
        self.assertLess(node.memory("VmHWM") - before, 8 * MEBIBYTE)

    def test_large_messages_leave_no_memory_behind(self):
        if SANITIZED:
            self.skipTest("the address sanitizer keeps memory that was freed, and locks none")
        node = self.start()
        report = self.network.subscribe(NODE, "/diagnostics")
        writer = self.network.publish("/displacements", "rubber_suspension/DisplacementArray")
        self.settled(report, 0)
        before = node.memory()
        large = self.bundle(0, MEBIBYTE // 8, bytes(MEBIBYTE))
        for _ in range(100):
            writer.sendall(large)
        self.settled(report, 100)
        # At most two messages are in memory: one that is being read, and one that waits for processing.
        tcpros.until(lambda: node.memory() - before < 4 * MEBIBYTE, "memory given back", 10.0)

    def test_locked_memory_is_what_was_touched(self):
        if SANITIZED:
            self.skipTest("the address sanitizer keeps memory that was freed, and locks none")
        node = self.start(lock_memory="true")
        self.network.node_api(NODE)
        tcpros.until(lambda: node.memory("VmLck") > 0 or "cannot be locked" in node.output(), "locked memory")
        if "cannot be locked" in node.output():
            self.skipTest("memory cannot be locked here")
        report = self.network.subscribe(NODE, "/diagnostics")
        writer = self.network.publish("/left/displacement", "rubber_suspension/Displacement")
        self.counts(report, "left", "accepted", 0)
        before = node.memory()
        writer.sendall(struct.pack("<I", 999999999))
        for _ in range(2):
            tcpros.next_message(report)
        self.assertLess(node.memory() - before, 8 * MEBIBYTE)

    def test_what_cannot_be_decoded_is_counted_and_said_seldom(self):
        node = self.start()
        report = self.network.subscribe(NODE, "/diagnostics")
        writer = self.network.publish("/left/displacement", "rubber_suspension/Displacement")
        for i in range(5000):
            writer.sendall(tcpros.text(b"\0" * (i % 20)) if i % 20 else tcpros.text(sample(i)[4:-1]))
        self.assertEqual(self.counts(report, "left", "dropped, undecodable", 5000), 5000)
        # The node publishes a report before it logs the faults in it.
        tcpros.until(lambda: "cannot be decoded" in node.output(), "the fault in the log")
        lines = [line for line in node.output().splitlines() if "WARN" in line or "ERROR" in line]
        self.assertIn("cannot be decoded", lines[0])
        self.assertLess(len(lines), 8)

    def test_measured_forces_beyond_measure_are_said(self):
        if SANITIZED:
            self.skipTest("the diagnosis that the node loads is without sanitizers")
        self.start(diagnose="true")
        report = self.network.subscribe(NODE, "/diagnostics")
        measured = self.network.publish("/left/measured_force", "rubber_suspension/MeasuredForce")
        for i in range(100):
            measured.sendall(sample(i, 2e30))
        dropped = lambda: "forces were dropped" in self.values(report, "diagnosis of left").get("sentence", "")
        tcpros.until(dropped, "a sentence")
        values = self.values(report, "diagnosis of left")
        self.assertIn("1e+30 N at most", values["sentence"])
        self.assertEqual([key for key, value in values.items() if "nan" in value.lower()], [])


class Files(Attack):
    def refused(self, config, *words):
        node = self.start(config=config)
        self.assertEqual(node.process.wait(20.0), 1)
        self.assertEqual(len(node.output().splitlines()), 1, node.output())
        for word in words:
            self.assertIn(word, node.output())

    def test_aliases_that_multiply(self):
        path = os.path.join(self.folder, "aliases.yaml")
        numbers = ", ".join(str(i) for i in range(10000))
        with open(path, "w") as file:
            file.write(f"components:\n  c0: &c\n    model: elements\n    elements:\n"
                       f"      - &e {{type: spring_table, displacement: &n [{numbers}], force: *n}}\n" +
                       "      - *e\n" * 999 + "".join(f"  c{i}: *c\n" for i in range(1, 256)))
        self.refused(path, "aliases.yaml:", "each alias")

    def test_component_files_that_are_none(self):
        pipe = os.path.join(self.folder, "pipe")
        os.mkfifo(pipe)
        self.refused("/dev/zero", "/dev/zero", "a device", "regular file")
        self.refused(pipe, pipe, "a pipe")
        self.refused(self.folder, "a folder")

    def test_a_diagnosis_that_is_not_installed(self):
        """The node's library is copied to a place from which it does not find the library of the diagnosis."""
        if SANITIZED:
            self.skipTest("its program has no library of the node")
        installed = os.path.dirname(PROGRAMS)
        for name in os.listdir(installed):
            if name.startswith("librubber_suspension") and not name.endswith(("_live.so", "_ros.so")):
                os.symlink(os.path.join(installed, name), os.path.join(self.folder, name))
        with open(os.path.join(installed, "librubber_suspension_ros.so"), "rb") as file:
            library = file.read().replace(installed.encode(), b"/" + b"x" * (len(installed) - 1))
        with open(os.path.join(self.folder, "librubber_suspension_ros.so"), "wb") as file:
            file.write(library)
        folders = [folder for folder in os.environ.get("LD_LIBRARY_PATH", "").split(":") if folder and
                   not os.path.exists(os.path.join(folder, "librubber_suspension_live.so"))]
        node = self.network.start([SIMULATE, f"_config_file:={self.components(['left'])}", "_diagnose:=true"],
                                  "simulate", LD_LIBRARY_PATH=":".join([self.folder, *folders]))
        self.assertEqual(node.process.wait(20.0), 1)
        self.assertEqual(len(node.output().splitlines()), 1, node.output())
        for word in ("~diagnose", "librubber_suspension_live.so", "No such file", "accepted:"):
            self.assertIn(word, node.output())
        self.assertEqual(self.registrations(), [])

    def test_names_that_are_taken(self):
        for name in ("simulate", "displacements", "forces", "reset", "save_state", "set_enabled", "diagnostics"):
            self.refused(self.components(["left", name]), name, "accepted: any name except", "load_state")

    def test_states_that_are_none(self):
        state = os.path.join(self.folder, "state.json")
        node = self.start(state_file=state)
        save, load = NODE + "/save_state", NODE + "/load_state"
        self.assertTrue(tcpros.trigger(self.network.call(save))[0])
        with open(state) as file:
            good = file.read()
        texts = {"[" * 2000000: "nested", good.replace('"stamp_ns": 0', '"stamp_ns": 1e30'): "stamp_ns",
                 good.replace('"stamp_ns": 0', f'"stamp_ns": {1 << 64}'): "stamp_ns",
                 good.replace('"stamp_ns": 0', '"stamp_ns": 1.5'): "stamp_ns", good.replace("right", "left"): "twice"}
        for text, word in texts.items():
            with open(state, "w") as file:
                file.write(text)
            done, message = tcpros.trigger(self.network.call(load))
            self.assertFalse(done)
            self.assertIn(word, message)
        os.remove(state)
        os.mkfifo(state)
        for service in (save, load):
            done, message = tcpros.trigger(self.network.call(service))
            self.assertFalse(done)
            self.assertIn("a pipe", message)
        os.remove(state)
        target = os.path.join(self.folder, "target")
        with open(target, "w") as file:
            file.write(good)
        os.symlink(target, state)
        for service in (save, load):
            done, message = tcpros.trigger(self.network.call(service))
            self.assertFalse(done)
            self.assertIn("symbolic link", message)
        os.remove(state)
        self.assertTrue(tcpros.trigger(self.network.call(save))[0])
        self.assertIsNone(node.process.poll())
        self.assertEqual(node.end(), 0)

    def test_a_state_of_a_device_stops_the_start(self):
        for file in ("/dev/zero", "/dev/full"):
            node = self.start(state_file=file, load_state="true")
            self.assertEqual(node.process.wait(20.0), 1)
            self.assertIn("a device", node.output())


class Players(Attack):
    """Tests of commands that play a log. The node that answers displacements with forces is a part of the test."""

    SAMPLES = 50

    def play(self, program, force_of, with_force, *options):
        """Run a command whose displacements the test answers, and return its exit status and output."""
        log = os.path.join(self.folder, "log.csv")
        with open(log, "w") as file:
            file.write("time_s,displacement_m" + (",force_N" if with_force else "") + "\n")
            for i in range(self.SAMPLES):
                z = 1e-3 * math.sin(0.3 * i)
                file.write(f"{0.01 * i:.2f},{z}" + (f",{3e6 * z}" if with_force else "") + "\n")
        name = "/" + program
        self.network.slave.register_function(
            lambda *_: [1, "", [[1, name, "o", "TCPROS", "/left/force", 1]]], "getBusInfo")
        player = self.network.start([os.path.join(PROGRAMS, program), "--component", "left", "--log", log,
                                     "--connect-timeout", "30", *options], program)
        forces = self.network.publish("/left/force", "rubber_suspension/Force")
        displacements = self.network.subscribe(name, "/left/displacement")
        try:
            for i in range(self.SAMPLES):
                data = tcpros.next_message(displacements)
                z = struct.unpack("<d", data[-8:])[0]
                forces.sendall(tcpros.text(data + struct.pack("<4d", force_of(i, z), 0.0, 0.0, 0.0)))
        except (OSError, tcpros.WireError):
            pass  # the command ends when it has detected the fault
        return player.process.wait(tcpros.PATIENCE), player.output()

    def test_another_node_need_not_listen_to_measured_forces(self):
        for program, options in (("play_log", ()), ("check_force", ("--tolerance", "0.001"))):
            for with_force in ((True, False) if program == "play_log" else (True,)):
                with self.subTest(program=program, with_force=with_force):
                    status, words = self.play(program, lambda i, z: 3e6 * z, with_force, *options)
                    self.assertEqual(status, 0, words)
                self.doCleanups()
                self.setUp()

    def test_a_force_that_is_no_number_fails(self):
        for value in (math.nan, math.inf):
            output = os.path.join(self.folder, "forces.csv")
            status, words = self.play("play_log", lambda i, z, value=value: value if i == 20 else z, True, "--output", output)
            self.assertEqual(status, 1, words)
            self.assertIn("/left/force: the answer at 0.200000000 s is not finite", words)
            self.assertFalse(os.path.exists(output))
            self.doCleanups()
            self.setUp()


class Limits(Attack):
    """Tests of limits of a process: open files and memory."""

    def limited(self, soft, hard, names):
        return self.start(names, before=["bash", "-c", f"ulimit -Sn {soft} && ulimit -Hn {hard} && exec \"$@\"", "bash"])

    def test_too_few_open_files_are_said_at_the_start(self):
        names = [f"c{i}" for i in range(100)]
        for most in (20, 40, 200):
            node = self.limited(most, most, names)
            self.assertEqual(node.process.wait(20.0), 1)
            needed, of = (r"2\d\d", "100 components") if most > 20 else (r"\d\d", "component")
            self.assertRegex(node.output(), rf"{needed} open files are needed.*{of} .*ulimit -n {needed}.*limit is {most}\n")
            self.assertEqual(len(node.output().splitlines()), 1, node.output())
            self.assertEqual(self.registrations(), [])
        node = self.limited(40, 400, names)  # the node can raise the soft limit itself
        self.assertTrue(tcpros.trigger(self.network.call(NODE + "/reset"))[0])
        flood = Flood(self.network, names)
        flood.send(sample(0))
        tcpros.until(lambda: all(flood.forces(i) == 1 for i in range(100)), "a force each")
        self.assertEqual(node.end(), 0)

    def test_a_live_diagnosis_takes_memory_as_samples_come(self):
        if SANITIZED:
            self.skipTest("the diagnosis that the node loads is without sanitizers")
        node = self.start([f"c{i}" for i in range(100)], diagnose="true")
        self.network.call(NODE + "/reset")
        self.assertLess(node.memory("VmHWM"), 100 * MEBIBYTE)
        self.assertEqual(node.end(), 0)


class Loggers(Attack):
    def test_get_loggers_is_answered_and_the_node_goes_on(self):
        node = self.start()
        self.network.call(NODE + "/reset")  # the answer shows that the node has started
        for _ in range(3):
            done, data = self.network.call(NODE + "/get_loggers")
            self.assertTrue(done)
            reader = tcpros.Reader(data)
            levels = {reader.text(): reader.text() for _ in range(reader.number("I"))}
            self.assertEqual(levels["ros.rubber_suspension"], "info")
            self.assertTrue(tcpros.trigger(self.network.call(NODE + "/reset"))[0])  # writes a line to the log
        request = tcpros.text("ros.rubber_suspension") + tcpros.text("warn")
        done, _ = self.network.call(NODE + "/set_logger_level", request)
        self.assertTrue(done)
        reader = tcpros.Reader(self.network.call(NODE + "/get_loggers")[1])
        levels = {reader.text(): reader.text() for _ in range(reader.number("I"))}
        self.assertEqual(levels["ros.rubber_suspension"], "warn")
        self.assertEqual(node.end(), 0)


class Threads(Attack):
    def test_each_serving_thread_is_watched(self):
        self.start(threads=2)
        reports = self.network.subscribe(NODE, "/diagnostics")
        names = []
        while len(names) < 2:  # the first reports contain a single row each
            report = tcpros.diagnostics(tcpros.next_message(reports))
            names = [name for name in report if re.match(r"thread serving \d", name)]
        self.assertEqual(names, ["thread serving 1", "thread serving 2"])
        for name in names:
            self.assertEqual(report[name][0], 0)
            self.assertLess(float(report[name][2]["last round [s ago]"]), 2.0)


if __name__ == "__main__":
    PROGRAMS = os.path.abspath(sys.argv[1])
    SIMULATE = os.path.join(PROGRAMS, "simulate")
    if len(sys.argv) > 2 and sys.argv[2]:
        SIMULATE, SANITIZED = os.path.abspath(sys.argv[2]), True
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2,
                  warnings="ignore")  # when a test ends, its processes are ended with open connections
