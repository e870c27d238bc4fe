# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client of pymodbus, as asking_libmodbus.cpp: python3 asking_pymodbus.py PORT

In 3.0.0rc1 22 and 23 take the unit by another name than the others; by that of the others they go to unit 0."""
import logging
import sys

from pymodbus.client import ModbusTcpClient

logging.disable(logging.CRITICAL)


def ask(line, function, address, words):
    if function in (1, 2, 3, 4):
        read = {1: line.read_coils, 2: line.read_discrete_inputs, 3: line.read_holding_registers, 4: line.read_input_registers}[function]
        answer = read(address, words[0], slave=1)
        if answer.isError():
            return answer, []
        return answer, [int(bit) for bit in answer.bits[:words[0]]] if function < 3 else answer.registers
    if function == 5:
        return line.write_coil(address, bool(words[0]), slave=1), []
    if function == 6:
        return line.write_register(address, words[0], slave=1), []
    if function == 15:
        return line.write_coils(address, [bool(word) for word in words], slave=1), []
    if function == 16:
        return line.write_registers(address, words, slave=1), []
    if function == 22:
        return line.mask_write_register(address, words[0], words[1], unit=1), []
    answer = line.readwrite_registers(read_address=address, read_count=words[0], write_address=words[1], write_registers=words[2:], unit=1)
    return answer, [] if answer.isError() else answer.registers


def main(port):
    line = ModbusTcpClient("127.0.0.1", port=int(port), timeout=20, retries=0)
    if not line.connect():
        sys.exit("pymodbus cannot connect")
    for text in sys.stdin:
        function, address, *words = map(int, text.split())
        try:
            answer, values = ask(line, function, address, words)
        except Exception as error:  # noqa: B902  told
            print("failed", repr(error), flush=True)
            continue
        if answer.isError():
            code = getattr(answer, "exception_code", None)
            print(f"exception {code}" if code else f"failed {answer}", flush=True)
        else:
            print("ok", *values, flush=True)
    line.close()


main(*sys.argv[1:])
