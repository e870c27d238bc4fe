# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A server of pymodbus whose memory is set and told on its standard input and output, as memory_libmodbus.cpp has it.

    python3 memory_pymodbus.py DEVICE FIRST COUNT        mbap:1502 for a device: Modbus TCP on that port of this machine
"""
import asyncio
import sys

from pymodbus.bit_write_message import WriteMultipleCoilsRequest, WriteSingleCoilRequest
from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.device import ModbusDeviceIdentification
from pymodbus.pdu import ModbusExceptions
from pymodbus.register_write_message import (MaskWriteRegisterRequest, WriteMultipleRegistersRequest,
                                             WriteSingleRegisterRequest)
from pymodbus.server import StartAsyncSerialServer, StartAsyncTcpServer
from pymodbus.transaction import ModbusRtuFramer

CODES = {"coil": 1, "discrete": 2, "holding": 3, "input": 4}
LACKING = set()

for request in (WriteMultipleCoilsRequest, WriteSingleCoilRequest, MaskWriteRegisterRequest,
                WriteMultipleRegistersRequest, WriteSingleRegisterRequest):
    def execute(self, context, known=request.execute):
        lacks = self.function_code in LACKING
        return self.doException(ModbusExceptions.IllegalFunction) if lacks else known(self, context)
    request.execute = execute


def told(unit, words):
    if words[0] == "lack":
        LACKING.clear()
        LACKING.update(map(int, words[1:]))
        return "done"
    code, address = CODES[words[1]], int(words[2])
    if words[0] == "set":
        values = [int(word, 16) for word in words[3:]]
        unit.setValues(code, address, [bool(value) for value in values] if code < 3 else values)
        return "done"
    return " ".join(f"{int(value):04x}" for value in unit.getValues(code, address, int(words[3])))


async def serve(device, first, count):
    def block(value):
        return ModbusSequentialDataBlock(int(first), [value] * int(count))
    unit = ModbusSlaveContext(hr=block(0), ir=block(0), co=block(False), di=block(False), zero_mode=True)
    units = ModbusServerContext(slaves={1: unit, 2: unit}, single=False)
    how = {"identity": ModbusDeviceIdentification(info={0: "pymodbus", 1: "memory", 2: "1"}),
           "ignore_missing_slaves": True, "defer_start": True}
    if device.startswith("mbap:"):
        server = await StartAsyncTcpServer(units, address=("127.0.0.1", int(device[5:])), **how)
    else:
        # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
        server = await StartAsyncSerialServer(units, framer=ModbusRtuFramer, port=device, baudrate=115200, parity="N",
                                              stopbits=1, **how)
        await server.start()
    asyncio.get_running_loop().add_reader(
        sys.stdin, lambda: print(told(unit, sys.stdin.readline().split()), flush=True))
    serving = asyncio.ensure_future(server.serve_forever())
    if device.startswith("mbap:"):
        await server.serving
    print("ready", flush=True)
    await serving


asyncio.run(serve(*sys.argv[1:]))
