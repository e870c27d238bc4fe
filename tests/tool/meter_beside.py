# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A meter that nobody here wrote (pymodbus), and a line that it shares with simulated drives.

    python3 meter_beside.py --serve DEVICE
"""
import asyncio
import math
import os
import select
import sys
import time
import tty

METER = 61
METER_FILE = """[[register]]
name = "voltage"
space = "input"
address = 1000
type = "f32"
order = "cdab"
unit = "V"

[[register]]
name = "power"
space = "input"
address = 1002
scale = 0.1
unit = "W"

[[register]]
name = "energy"
space = "input"
address = 1003
type = "u32"
scale = 0.001
unit = "kWh"
"""


async def serve(device):
    """Input registers only: 230 V that swing by 2 V in 20 s, 1200 W, and an energy that counts."""
    import struct

    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.server import StartAsyncSerialServer
    from pymodbus.transaction import ModbusRtuFramer
    began = time.monotonic()

    class Moving(ModbusSparseDataBlock):
        def getValues(self, address, count=1):
            seconds = time.monotonic() - began
            high, low = struct.unpack(">2H", struct.pack(">f", 230 + 2 * math.sin(seconds * math.pi / 10)))
            energy = int(1_000_000 + seconds * 10)
            self.values = {1000: low, 1001: high, 1002: 12_000 + int(seconds) % 7, 1003: energy >> 16, 1004: energy & 0xFFFF}
            return super().getValues(address, count)

    meter = ModbusSlaveContext(ir=Moving({1000 + i: 0 for i in range(5)}), zero_mode=True)
    server = await StartAsyncSerialServer(ModbusServerContext(slaves={METER: meter}, single=False), framer=ModbusRtuFramer,
                                          port=device, baudrate=19200, parity="N", ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[2]))
else:
    from support import Line

    class SharedLine(Line):
        """with SharedLine(device, other) as line: what a client of `line.name` asks goes to both, and both answer."""

        def __init__(self, *devices):
            super().__init__()
            self.others = [os.open(each, os.O_RDWR | os.O_NOCTTY) for each in devices]
            for each in self.others:
                tty.setraw(each)

        def forward(self):
            while True:
                ready, _, _ = select.select([self.near, self.ends[0], *self.others], [], [])
                if self.ends[0] in ready:
                    return
                if self.near in ready:
                    data = os.read(self.near, 512)
                    self.hear(data)
                    for each in self.others:
                        os.write(each, data)
                for each in self.others:
                    if each in ready:
                        self.say(os.read(each, 512))

        def __exit__(self, *how):
            super().__exit__(*how)
            for each in self.others:
                os.close(each)
