"""TCPROS and the slave API without code of ROS: a publisher, a subscriber, and a caller of services.

See http://wiki.ros.org/ROS/TCPROS and http://wiki.ros.org/ROS/Slave_API. All traffic stays on the loopback interface.
"""

import os
import select
import signal
import socket
import struct
import subprocess
import threading
import time
import xmlrpc.client
import xmlrpc.server

HOST = "127.0.0.1"
CALLER = "/wire_driver"
PATIENCE = 60.0  # [s], ends a wait that fails
FRAME = b"x"
FORCE_SIZE = 4 + 16 + len(FRAME) + 40  # bytes of a Force on the wire, including its length


class WireError(RuntimeError):
    """Raised if the other side of a connection does not follow the protocol."""


def free_port():
    with socket.socket() as probe:
        probe.bind((HOST, 0))
        return probe.getsockname()[1]


def until(condition, what, patience=PATIENCE):
    """Repeat the condition until its value is true, and return the value."""
    end = time.monotonic() + patience
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise WireError(f"waited {patience:.0f} s for {what}")
        time.sleep(0.01)


def is_closed(connection):
    """Return True if the other side has closed the connection. All data from it must have been read."""
    readable, _, _ = select.select([connection], [], [], 0.0)
    return bool(readable) and connection.recv(1, socket.MSG_PEEK) == b""


def text(value):
    data = value.encode() if isinstance(value, str) else value
    return struct.pack("<I", len(data)) + data


def sample(number, displacement=1e-3, frame=FRAME, step=1000000, sequence=None):
    """Return a Displacement on the wire, including its length. Stamps start at 1000 s and are a step [ns] apart."""
    seconds, nanoseconds = divmod(number * step, 10**9)
    return text(struct.pack("<III", number if sequence is None else sequence, 1000 + seconds, nanoseconds) +
                text(frame) + struct.pack("<d", displacement))


def receive(sock, size):
    data = b""
    while len(data) < size:
        piece = sock.recv(size - len(data))
        if not piece:
            raise WireError("the connection was closed")
        data += piece
    return data


def send_header(sock, fields):
    data = b"".join(text(f"{key}={value}") for key, value in fields.items())
    sock.sendall(text(data))


def receive_header(sock):
    data = receive(sock, struct.unpack("<I", receive(sock, 4))[0])
    fields = {}
    while data:
        size = struct.unpack_from("<I", data)[0]
        key, _, value = data[4:4 + size].partition(b"=")
        fields[key.decode()] = value.decode()
        data = data[4 + size:]
    return fields


class Timeout(xmlrpc.client.Transport):
    def make_connection(self, host):
        connection = super().make_connection(host)
        connection.timeout = PATIENCE
        return connection


def proxy(uri):
    return xmlrpc.client.ServerProxy(uri, transport=Timeout())


class Program:
    """A child process in a session of its own."""

    def __init__(self, arguments, environment, log):
        self.log = log
        with open(log, "wb") as file:
            self.process = subprocess.Popen(arguments, env=environment, stdin=subprocess.DEVNULL, stdout=file,
                                            stderr=subprocess.STDOUT, start_new_session=True)

    def end(self, number=signal.SIGINT):
        """Send the signal, and return the exit status."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            raise WireError(f"process did not end within {PATIENCE:.0f} s of signal {number}") from None

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGCONT)
            self.process.kill()
            self.process.wait()

    def memory(self, field="VmRSS"):
        """Return the memory of the process [bytes]."""
        with open(f"/proc/{self.process.pid}/status") as status:
            return next(int(line.split()[1]) * 1024 for line in status if line.startswith(field))

    def output(self):
        with open(self.log, errors="replace") as file:
            return file.read()


class Network:
    """A master, a slave API of the test itself, and the nodes that are started with them."""

    def __init__(self, folder):
        self.folder = folder
        self.port = free_port()
        self.uri = f"http://{HOST}:{self.port}"
        self.environment = dict(os.environ, ROS_MASTER_URI=self.uri, ROS_HOSTNAME=HOST, ROS_HOME=folder,
                                ROS_LOG_DIR=folder)
        self.environment.pop("ROS_IP", None)
        self.programs = []
        self.master_process = self.start(["rosmaster", "--core", "-p", str(self.port)], "master")
        self.master = proxy(self.uri)
        until(self.master_answers, "the master")
        self.listener = socket.create_server((HOST, 0), backlog=1024)
        self.listener.settimeout(PATIENCE)
        self.slave = xmlrpc.server.SimpleXMLRPCServer((HOST, 0), logRequests=False, allow_none=True)
        self.slave.register_function(self.request_topic, "requestTopic")
        self.slave.register_function(lambda *_: [1, "", 0], "publisherUpdate")
        self.slave.register_function(lambda *_: [1, "", os.getpid()], "getPid")
        self.slave_uri = f"http://{HOST}:{self.slave.server_address[1]}"
        threading.Thread(target=self.slave.serve_forever, daemon=True).start()
        self.waiting = {}  # accepted connections to the test's publishers, by topic, until they are asked for

    def master_answers(self):
        try:
            return self.master.getPid(CALLER)[0] == 1
        except OSError:
            return False

    def request_topic(self, _caller, _topic, _protocols):
        return [1, "", ["TCPROS", HOST, self.listener.getsockname()[1]]]

    def start(self, arguments, name, **environment):
        program = Program(arguments, dict(self.environment, **environment), os.path.join(self.folder, name + ".log"))
        self.programs.append(program)
        return program

    def node_api(self, node):
        """Return the slave API of a node, after waiting until the node is registered at the master."""
        def lookup():
            code, _, uri = self.master.lookupNode(CALLER, node)
            return uri if code == 1 else None
        return proxy(until(lookup, f"node {node}"))

    def publish(self, topic, message_type):
        """Register as a publisher, and return the socket of the first subscriber."""
        self.master.registerPublisher(CALLER, topic, message_type, self.slave_uri)
        while topic not in self.waiting:
            try:
                connection, _ = self.listener.accept()
            except socket.timeout:
                raise WireError(f"nobody subscribed to {topic}") from None
            connection.settimeout(PATIENCE)
            try:
                fields = receive_header(connection)
                gone = is_closed(connection)
            except WireError:
                gone = True
            if gone:  # this connection is to an earlier publisher, so the node connects again
                connection.close()
                continue
            send_header(connection, {"callerid": CALLER, "type": fields["type"], "md5sum": fields["md5sum"],
                                     "topic": fields["topic"], "latching": "0", "message_definition": ""})
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.waiting[fields["topic"]] = connection
        return self.waiting.pop(topic)

    def subscribe(self, node, topic, receive_buffer=0, caller=CALLER):
        """Return a socket that receives all messages which the node publishes on a topic from now on."""
        api = self.node_api(node)
        return until(lambda: self.connect(api, topic, receive_buffer, caller), f"{node} to publish {topic}")

    @staticmethod
    def connect(api, topic, receive_buffer, caller):
        """Connect to the topic, or return None while the node does not publish it."""
        code, _, protocol = api.requestTopic(CALLER, topic, [["TCPROS"]])
        if code != 1:
            return None
        sock = socket.socket()
        if receive_buffer:
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        sock.settimeout(PATIENCE)
        sock.connect((protocol[1], protocol[2]))
        send_header(sock, {"callerid": caller, "topic": topic, "md5sum": "*", "type": "*", "tcp_nodelay": "1"})
        error = receive_header(sock).get("error")
        if error is None:
            return sock
        sock.close()
        if "nonexistent topic" not in error:
            raise WireError(f"{topic}: {error}")
        return None

    def call(self, service, request=b""):
        """Call a service, and return its success and the bytes of its answer."""
        def lookup():
            code, _, uri = self.master.lookupService(CALLER, service)
            return uri if code == 1 else None
        host, _, port = until(lookup, f"service {service}")[len("rosrpc://"):].partition(":")
        with socket.create_connection((host, int(port)), PATIENCE) as sock:
            send_header(sock, {"callerid": CALLER, "service": service, "md5sum": "*"})
            receive_header(sock)
            sock.sendall(text(request))
            done = receive(sock, 1) == b"\1"
            return done, receive(sock, struct.unpack("<I", receive(sock, 4))[0])

    def close(self):
        for program in reversed(self.programs):
            program.kill()
        self.slave.shutdown()
        self.slave.server_close()
        self.listener.close()


def trigger(answer):
    """Return success and message of a std_srvs/Trigger response."""
    done, data = answer
    return done and data[0] == 1, data[5:].decode() if done else data.decode()


class Reader:
    """Reads the fields of a message one after the other."""

    def __init__(self, data):
        self.data = data
        self.place = 0

    def number(self, code):
        value = struct.unpack_from("<" + code, self.data, self.place)[0]
        self.place += struct.calcsize("<" + code)
        return value

    def text(self):
        size = self.number("I")
        self.place += size
        return self.data[self.place - size:self.place].decode()

    def header(self):
        self.place += 12
        self.text()


def diagnostics(data):
    """Return a DiagnosticArray as {name: (level, message, {key: value})}."""
    reader = Reader(data)
    reader.header()
    result = {}
    for _ in range(reader.number("I")):
        level = reader.number("B")
        name, message, _ = reader.text(), reader.text(), reader.text()
        values = {reader.text(): reader.text() for _ in range(reader.number("I"))}
        result[name.split(": ", 1)[-1]] = (level, message, values)
    return result


def next_message(sock):
    return receive(sock, struct.unpack("<I", receive(sock, 4))[0])
