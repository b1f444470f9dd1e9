#!/usr/bin/python3
"""Ends a node many times while it is busy: main has to return with status 0 within 5 s, and with nothing left at the
master. Each end has a master and a node of its own with 100 components, samples that stream in and two processes that
take the machine's time; in turn SIGINT and SIGTERM, with the master and after it was killed. The process ends with
another status where main does not return by itself.

    ends_test.py PROGRAMS [ENDS [COMPONENTS]]
"""

import itertools
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

import tcpros

NODE = "/simulate"
LIMIT = 5.0  # [s] from the signal to the end
STREAMS = 4  # components that get samples


class Ends:
    def __init__(self, programs, components):
        self.simulate = os.path.join(programs, "simulate")
        self.names = [f"c{i}" for i in range(components)]
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
        """Samples as fast as the node answers them, until it has gone."""
        number = 0
        try:
            while not over.is_set():
                writer.sendall(b"".join(tcpros.sample(number + i) for i in range(50)))
                number += 50
                tcpros.receive(reader, 50 * tcpros.FORCE_SIZE)
        except (OSError, tcpros.WireError):
            pass

    def registrations(self, network):
        state = network.master.getSystemState(tcpros.CALLER)[2]
        return [name for part in state for name, nodes in part if NODE in nodes]

    def end(self, number, with_master):
        """One end; returns what was wrong with it, or nothing."""
        folder = tempfile.mkdtemp(prefix="ends.")
        network = tcpros.Network(folder)
        over = threading.Event()
        threads = []
        try:
            node = network.start([self.simulate, f"_config_file:={self.config(folder)}"], "simulate")
            # The service is the last thing that a node registers.
            tcpros.until(lambda: network.master.lookupService(tcpros.CALLER, NODE + "/reload")[0] == 1, "the node")
            for name in self.names[:STREAMS]:
                links = (network.publish(f"/{name}/displacement", "rubber_suspension/Displacement"),
                         network.subscribe(NODE, f"/{name}/force"))
                threads.append(threading.Thread(target=self.stream, args=(*links, over), daemon=True))
                threads[-1].start()
            time.sleep(0.3)
            if not with_master:
                network.master_process.kill()
            begin = time.monotonic()
            status = node.end(number)
            took = time.monotonic() - begin
            self.longest = max(self.longest, took)
            left = self.registrations(network) if with_master else []
            if status != 0 or took > LIMIT or left:
                return f"status {status} after {took:.1f} s, {len(left)} registrations left: {node.output().strip()}"
            return ""
        finally:
            over.set()
            network.close()
            for thread in threads:
                thread.join()
            shutil.rmtree(folder)

    def run(self, count):
        cases = itertools.cycle(itertools.product((signal.SIGINT, signal.SIGTERM), (True, False)))
        for i, (number, with_master) in zip(range(count), cases):
            wrong = self.end(number, with_master)
            if wrong:
                self.failures.append(wrong)
                print(f"end {i + 1}, {signal.Signals(number).name}, {'with' if with_master else 'without'} a master: "
                      f"{wrong}", flush=True)
        print(f"{count - len(self.failures)} of {count} ends with status 0 and nothing left at the master, the longest "
              f"{self.longest:.1f} s")
        return 1 if self.failures else 0


def main(programs, count=8, components=100):
    busy = [subprocess.Popen(["nice", "-n", "5", sys.executable, "-c", "while True: pass"]) for _ in range(2)]
    try:
        return Ends(os.path.abspath(programs), int(components)).run(int(count))
    finally:
        for process in busy:
            process.kill()
            process.wait()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
