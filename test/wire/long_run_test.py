#!/usr/bin/python3
"""Runs a node of ten components with a live diagnosis for a long time. Samples come at a fixed rate, a publisher
restarts every minute, and the master is killed twice. Each sample must be accepted or counted as lost, each force must
arrive or be counted, and the memory must not grow.

    long_run_test.py PROGRAMS [SECONDS [RATE]]    # default: 40 s and 100 samples/s of each component
"""

import collections
import math
import os
import select
import struct
import sys
import tempfile
import threading
import time

import drive
import tcpros

NODE = drive.NODE
TICK = 0.02  # time between two batches of samples [s]
GROWTH = 1.05  # largest ratio of the memory at the end to the memory in the middle of the run
LONG = 1200.0  # duration above which the memory of the diagnosis settles in the first half of the run [s]


def displacement(t):
    return 2e-3 * math.sin(13.0 * t) + 4e-4 * math.sin(101.0 * t)


class Stream:
    """The samples of a component, and their forces, which are identified by stamps."""

    def __init__(self, network, name, rate):
        self.name = name
        self.topic = f"/{name}/displacement"
        self.step = round(drive.SECOND / rate)  # time between two stamps [ns]
        self.output = network.publish(self.topic, "rubber_suspension/Displacement")
        self.input = network.subscribe(NODE, f"/{name}/force")
        self.sent = self.forces = 0
        self.first = 0  # first sample of the current publisher, which has sequence number 0
        self.data = b""
        self.waiting = collections.deque()  # batches that were sent: number of samples up to the batch, and time

    def samples(self, count, stiffness=1.0):
        """Return the next samples, or measured forces for the next samples, which have the same format."""
        return b"".join(tcpros.sample(i, stiffness * displacement(i * self.step / drive.SECOND), step=self.step,
                                      sequence=i - self.first) for i in range(self.sent, self.sent + count))

    def take(self):
        """Read forces, and return the longest time between a sample and its force [s]."""
        self.data += self.input.recv(1 << 18)
        now = time.monotonic()
        count, longest = len(self.data) // tcpros.FORCE_SIZE, 0.0
        if count:
            seconds, nanoseconds = struct.unpack_from("<II", self.data, (count - 1) * tcpros.FORCE_SIZE + 8)
            newest = ((seconds - 1000) * drive.SECOND + nanoseconds) // self.step
            self.forces += count
            self.data = self.data[count * tcpros.FORCE_SIZE:]
            while self.waiting and self.waiting[0][0] <= newest + 1:
                longest = max(longest, now - self.waiting.popleft()[1])
        return longest


class LongRun:
    def __init__(self, programs, folder, duration=40.0, rate=100.0):
        self.duration, self.rate = duration, rate
        config = os.path.join(folder, "components.yaml")
        names = [f"c{i}" for i in range(10)]
        with open(config, "w") as file:
            file.write("components:\n" + "".join(f"  {name}:\n    model: elements\n    elements:\n      {drive.LAWS[0]}"
                                                 for name in names))
        self.network = tcpros.Network(folder)
        self.node = self.network.start([os.path.join(programs, "simulate"), f"_config_file:={config}", "_diagnose:=true"],
                                       "simulate")
        self.streams = [Stream(self.network, name, rate) for name in names]
        self.measured = self.network.publish("/c0/measured_force", "rubber_suspension/MeasuredForce")
        self.report = drive.Reports(self.network.subscribe(NODE, "/diagnostics"))
        self.latest = None
        self.lost = {}
        self.longest = 0.0
        self.restarts = 0
        self.failure = None
        self.memory = [math.inf] * 8  # least memory in each eighth of the run [bytes]; a diagnosis needs more

    def send(self, count):
        for stream in self.streams:
            output = stream.output  # another thread may replace it by None
            if output is None:
                continue
            if stream.name == "c0":
                self.measured.sendall(stream.samples(count, 3.3e6))
            output.sendall(stream.samples(count))
            stream.sent += count
            stream.waiting.append((stream.sent, time.monotonic()))

    def take(self, until):
        """Read until the given time. Always read what has arrived, so that a late driver reads as well."""
        inputs = [stream.input for stream in self.streams] + [self.report.input]
        left = 0.0
        while left >= 0.0:
            for ready in select.select(inputs, [], [], left)[0]:
                if ready is self.report.input:
                    self.latest = self.report.take() or self.latest
                else:
                    self.longest = max(self.longest, self.streams[inputs.index(ready)].take())
            left = until - time.monotonic()

    def restart_publisher(self, stream):
        """Replace the publisher when all its samples are answered."""
        writer, stream.output = stream.output, None
        time.sleep(1.0)  # a batch may be in transit
        tcpros.until(lambda: not self.uncounted(stream), f"what {stream.name} sent to be counted")
        writer.close()
        self.network.master.unregisterPublisher(tcpros.CALLER, stream.topic, self.network.slave_uri)
        api = self.network.node_api(NODE)
        tcpros.until(lambda: stream.topic not in [link[4] for link in api.getBusInfo(tcpros.CALLER)[2]], "it to leave")
        stream.first = stream.sent
        stream.output = self.network.publish(stream.topic, "rubber_suspension/Displacement")
        self.restarts += 1

    def restart_master(self):
        self.network.master_process.kill()
        time.sleep(min(10.0, self.duration / 20))
        self.network.master_process = self.network.start(["rosmaster", "--core", "-p", str(self.network.port)], "master")
        tcpros.until(self.network.master_answers, "the master")
        for stream in self.streams:
            self.network.master.registerPublisher(tcpros.CALLER, stream.topic, "rubber_suspension/Displacement",
                                                  self.network.slave_uri)
        self.network.node_api(NODE)  # waits until the node has registered again

    def disturb(self, begin):
        """Restart a publisher every minute (seven times in a short run), and the master in the middle of each half."""
        pause = min(60.0, self.duration / 8)
        moments = [(pause * i, False) for i in range(1, int(self.duration / pause))]
        moments += [(self.duration * share, True) for share in (0.27, 0.77)]
        try:
            for i, (moment, of_master) in enumerate(sorted(moments)):
                time.sleep(max(0.0, begin + moment - time.monotonic()))
                self.restart_master() if of_master else self.restart_publisher(self.streams[i % len(self.streams)])
        except (OSError, tcpros.WireError) as error:
            self.failure = f"wire: {error}"

    def uncounted(self, stream):
        """Return the counters of a component if all its samples and forces have arrived or are counted."""
        values = tcpros.diagnostics(self.latest)[stream.name][2]
        accepted, lost, missed = (int(values[key]) for key in ("accepted", "lost before arrival", "forces not delivered"))
        self.lost[stream.name] = lost + missed
        counted = accepted + lost == stream.sent and stream.forces + missed == accepted
        return "" if counted else f"{stream.name}: {values}, {stream.sent} sent, {stream.forces} forces"

    def run(self):
        begin = time.monotonic()
        disturber = threading.Thread(target=self.disturb, args=(begin,), daemon=True)
        disturber.start()
        count = max(1, round(self.rate * TICK))
        ticks = int(self.duration * self.rate / count)
        for tick in range(ticks):
            self.send(count)
            self.take(begin + (tick + 1) * count / self.rate)
            self.memory[8 * tick // ticks] = min(self.memory[8 * tick // ticks], self.node.memory())
        disturber.join()
        drive.require(self.failure is None, self.failure)
        end = time.monotonic() + 15.0
        while uncounted := "".join(map(self.uncounted, self.streams)):
            drive.require(time.monotonic() < end, f"counter {uncounted}")
            self.take(time.monotonic() + 1.0)
        print(f"{sum(stream.sent for stream in self.streams)} samples in {self.duration:.0f} s, {sum(self.lost.values())} "
              f"counted as lost, each other one with a force; {self.restarts} publishers and 2 masters restarted; longest "
              f"answer {self.longest:.3f} s; memory {', '.join(f'{size / 2**20:.1f}' for size in self.memory)} MiB")
        growth = self.memory[-1] / self.memory[4]
        drive.require(self.duration < LONG or growth < GROWTH, f"memory: {growth:.3f} times that of the middle of the run")
        drive.require(self.node.end() == 0, "end: exit status is not 0")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        long_run = LongRun(sys.argv[1], folder, *map(float, sys.argv[2:]))
        try:
            long_run.run()
        finally:
            long_run.network.close()
