# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""MQTT 3.1.1 as these tests need it, by the standard library: a client that notes when each message came, and a proxy that
counts packets and cuts, slows or silences a connection. The broker is mosquitto."""
import socket
import threading
import time

CONNECT, CONNACK, PUBLISH, PUBACK, SUBSCRIBE, SUBACK, PINGREQ, PINGRESP, DISCONNECT = 1, 2, 3, 4, 8, 9, 12, 13, 14


def text(words):
    data = words.encode() if isinstance(words, str) else words
    return len(data).to_bytes(2, "big") + data


def packet(kind, body, flags=0):
    size, length = len(body), b""
    while True:
        size, digit = size >> 7, size & 127
        length += bytes([digit | (128 if size else 0)])
        if not size:
            return bytes([kind << 4 | flags]) + length + body


def next_packet(data):
    """The first packet that is whole, its kind, flags and body, and what is behind it; None before it is whole."""
    size, shift, at = 0, 0, 1
    while True:
        if at >= len(data):
            return None
        size, shift, at = size | (data[at] & 127) << shift, shift + 7, at + 1
        if data[at - 1] < 128:
            break
    if len(data) < at + size:
        return None
    return data[0] >> 4, data[0] & 15, data[at:at + size], data[at + size:]


def published(flags, body):
    """Topic, payload and packet number of a PUBLISH."""
    size = int.from_bytes(body[:2], "big")
    topic, rest = body[2:2 + size].decode(), body[2 + size:]
    if flags >> 1 & 3:
        return topic, rest[2:], rest[:2]
    return topic, rest, None


class Message:
    def __init__(self, topic, payload, is_retained):
        self.arrived, self.topic, self.payload, self.is_retained = time.time(), topic, payload, is_retained

    def __repr__(self):
        return f"{self.topic} {'(retained) ' if self.is_retained else ''}{self.payload[:200]!r} at {self.arrived:.3f}"


class Client:
    """with Client(port, "a/#") as client: `client.messages` is what came, in its order. It has its subscription when it
    begins. It connects once: a broker that goes takes it along."""

    def __init__(self, port, *topics, user=None, password=None):
        self.messages, self.lock, self.number = [], threading.Lock(), 0
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=60)
        self.acknowledged = threading.Semaphore(0)
        flags = 2 | (0x80 if user else 0) | (0x40 if password else 0)
        self.send(packet(CONNECT, text("MQTT") + bytes([4, flags, 0, 0]) + text("") + (text(user) if user else b"")
                         + (text(password) if password else b"")))
        self.thread = threading.Thread(target=self.receive, daemon=True)
        self.thread.start()
        self.wait()
        for topic in topics:
            self.subscribe(topic)

    def send(self, data):
        with self.lock:
            self.socket.sendall(data)

    def wait(self):
        if not self.acknowledged.acquire(timeout=60):
            raise RuntimeError("the broker acknowledges nothing")

    def next_number(self):
        self.number += 1
        return self.number.to_bytes(2, "big")

    def subscribe(self, topic, qos=1):
        self.send(packet(SUBSCRIBE, self.next_number() + text(topic) + bytes([qos]), 2))
        self.wait()

    def publish(self, topic, payload, retain=False, qos=1):
        """The broker has it when this returns, with qos 1."""
        body = text(topic) + (self.next_number() if qos else b"") + (payload.encode() if isinstance(payload, str) else payload)
        self.send(packet(PUBLISH, body, qos << 1 | retain))
        if qos:
            self.wait()

    def receive(self):
        waiting = b""
        try:
            self.socket.settimeout(None)
            while data := self.socket.recv(65536):
                waiting += data
                while found := next_packet(waiting):
                    kind, flags, body, waiting = found
                    if kind in (CONNACK, SUBACK, PUBACK):
                        self.acknowledged.release()
                    elif kind == PUBLISH:
                        topic, payload, number = published(flags, body)
                        self.messages.append(Message(topic, payload, bool(flags & 1)))
                        if number:
                            self.send(packet(PUBACK, number))
        except OSError:
            pass

    def of(self, topic):
        return [each for each in list(self.messages) if each.topic == topic]

    def last(self, topic):
        """The payload that counts, as text; None where there was none."""
        found = self.of(topic)
        return found[-1].payload.decode() if found else None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()


class Connection:
    """One of a proxy: `sent` is what the gateway said in packets (kind, flags, body), `told` what the broker said."""

    def __init__(self, near, far):
        self.near, self.far, self.sent, self.told, self.bytes_sent, self.is_cut = near, far, [], [], 0, False
        self.began = time.time()

    def cut(self):
        self.is_cut = True
        for each in (self.near, self.far):
            try:
                each.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass


class Proxy:
    """with Proxy(port) as proxy: in front of the broker at `port`, itself at `proxy.port`. How each connection behaves is
    said by `behave(connection)`, called behind each packet of either side: "cut" ends it. `after_bytes` cuts the next
    connection behind so many bytes of the gateway. While `is_silent` nothing passes on the connections that are there;
    `rate` in bytes a second slows what the gateway says."""

    def __init__(self, port):
        self.far_port, self.connections = port, []
        self.is_silent, self.rate, self.after_bytes, self.behave = False, None, None, lambda connection: None
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        self.silenced = set()
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            try:
                near, _ = self.listening.accept()
            except OSError:
                return
            try:
                far = socket.create_connection(("127.0.0.1", self.far_port), timeout=10)
                far.settimeout(None)
            except OSError:
                near.close()
                continue
            for each in (near, far):
                each.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            connection = Connection(near, far)
            limit, self.after_bytes = self.after_bytes, None
            self.connections.append(connection)
            threading.Thread(target=self.carry, args=(connection, near, far, connection.sent, limit), daemon=True).start()
            threading.Thread(target=self.carry, args=(connection, far, near, connection.told, None), daemon=True).start()

    def silence(self):
        """The connections that are there say nothing any more, and stay open."""
        self.silenced = set(map(id, self.connections))

    def carry(self, connection, one, other, noted, limit):
        waiting, passed = b"", 0
        try:
            while data := one.recv(4096):
                if id(connection) in self.silenced:
                    continue
                if noted is connection.sent and self.rate:
                    time.sleep(len(data) / self.rate)
                waiting += data
                while found := next_packet(waiting):
                    kind, flags, body, rest = found
                    whole, waiting = waiting[:len(waiting) - len(rest)], rest
                    if limit is not None and passed + len(whole) >= limit:
                        other.sendall(whole[:limit - passed])
                        raise OSError
                    other.sendall(whole)
                    passed += len(whole)
                    noted.append((kind, flags, body))
                    if noted is connection.sent:
                        connection.bytes_sent = passed
                    if self.behave(connection) == "cut":
                        raise OSError
        except OSError:
            pass
        if id(connection) not in self.silenced:
            connection.cut()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.listening.close()
        for each in self.connections:
            each.cut()
