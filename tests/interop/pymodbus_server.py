# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A server of pymodbus for our client: unit 1, registers 100..199 hold their own address.

    python3 pymodbus_server.py DEVICE|tcp:PORT
"""
import asyncio
import sys

from pymodbus.datastore import (ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext)
from pymodbus.device import ModbusDeviceIdentification
from pymodbus.server import StartAsyncSerialServer, StartAsyncTcpServer
from pymodbus.transaction import ModbusRtuFramer

# Too much for one page.
IDENTITY = {0x00: "pymodbus", 0x01: "product " + "x" * 150, 0x02: "3.0",
            0x03: "url " + "y" * 180, 0x04: "name"}


async def serve(device):
    words = ModbusSequentialDataBlock(100, list(range(100, 200)))
    unit = ModbusSlaveContext(hr=words, zero_mode=True)
    context = ModbusServerContext(slaves={1: unit}, single=False)
    common = {"framer": ModbusRtuFramer, "identity": ModbusDeviceIdentification(info=IDENTITY),
              "ignore_missing_slaves": True, "defer_start": True}
    if device.startswith("tcp:"):
        server = await StartAsyncTcpServer(context, address=("127.0.0.1", int(device[4:])), **common)
    else:
        # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
        server = await StartAsyncSerialServer(
            context, port=device, baudrate=19200, parity="N", stopbits=1, **common)
        await server.start()
    print("ready", flush=True)
    await server.serve_forever()


if __name__ == "__main__":
    asyncio.run(serve(*sys.argv[1:]))
