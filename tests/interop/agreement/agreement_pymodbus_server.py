# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A server of pymodbus with the memory of agreement.hpp, unit 1: python3 agreement_pymodbus_server.py DEVICE

pymodbus has no files and no queues, and no way to set what functions 07, 08, 11 and 12 tell; registers of the memory
say it here. Where its own response is not the specification's, one is written here, so that its decoder of requests
and our client meet all the same:
- 20: its server tells no records, and its encoder puts the reference before the size, and registers for bytes; AP 6.14:
  file response length, reference type, data.
- 24: its encoder tells the bytes of the queue where AP 6.18 has the FIFO count, in registers.
- 07: with its event counter above 0 the status has nine bits, which is an exception 04; AP 6.7 has one byte.
- 08/04 is not asked, because AP 6.8.1 has no response to it, nor 08/13, which is not in AP 6.8.1: pymodbus answers it
  with the counter of 08/12.
"""
import asyncio
import struct
import sys

from pymodbus.datastore import (ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext)
from pymodbus.device import ModbusControlBlock, ModbusDeviceIdentification
from pymodbus.file_message import (FileRecord, ReadFifoQueueRequest, ReadFifoQueueResponse, ReadFileRecordRequest,
                                   ReadFileRecordResponse, WriteFileRecordRequest, WriteFileRecordResponse)
from pymodbus.server import StartAsyncSerialServer
from pymodbus.transaction import ModbusRtuFramer

from agreement import (ADDRESSES, COUNTERS_AT, EVENTS_AT, ID_AT, LOG_AT, MESSAGES_AT, STATUS_AT, input_bit,
                       input_word, record_at)

# Too much for one page; agreement_client.cpp has the lengths.
IDENTITY = {0x00: "pymodbus", 0x01: "product " + "x" * 150, 0x02: "3.0", 0x03: "url " + "y" * 180, 0x04: "name",
            0x06: "application", 0x80: "z" * 100, 0xFF: "l" * 150}
COUNTERS = ["BusMessage", "BusCommunicationError", "BusExceptionError", "SlaveMessage", "SlaveNoResponse", "SlaveNAK",
            "SlaveBusy", "BusCharacterOverrun"]


class Logged:
    def __init__(self, number):
        self.number = number

    def encode(self):
        return bytes([self.number])


class Memory(ModbusSequentialDataBlock):
    """Registers of which some say what other functions tell."""
    unit = None

    def low_bytes(self, first, most):
        count = self.values[first] % (most + 1)
        return [word & 0xFF for word in self.values[first + 1:first + 1 + count]]

    def setValues(self, address, values):
        super().setValues(address, values)
        control = ModbusControlBlock()
        if address == STATUS_AT:
            control.Counter.reset()
            for bit, counter in enumerate(COUNTERS):
                setattr(control.Counter, counter, self.values[STATUS_AT] >> bit & 1)
        elif address == EVENTS_AT:
            control.Counter.Event = self.values[EVENTS_AT]
            control.Counter.BusMessage = self.values[MESSAGES_AT]
        elif address == COUNTERS_AT:
            for at, counter in enumerate(COUNTERS):
                setattr(control.Counter, counter, self.values[COUNTERS_AT + at])
        elif address == LOG_AT:
            events = control.Counter.Event
            control.clearEvents()
            # The latest comes first.
            for number in reversed(self.low_bytes(LOG_AT, 64)):
                control.addEvent(Logged(number))
            control.Counter.Event = events
        elif address == ID_AT:
            self.unit.reportSlaveIdData = bytes(self.low_bytes(ID_AT, 122))


class FileResponse(ReadFileRecordResponse):
    def encode(self):
        runs = b"".join(struct.pack(">BB", len(record.record_data) + 1, 6) + record.record_data
                        for record in self.records)
        return struct.pack(">B", len(runs)) + runs


class QueueResponse(ReadFifoQueueResponse):
    def encode(self):
        return struct.pack(f">HH{len(self.values)}H", 2 + 2 * len(self.values), len(self.values), *self.values)


def serve_files_and_queues(memory):
    def read_files(request, _context):
        told = []
        for record in request.records:
            words = [memory.values[record_at(record.file_number, record.record_number + i)]
                     for i in range(record.record_length)]
            told.append(FileRecord(record_data=struct.pack(f">{len(words)}H", *words)))
        return FileResponse(told)

    def write_files(request, _context):
        for record in request.records:
            words = struct.unpack(f">{record.record_length}H", record.record_data)
            for i, word in enumerate(words):
                memory.values[record_at(record.file_number, record.record_number + i)] = word
        return WriteFileRecordResponse(request.records)

    def read_queue(request, _context):
        count = memory.values[request.address] % 32
        return QueueResponse([memory.values[(request.address + 1 + i) % ADDRESSES] for i in range(count)])

    ReadFileRecordRequest.execute = read_files
    WriteFileRecordRequest.execute = write_files
    ReadFifoQueueRequest.execute = read_queue


async def serve(device):
    held = Memory(0, [0] * ADDRESSES)
    unit = ModbusSlaveContext(
        co=ModbusSequentialDataBlock(0, [False] * ADDRESSES), hr=held,
        di=ModbusSequentialDataBlock(0, [input_bit(at) for at in range(ADDRESSES)]),
        ir=ModbusSequentialDataBlock(0, [input_word(at) for at in range(ADDRESSES)]), zero_mode=True)
    held.unit = unit
    serve_files_and_queues(held)
    context = ModbusServerContext(slaves={1: unit}, single=False)
    server = await StartAsyncSerialServer(
        context, framer=ModbusRtuFramer, identity=ModbusDeviceIdentification(info=IDENTITY), port=device,
        baudrate=115200, parity="N", stopbits=1, ignore_missing_slaves=True, defer_start=True)
    await server.start()
    print("ready", flush=True)
    await server.serve_forever()


if __name__ == "__main__":
    asyncio.run(serve(*sys.argv[1:]))
