# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client of pymodbus against our server: python3 pymodbus_client.py DEVICE"""
from pymodbus.exceptions import ModbusIOException
from pymodbus.mei_message import ReadDeviceInformationRequest
from pymodbus.pdu import ExceptionResponse

from simulator import pymodbus_on, runs


def refused(answer, code):
    return isinstance(answer, ExceptionResponse) and answer.exception_code == code


def main(expect, device):
    line = pymodbus_on(device)
    read = line.read_holding_registers(100, 63, slave=1)
    expect(not read.isError() and read.registers == list(range(100, 163)), "03 reads 63")
    expect(not line.write_register(110, 0xBEEF, slave=1).isError(), "06 writes")
    expect(not line.write_registers(111, [7, 8], slave=1).isError(), "16 writes")
    back = line.read_holding_registers(110, 3, slave=1)
    expect(not back.isError() and back.registers == [0xBEEF, 7, 8], "all was written")
    both = line.readwrite_registers(read_address=111, read_count=3, write_address=112,
                                    write_registers=[0x1234], unit=1)
    expect(not both.isError() and both.registers == [7, 0x1234, 113],
           "23 writes, then reads", both)
    who = line.execute(ReadDeviceInformationRequest(read_code=2, object_id=0, unit=1))
    expect(not who.isError() and who.information.get(1) == b"ATV310H037N4"
           and who.information.get(4) == b"interoperability test", "43/14 identifies", who)
    expect(not who.isError() and (who.more_follows, who.next_object_id) == (0xFF, 5),
           "43/14 says that more follows")
    rest = line.execute(ReadDeviceInformationRequest(read_code=2, object_id=5, unit=1))
    expect(not rest.isError() and rest.more_follows == 0 and list(rest.information) == [5]
           and len(rest.information[5]) == 120, "43/14 gives the rest", rest)
    expect(refused(line.read_coils(0, 1, slave=1), 1), "exception 01")
    expect(refused(line.read_holding_registers(199, 2, slave=1), 2), "exception 02")
    expect(refused(line.read_holding_registers(100, 64, slave=1), 3), "exception 03")
    nobody = line.read_holding_registers(100, 1, slave=9)
    expect(isinstance(nobody, ModbusIOException), "silence of another unit", nobody)


runs(main)
