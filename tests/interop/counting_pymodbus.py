# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client of pymodbus, as counting_libmodbus.cpp: python3 counting_pymodbus.py DEVICE COUNT TIME_OUT_MS"""
import logging
import sys

from pymodbus.client import ModbusSerialClient

logging.disable(logging.CRITICAL)


def main(device, count, time_out):
    # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
    line = ModbusSerialClient(device, baudrate=19200, parity="N", stopbits=1, retries=0)
    line.params.timeout = int(time_out) / 1000  # its constructor takes whole seconds only
    line.connect()
    right = wrong = 0
    for i in range(int(count)):
        address = 100 + i * 37 % 100
        try:
            values = line.read_holding_registers(address, 1, slave=1).registers
        except Exception:  # noqa: B902  whatever it makes of what it heard, it is no value
            line.connect()
            continue
        right += values == [address]
        wrong += values != [address]
    print(right, wrong, int(count) - right - wrong)


main(*sys.argv[1:])
