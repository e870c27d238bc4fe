# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A name server at 127.0.0.1: each name has the address 127.0.0.1, and none of IPv6. Says "ready" on its standard output."""
import socket
import struct

QUESTION = 12  # bytes of the head, behind which the question stands
ANSWER = b"\xc0\x0c" + struct.pack(">HHIH", 1, 1, 60, 4) + bytes([127, 0, 0, 1])

with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as server:
    server.bind(("127.0.0.1", 53))
    print("ready", flush=True)
    while True:
        asked, client = server.recvfrom(512)
        end = asked.index(b"\0", QUESTION) + 5
        is_of_ipv4 = asked[end - 4:end - 2] == b"\0\1"
        head = asked[:2] + struct.pack(">HHHHH", 0x8180, 1, is_of_ipv4, 0, 0)
        server.sendto(head + asked[QUESTION:end] + (ANSWER if is_of_ipv4 else b""), client)
