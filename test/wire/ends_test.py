#!/usr/bin/python3
"""Ends a node many times. It must exit with 0 within 5 s, without registrations left at the master. Each time, a new
master and node have 100, 150 or 256 components and a live diagnosis, and two other processes load the computer. SIGINT
or SIGTERM is sent at a random moment of the start, where it may end the process before main, and while samples are
sent. In half of the latter cases the master was killed before.

    ends_test.py PROGRAMS [ENDS]
"""

import itertools
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

import tcpros

NODE = "/simulate"
LIMIT = 5.0  # limit from the signal to the end [s]
PATIENCE = 15.0  # time for the master to process the last calls of the node [s]
STREAMS = 4  # number of components that receive samples


class Ends:
    def __init__(self, programs):
        self.simulate = os.path.join(programs, "simulate")
        self.names = []
        self.moments = random.Random(1)
        self.failures = []
        self.longest = 0.0

    def config(self, folder):
        path = os.path.join(folder, "components.yaml")
        with open(path, "w") as file:
            file.write("components:\n")
            for name in self.names:
                file.write(f"  {name}: {{model: elements, elements: [{{type: spring, stiffness: 3.0e6}}, "
                           "{type: friction, maximum_force: 6000.0, displacement: 0.0022}]}\n")
        return path

    def stream(self, writer, reader, over):
        """Send samples as fast as the node answers them, until the node has ended."""
        number = 0
        try:
            while not over.is_set():
                writer.sendall(b"".join(tcpros.sample(number + i) for i in range(50)))
                number += 50
                tcpros.receive(reader, 50 * tcpros.FORCE_SIZE)
        except (OSError, tcpros.WireError):
            pass

    @staticmethod
    def left(network):
        """Return the topics, services and parameters of the node that the master still knows."""
        state = network.master.getSystemState(tcpros.CALLER)[2]
        parameters = network.master.getParamNames(tcpros.CALLER)[2]
        return ([name for part in state for name, nodes in part if NODE in nodes] +
                [name for name in parameters if name.startswith(NODE + "/")])

    def serve(self, network, over, threads):
        """Send samples after the node has registered its last service."""
        last = f"/{self.names[-1]}/rollback"
        tcpros.until(lambda: network.master.lookupService(tcpros.CALLER, last)[0] == 1, "the node")
        for name in self.names[:STREAMS]:
            links = (network.publish(f"/{name}/displacement", "rubber_suspension/Displacement"),
                     network.subscribe(NODE, f"/{name}/force"))
            threads.append(threading.Thread(target=self.stream, args=(*links, over), daemon=True))
            threads[-1].start()
        time.sleep(0.3)

    def end(self, number, moment):
        """End a node once, and return a description of the failure or an empty text."""
        folder = tempfile.mkdtemp(prefix="ends.")
        network = tcpros.Network(folder)
        over = threading.Event()
        threads = []
        try:
            node = network.start([self.simulate, f"_config_file:={self.config(folder)}", "_diagnose:=true"], "simulate")
            if moment == "start":
                time.sleep(0.05 * 60.0 ** self.moments.random())  # 50 ms to 3 s
            else:
                self.serve(network, over, threads)
            if moment == "without a master":
                network.master_process.kill()
            begin = time.monotonic()
            status = node.end(number)
            took = time.monotonic() - begin
            self.longest = max(self.longest, took)
            left = [] if moment == "without a master" else self.left(network)
            while left and time.monotonic() < begin + took + PATIENCE:  # the master may still process calls
                time.sleep(0.1)
                left = self.left(network)
            if status not in ((0, -number) if moment == "start" else (0,)) or took > LIMIT or left:
                return (f"{len(self.names)} components: status {status} after {took:.1f} s, left {left}: "
                        f"{node.output().strip()}")
            return ""
        finally:
            over.set()
            network.close()
            for thread in threads:
                thread.join()
            shutil.rmtree(folder)

    def run(self, count):
        cases = itertools.cycle(itertools.product(("start", "with samples", "start", "without a master"),
                                                  (signal.SIGINT, signal.SIGTERM)))
        sizes = itertools.cycle((100, 150, 256))
        for i, (moment, number), size in zip(range(count), cases, sizes):
            self.names = [f"c{j}" for j in range(size)]
            wrong = self.end(number, moment)
            if wrong:
                self.failures.append(wrong)
                print(f"end {i + 1}, {signal.Signals(number).name}, {moment}: {wrong}", flush=True)
        print(f"{count - len(self.failures)} of {count} ends with status 0 and nothing left at the master, the longest "
              f"{self.longest:.1f} s")
        return 1 if self.failures else 0


def main(programs, count=8):
    busy = [subprocess.Popen(["nice", "-n", "5", sys.executable, "-c", "while True: pass"]) for _ in range(2)]
    try:
        return Ends(os.path.abspath(programs)).run(int(count))
    finally:
        for process in busy:
            process.kill()
            process.wait()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
