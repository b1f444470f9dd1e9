#!/usr/bin/python3
"""Checks a running node from outside: exactly one force per accepted sample, right to the last bit.

Sends samples with mixed faults over its own connections, while it calls services in a loop. Compares every force with
that of the command `replay`, every counter of /diagnostics with its own, and checks that the memory does not grow with
the samples. If the node fails, prints a line and ends with exit status 1; the first word is the kind of failure: force,
counter, bundle, state, memory, end or wire.

    drive.py --programs FOLDER [--node PROGRAM] [--samples N] [--components N] [--window N]
"""

import argparse
import collections
import csv
import json
import math
import os
import random
import select
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import numpy

import tcpros

SECOND = 1_000_000_000
MILLISECOND = 1_000_000
MAX_GAP = SECOND // 2
FRAME = b"wire"
NODE = "/simulate"
LAWS = [
    "- {type: spring, stiffness: 3.0e6}\n      - {type: maxwell, stiffness: 1.2e6, break_frequency: 2.0}\n"
    "      - {type: friction, maximum_force: 6000.0, displacement: 0.0022}\n",
    "- {type: spring, stiffness: 2.0e6}\n      - {type: friction, maximum_force: 900.0, displacement: 0.0004}\n",
    "- {type: spring, stiffness: 1.0e6}\n      - {type: maxwell, stiffness: 2.2e6, break_frequency: 0.3}\n"
    "      - {type: dashpot, damping: 4.0e3}\n",
]
FORCE = numpy.dtype([("size", "<u4"), ("seq", "<u4"), ("sec", "<u4"), ("nsec", "<u4"), ("frame_size", "<u4"),
                     ("frame", f"S{len(FRAME)}"), ("displacement", "<f8"), ("force", "<f8"), ("elastic", "<f8"),
                     ("viscous", "<f8"), ("friction", "<f8")])
SAMPLE = numpy.dtype([("size", "<u4"), ("seq", "<u4"), ("sec", "<u4"), ("nsec", "<u4"), ("frame_size", "<u4"),
                      ("frame", f"S{len(FRAME)}"), ("displacement", "<f8")])


class Failure(Exception):
    """A failure of the node. The first word of its message is the kind."""


def require(condition, message):
    if not condition:
        raise Failure(message)


def header(sequence, stamp, frame=FRAME):
    return struct.pack("<III", sequence & 0xFFFFFFFF, stamp // SECOND, stamp % SECOND) + tcpros.text(frame)


class Stream:
    """The samples of a component, some with faults, and the expected counters and forces."""

    def __init__(self, name, seed):
        self.name = name
        self.random = random.Random(seed)
        self.stamp = 1000 * SECOND
        self.sequence = 0
        self.phase = self.random.uniform(0.0, 6.0)
        self.counts = collections.Counter()
        self.segments = [[]]  # accepted (stamps, displacements); each restart begins a segment
        self.expected = 0

    def wave(self, stamps):
        t = (stamps % (1000 * SECOND)) * 1e-9
        return 2e-3 * numpy.sin(13.0 * t + self.phase) + 4e-4 * numpy.sin(101.0 * t)

    def run(self, count, step=MILLISECOND):
        """Return samples at even steps, which must all be accepted."""
        stamps = self.stamp + step * numpy.arange(1, count + 1)
        displacements = self.wave(stamps)
        rows = numpy.zeros(count, SAMPLE)
        rows["size"] = SAMPLE.itemsize - 4
        rows["seq"] = (self.sequence + numpy.arange(1, count + 1)) & 0xFFFFFFFF
        rows["sec"] = stamps // SECOND
        rows["nsec"] = stamps % SECOND
        rows["frame_size"] = len(FRAME)
        rows["frame"] = FRAME
        rows["displacement"] = displacements
        self.sequence += count
        self.stamp = int(stamps[-1])
        self.segments[-1].append((stamps, displacements))
        self.expected += count
        self.counts["accepted"] += count
        return rows.tobytes()

    def one(self, stamp, displacement):
        self.sequence += 1
        return tcpros.text(header(self.sequence, stamp) + struct.pack("<d", displacement))

    def fault(self, kind):
        """Return a sample with a fault, and update the expected counters."""
        if kind in ("nan", "inf", "-inf"):
            self.counts["dropped, not finite"] += 1
            return self.one(self.stamp + MILLISECOND, float(kind))
        if kind == "repeat":
            self.counts["dropped, repeated stamp"] += 1
            return self.one(self.stamp, 0.5)
        if kind in ("back by a nanosecond", "back by a second"):
            self.counts["dropped, stepped back"] += 1
            return self.one(self.stamp - (1 if kind == "back by a nanosecond" else SECOND), 0.5)
        if kind == "restart":
            self.counts["restarts"] += 1
            self.stamp -= SECOND + 1 + self.random.randrange(400 * SECOND)
            self.stamp = max(self.stamp, 2)
            self.segments.append([])
            return self.run(3)
        if kind == "time gap":
            self.counts["time gaps bridged"] += 1
            self.stamp += MAX_GAP
            return self.run(1) + self.run(2)
        if kind == "longest time gap that is none":
            return self.run(1, MAX_GAP)
        if kind == "lost":
            lost = self.random.randrange(1, 1000)
            self.sequence += lost
            self.counts["lost before arrival"] += lost
            return self.run(1)
        if kind == "sender counts anew":
            self.sequence = 0
            return self.run(1)
        if kind == "a nanosecond":
            return self.run(2, 1)
        if kind in ("subnormal", "minus zero"):
            self.stamp += MILLISECOND
            value = 5e-324 if kind == "subnormal" else -0.0
            self.segments[-1].append((numpy.array([self.stamp]), numpy.array([value])))
            self.expected += 1
            self.counts["accepted"] += 1
            return self.one(self.stamp, value)
        self.counts["dropped, undecodable"] += 1
        whole = header(self.sequence + 1, self.stamp + MILLISECOND) + struct.pack("<d", 0.5)
        broken = {
            "short by a byte": whole[:-1],
            "long by a byte": whole + b"\0",
            "four bytes": whole[:4],
            "frame beyond the end": whole[:12] + struct.pack("<I", 0xFFFFFFF0) + whole[16:],
            "frame without end": header(self.sequence + 1, self.stamp, b"x" * 5000) + struct.pack("<d", 0.5),
        }
        return tcpros.text(broken[kind])


RARE = ["restart"]  # each restart needs another log for replay
FAULTS = ["nan", "inf", "-inf", "repeat", "back by a nanosecond", "back by a second", "time gap",
          "longest time gap that is none", "lost", "sender counts anew", "a nanosecond", "subnormal", "minus zero",
          "short by a byte", "long by a byte", "four bytes", "frame beyond the end", "frame without end"]


class Link:
    """The two connections of a component. Sends at most `window` samples ahead, so that no queue overflows."""

    def __init__(self, network, stream, window, samples):
        self.stream = stream
        self.window = window
        self.left = samples
        self.output = network.publish(f"/{stream.name}/displacement", "rubber_suspension/Displacement")
        self.input = network.subscribe(NODE, f"/{stream.name}/force")
        self.output.setblocking(False)
        self.input.setblocking(False)
        self.pending = b""
        self.partial = b""
        self.rows = []
        self.answered = 0
        self.restarts = 3

    def produce(self):
        """Prepare the next samples if the window permits."""
        stream = self.stream
        if self.pending or self.left <= 0 or stream.expected - self.answered >= self.window:
            return
        pieces = []
        while self.left > 0 and stream.expected - self.answered < self.window:
            before = stream.expected
            pieces.append(stream.run(min(stream.random.randrange(2, 400), max(self.left, 2))))
            kind = stream.random.choice(FAULTS)
            if self.restarts and stream.random.random() < 0.02:
                self.restarts -= 1
                kind = RARE[0]
            pieces.append(stream.fault(kind))
            pieces.append(stream.run(2))
            self.left -= stream.expected - before
        self.pending = b"".join(pieces)

    def send(self):
        try:
            self.pending = self.pending[self.output.send(self.pending[:65536]):]
        except BlockingIOError:
            pass

    def take(self):
        data = self.input.recv(1 << 20)
        require(data, f"wire {self.stream.name}: the node closed the connection")
        data = self.partial + data
        whole = len(data) // FORCE.itemsize
        rows = numpy.frombuffer(data, FORCE, whole)
        self.partial = data[whole * FORCE.itemsize:]
        self.rows.append(rows)
        self.answered += whole
        require(self.answered <= self.stream.expected,
                f"force {self.stream.name}: {self.answered} forces for {self.stream.expected} accepted samples")

    def done(self):
        return self.left <= 0 and not self.pending and self.answered >= self.stream.expected


class Bundles:
    """Sends one message per step for all bundled components, with malformed messages in between."""

    MALFORMED = ["unknown name", "lists differ", "numbers beyond the end", "names beyond the end", "long by a byte"]

    def __init__(self, network, names, messages, seed):
        self.names = names
        self.random = random.Random(seed)
        self.left = messages
        self.output = network.publish("/displacements", "rubber_suspension/DisplacementArray")
        self.input = network.subscribe(NODE, "/forces")
        self.output.setblocking(False)
        self.input.setblocking(False)
        self.pending = b""
        self.partial = b""
        self.streams = {name: Stream(name, seed + i) for i, name in enumerate(names)}
        self.sent = collections.deque()
        self.stamp = 1000 * SECOND
        self.sequence = 0
        self.answered = 0
        self.malformed = 0
        self.undecodable = 0
        self.forces = {name: [] for name in names}

    def encode(self, names, displacements):
        self.sequence += 1
        return (header(self.sequence, self.stamp) + struct.pack("<I", len(names)) + b"".join(map(tcpros.text, names)) +
                struct.pack(f"<I{len(displacements)}d", len(displacements), *displacements))

    def broken(self, kind):
        names, values = list(self.names), [0.5] * len(self.names)
        if kind == "unknown name":
            names[-1] = "nobody"
        elif kind == "lists differ":
            values.pop()
        data = self.encode(names, values)
        start = data.index(FRAME) + len(FRAME)
        if kind == "names beyond the end":
            data = data[:start] + struct.pack("<I", 1 << 28) + data[start + 4:]
        elif kind == "numbers beyond the end":
            data = data[:start] + struct.pack("<II", 0, 1 << 28)
        elif kind == "long by a byte":
            data += b"\0"
        if kind in ("unknown name", "lists differ"):
            self.malformed += 1
        else:
            self.undecodable += 1
            self.sequence -= 1  # the node cannot read the sequence number of such a message
        return tcpros.text(data)

    def produce(self):
        if self.pending or self.left <= 0 or len(self.sent) >= 200:
            return
        self.left -= 1
        self.stamp += MILLISECOND
        values = [float(self.streams[name].wave(numpy.array([self.stamp]))[0]) for name in self.names]
        bad = self.random.randrange(len(self.names)) if self.random.random() < 0.05 else None
        accepted = []
        for i, name in enumerate(self.names):
            stream = self.streams[name]
            if i == bad:
                values[i] = math.nan
                stream.counts["dropped, not finite"] += 1
                continue
            stream.segments[-1].append((numpy.array([self.stamp]), numpy.array([values[i]])))
            stream.counts["accepted"] += 1
            accepted.append(name)
        self.sent.append((self.stamp, accepted))
        self.pending = tcpros.text(self.encode(self.names, values))
        if self.random.random() < 0.05:
            self.pending += self.broken(self.random.choice(self.MALFORMED))

    send = Link.send

    def take(self):
        data = self.input.recv(1 << 20)
        require(data, "wire forces: the node closed the connection")
        self.partial += data
        while len(self.partial) >= 4:
            size = struct.unpack_from("<I", self.partial)[0]
            if len(self.partial) < 4 + size:
                break
            self.check(self.partial[4:4 + size])
            self.partial = self.partial[4 + size:]

    def check(self, data):
        reader = tcpros.Reader(data)
        reader.number("I")
        stamp = reader.number("I") * SECOND + reader.number("I")
        reader.text()
        names = [reader.text() for _ in range(reader.number("I"))]
        lists = [[reader.number("d") for _ in range(reader.number("I"))] for _ in range(5)]
        require(self.sent, "bundle: an answer to nothing")
        expected_stamp, expected = self.sent.popleft()
        require((stamp, names) == (expected_stamp, expected),
                f"bundle: answered {len(names)} components at {stamp}, {len(expected)} at {expected_stamp} expected")
        for name, force in zip(names, lists[1]):
            self.forces[name].append(force)
        self.answered += 1

    def done(self):
        return self.left <= 0 and not self.pending and not self.sent


def reference(programs, folder, config, stream):
    """Return the forces from `replay` of the accepted samples, segment by segment."""
    forces = []
    for segment in stream.segments:
        if not segment:
            continue
        stamps = numpy.concatenate([stamps for stamps, _ in segment])
        displacements = numpy.concatenate([displacements for _, displacements in segment])
        log = os.path.join(folder, "accepted.csv")
        output = os.path.join(folder, "forces.csv")
        with open(log, "w") as file:
            file.write("time_s,displacement_m\n")
            file.writelines(f"{stamp // SECOND}.{stamp % SECOND:09d},{displacement!r}\n"
                            for stamp, displacement in zip(stamps.tolist(), displacements.tolist()))
        command = [os.path.join(programs, "replay"), "--config", config, "--component", stream.name, "--log", log,
                   "--output", output]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        require(done.returncode == 0, f"wire replay: {done.stderr.strip()}")
        with open(output, newline="") as file:
            rows = csv.reader(file)
            column = next(rows).index("force_N")
            forces.append(numpy.array([float(row[column]) for row in rows]))
        os.remove(output)
    return numpy.concatenate(forces)


def compare(name, stamps, forces, expected):
    require(len(forces) == len(expected), f"force {name}: {len(forces)} forces for {len(expected)} accepted samples")
    wrong = numpy.flatnonzero(forces.view("<u8") != expected.view("<u8"))
    if wrong.size:
        i = wrong[0]
        raise Failure(f"force {name}: {wrong.size} of {len(forces)} differ, the first at stamp {stamps[i]}: "
                      f"{forces[i]!r} N, {expected[i]!r} N expected")


def check_link(link, programs, folder, config):
    stream = link.stream
    rows = numpy.concatenate(link.rows)
    stamps = numpy.concatenate([s for segment in stream.segments for s, _ in segment])
    displacements = numpy.concatenate([d for segment in stream.segments for _, d in segment])
    answered = rows["sec"].astype(numpy.int64) * SECOND + rows["nsec"]
    require(len(rows) == len(stamps), f"force {stream.name}: {len(rows)} forces for {len(stamps)} accepted samples")
    require((answered == stamps).all(), f"force {stream.name}: a stamp that was not asked for, or out of order")
    require((numpy.diff(rows["seq"].astype(numpy.int64)) == 1).all(),
            f"force {stream.name}: the sequence numbers of the forces leave some out")
    require((rows["displacement"].view("<u8") == displacements.view("<u8")).all(),
            f"force {stream.name}: a displacement differs from the one sent")
    compare(stream.name, stamps, numpy.ascontiguousarray(rows["force"]), reference(programs, folder, config, stream))


class Reports:
    """The /diagnostics of the node. They are read during the run as well, because unread reports fill the socket."""

    def __init__(self, sock):
        self.input = sock
        self.data = b""

    def take(self):
        """Read all data that have arrived, and return the last complete report."""
        latest = None
        piece = self.input.recv(1 << 18)
        if not piece:
            raise tcpros.WireError("the connection of the diagnostics was closed")
        self.data += piece
        while len(self.data) >= 4 and len(self.data) >= 4 + struct.unpack_from("<I", self.data)[0]:
            end = 4 + struct.unpack_from("<I", self.data)[0]
            latest, self.data = self.data[4:end], self.data[end:]
        return latest

    def next(self):
        latest = None
        while latest is None:
            latest = self.take()
        return tcpros.diagnostics(latest)


def wait_for_counts(diagnostics, expected):
    """Wait until all counters equal the expected ones, because diagnostics are published once per second."""
    reports = 0
    while True:
        wrong = []
        report = diagnostics.next()
        for name, counts in expected.items():
            if name not in report:
                wrong.append(f"{name} is missing")
                continue
            values = report[name][2]
            wrong += [f"{name}: {key} {values.get(key)}, {count} expected" for key, count in counts.items()
                      if values.get(key) != str(count)]
        if not wrong:
            return
        reports += 1
        require(reports < 15, "counter " + "; ".join(wrong[:5]))


COUNTERS = ["accepted", "dropped, not finite", "dropped, repeated stamp", "dropped, stepped back",
            "dropped, undecodable", "dropped, disabled", "lost before arrival", "restarts", "time gaps bridged",
            "forces not delivered"]


class Drive:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.config = os.path.join(folder, "components.yaml")
        self.state = os.path.join(folder, "state.json")
        self.singles = [f"single_{i}" for i in range(options.components)]
        self.bundled = [f"bundled_{i}" for i in range(12)]
        with open(self.config, "w") as file:
            file.write("components:\n")
            for i, name in enumerate(self.singles + self.bundled):
                file.write(f"  {name}:\n    model: elements\n    elements:\n      {LAWS[i % len(LAWS)]}")
        self.network = tcpros.Network(folder)
        self.node = self.network.start(
            [options.node or os.path.join(options.programs, "simulate"), f"_config_file:={self.config}",
             f"_state_file:={self.state}", f"_threads:={options.threads}"], "simulate", MUTANT=options.mutant)

    def serve(self):
        """Call services meanwhile: a saved state must be of one instant, enabling again must have no effect."""
        done, message = tcpros.trigger(self.network.call(NODE + "/save_state"))
        require(done, f"state: save_state was refused: {message}")
        with open(self.state) as file:
            states = {state["component"]: state for state in json.load(file)["states"]}
        stamps = {states[name]["stamp_ns"] for name in self.bundled}
        # The stamp of a component does not change if its last sample was not finite.
        require(len(stamps) <= 2, f"state: one save holds bundles of {len(stamps)} instants")
        done, _ = tcpros.trigger(self.network.call(NODE + "/set_enabled", b"\1"))
        require(done, "state: set_enabled was refused")
        done, _ = self.network.call(NODE + "/get_loggers")
        require(done, "state: get_loggers was refused")

    def stream(self, links, report):
        """Send until all is answered; return pairs of answered samples and memory after each eighth of the samples."""
        total = sum(link.left for link in links if isinstance(link, Link))
        memory = []
        rounds = 0
        moved = time.monotonic()
        while not all(link.done() for link in links):
            require(self.node.process.poll() is None,
                    f"end: the node ended with status {self.node.process.poll()}: {self.node.output()[-300:]}")
            for link in links:
                link.produce()
            reading, writing, _ = select.select([link.input for link in links] + [report.input],
                                                [link.output for link in links if link.pending], [], 20.0)
            if writing or any(link.input in reading for link in links):
                moved = time.monotonic()
            require(time.monotonic() - moved < 20.0, "force: " + ", ".join(
                f"{link.stream.name} {link.answered} forces for {link.stream.expected} accepted samples"
                for link in links if isinstance(link, Link) and not link.done()) + "; and none any more")
            if report.input in reading:
                report.take()
            for link in links:
                if link.output in writing:
                    link.send()
                if link.input in reading:
                    link.take()
            rounds += 1
            if rounds % self.options.service_rounds == 0:
                self.serve()
            answered = sum(link.answered for link in links if isinstance(link, Link))
            if answered > (len(memory) + 1) * total // 8:
                memory.append((answered, self.node.memory()))
        return memory

    def check(self):
        options = self.options
        share = options.samples // options.components
        links = [Link(self.network, Stream(name, options.seed + i), options.window, share)
                 for i, name in enumerate(self.singles)]
        bundles = Bundles(self.network, self.bundled, options.samples // 50, options.seed + 1000)
        report = Reports(self.network.subscribe(NODE, "/diagnostics"))
        memory = self.stream(links + [bundles], report)
        streams = [link.stream for link in links] + list(bundles.streams.values())
        expected = {stream.name: {key: stream.counts[key] for key in COUNTERS} for stream in streams}
        expected["bundled topics"] = {"answered": bundles.answered, "dropped, malformed": bundles.malformed,
                                      "dropped, undecodable": bundles.undecodable, "lost before arrival": 0,
                                      "forces not delivered": 0}
        wait_for_counts(report, expected)
        for link in links:
            check_link(link, options.programs, self.folder, self.config)
        for stream in bundles.streams.values():
            stamps = [s[0] for s, _ in stream.segments[0]]
            compare(stream.name, stamps, numpy.array(bundles.forces[stream.name]),
                    reference(options.programs, self.folder, self.config, stream))
        count = sum(link.answered for link in links)
        if not options.no_memory:
            # A queue that grows takes megabytes at once, in several parts of the run if other programs slow it down.
            # Memory per sample grows in every part. A leak of 16 bytes per sample would make all parts grow by at least
            # half of it, except for one part in which a queue may have been freed.
            parts = sorted((later - earlier) / (last - first) for (first, earlier), (last, later)
                           in zip(memory[1:], memory[2:]))
            growth = parts[1]
            require(growth < 8, f"memory: {growth:.1f} bytes more for each sample")
        status = self.node.end(signal.SIGTERM)
        require(status == 0, f"end: exit status {status} after SIGTERM: {self.node.output()[-300:]}")
        print(f"{count} forces of {len(links)} components and {bundles.answered} bundles, "
              f"{sum(sum(s.counts[k] for k in COUNTERS[1:]) for s in streams)} faults; memory {memory[-1][1] / 2**20:.1f} MiB, "
              f"{(memory[-1][1] - memory[1][1]) / 2**20:+.1f} MiB since a quarter")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--programs", required=True, help="folder of the programs simulate and replay")
    parser.add_argument("--node", help="another program in place of simulate")
    parser.add_argument("--mutant", default="", help="mutant of the program that is made to fail")
    parser.add_argument("--expect", default="", help="pass if the node fails, and in this way")
    parser.add_argument("--samples", type=int, default=200000)
    parser.add_argument("--components", type=int, default=4)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--window", type=int, default=2000, help="samples per component ahead of the answers")
    parser.add_argument("--service-rounds", type=int, default=50, help="call services once in so many rounds")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--no-memory", action="store_true", help="do not look at the memory (sanitizers)")
    options = parser.parse_args()
    folder = tempfile.mkdtemp(prefix="wire.")
    drive = None
    failure = ""
    try:
        drive = Drive(options, folder)
        drive.check()
    except (Failure, tcpros.WireError, OSError) as error:
        failure = str(error) if isinstance(error, Failure) else f"wire: {error}"
    finally:
        if drive:
            if failure and not options.expect:
                print(drive.node.output()[-2000:], file=sys.stderr)
            drive.network.close()
        shutil.rmtree(folder)
    if failure:
        print(failure, file=sys.stderr)
    if options.expect:
        sys.exit(0 if failure.split(":")[0].split(" ")[0] == options.expect else 1)
    sys.exit(1 if failure else 0)


if __name__ == "__main__":
    main()
