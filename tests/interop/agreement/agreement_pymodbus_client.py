# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A client of pymodbus sends random requests to our server: agreement_pymodbus_client.py DEVICE COUNT FUNCTION...

Where pymodbus decodes a response otherwise than the specification has it, the response's bytes are compared:
- 24: its decoder takes the FIFO count for bytes, and reads four registers too few; AP 6.18: a count of registers.
- 17: its identifier includes the run indicator; AP 6.13 has that behind it.
"""
import logging
import struct
import sys

from pymodbus import diag_message
from pymodbus.client import ModbusSerialClient
from pymodbus.exceptions import ModbusIOException
from pymodbus.file_message import (FileRecord, ReadFifoQueueRequest, ReadFifoQueueResponse, ReadFileRecordRequest,
                                   WriteFileRecordRequest)
from pymodbus.mei_message import ReadDeviceInformationRequest
from pymodbus.other_message import (GetCommEventCounterRequest, GetCommEventLogRequest, ReadExceptionStatusRequest,
                                    ReportSlaveIdRequest)
from pymodbus.register_write_message import MaskWriteRegisterRequest

from agreement import Agreement, ID_AT, Lost, STATUS_AT, record_at

# What our server says of itself: the length of each object.
OBJECTS = {0: 7, 1: 9, 2: 4, 3: 19, 4: 21, 6: 120, 0x80: 120, 0xFF: 4}


class Queue(ReadFifoQueueResponse):
    """Keeps the bytes."""
    def decode(self, data):
        size, count = struct.unpack(">HH", data[:4])
        self.values = list(struct.unpack(f">{count}H", data[4:])) if size == 2 + 2 * count else None


class Client:
    def __init__(self, device):
        # A pseudo-terminal keeps no parity, and pyserial takes that for an error.
        self.line = ModbusSerialClient(device, baudrate=115200, parity="N", stopbits=1, timeout=1, retries=0)
        if not self.line.connect():
            raise RuntimeError("pymodbus cannot open the device")
        self.line.framer.decoder.register(Queue)

    @staticmethod
    def told(answer):
        if isinstance(answer, ModbusIOException):
            raise Lost
        if answer.isError():
            print("     pymodbus:", answer)
            return None
        return answer

    def send(self, request):
        request.unit_id = 1
        return self.told(self.line.execute(request))

    def read_bits(self, function, start, count):
        ask = self.line.read_coils if function == 1 else self.line.read_discrete_inputs
        answer = self.told(ask(start, count, slave=1))
        return answer and answer.bits[:count]

    def read_words(self, function, start, count):
        ask = self.line.read_holding_registers if function == 3 else self.line.read_input_registers
        answer = self.told(ask(start, count, slave=1))
        return answer and answer.registers

    def write_bit(self, at, value):
        answer = self.told(self.line.write_coil(at, value, slave=1))
        return answer and (answer.address, answer.value) == (at, value)

    def write_word(self, at, value):
        answer = self.told(self.line.write_register(at, value, slave=1))
        return answer and (answer.address, answer.value) == (at, value)

    def write_bits(self, start, bits):
        answer = self.told(self.line.write_coils(start, bits, slave=1))
        return answer and (answer.address, answer.count) == (start, len(bits))

    def write_words(self, start, words):
        answer = self.told(self.line.write_registers(start, words, slave=1))
        return answer and (answer.address, answer.count) == (start, len(words))

    def exchange(self, read_at, count, write_at, words):
        answer = self.told(self.line.readwrite_registers(
            read_address=read_at, read_count=count, write_address=write_at, write_registers=words, unit=1))
        return answer and answer.registers


class PymodbusAgreement(Agreement):
    """The functions that are more than to read and to write bits and registers."""

    def further(self, function):
        {7: self.status_outputs, 8: self.diagnostics, 11: self.counter, 12: self.log, 17: self.server_id,
         20: self.read_file, 21: self.write_file, 22: self.mask, 23: self.exchange, 24: self.queue,
         43: self.identification}[function]()

    def send(self, request):
        return self.ask(self.client.send, request)

    def status_outputs(self):
        self.write_words(STATUS_AT, self.words(1))
        answer = self.send(ReadExceptionStatusRequest())
        self.expect(answer and answer.status == self.held[STATUS_AT] & 0xFF, "07 tells", answer)

    def diagnostics(self):
        kind = self.random.randrange(6)
        if kind == 0:
            word = self.word()
            answer = self.send(diag_message.ReturnQueryDataRequest(word))
            self.expect(answer and tuple(answer.message) == (word,), "08/00 returns", word)
        elif kind == 1:
            word = self.random.randrange(256) << 8
            answer = self.send(diag_message.ChangeAsciiInputDelimiterRequest(word))
            self.expect(answer and tuple(answer.message) == (word,), "08/03 returns", word)
        elif kind == 2:
            toggle = self.random.random() < 0.5
            answer = self.send(diag_message.RestartCommunicationsOptionRequest(toggle))
            self.expect(answer and tuple(answer.message) == (0xFF00 if toggle else 0,), "08/01 returns", toggle)
        elif kind == 3:
            request = self.random.choice((
                diag_message.ReturnDiagnosticRegisterRequest, diag_message.ReturnBusCommunicationErrorCountRequest,
                diag_message.ReturnSlaveNAKCountRequest, diag_message.ReturnSlaveBusyCountRequest,
                diag_message.ReturnSlaveNoResponseCountRequest,
                diag_message.ReturnSlaveBusCharacterOverrunCountRequest, diag_message.ClearOverrunCountRequest))
            answer = self.send(request())
            self.expect(answer and tuple(answer.message) == (0,), "08 returns 0", request)
        else:
            self.messages(kind == 4)

    def messages(self, is_of_bus):
        """A number of requests, some of them refused, between a reset and the question how many they were."""
        before = self.repeated
        self.send(diag_message.ClearCountersRequest())
        refused = 0
        answered = self.random.randrange(4)
        for _ in range(answered):
            if self.random.random() < 0.5:
                refused += 1
                # Registers past 65535.
                self.expect(self.ask(self.client.line.read_holding_registers, 0xFFFF, 2, 1).isError(), "02 is sent")
            else:
                self.read_words(3, self.start(1), 1)
        told = self.send(diag_message.ReturnBusExceptionErrorCountRequest())
        self.expect(self.repeated > before or told and tuple(told.message) == (refused,), "08/0D counts", refused)
        # The reset itself is not counted any more.
        sent = answered + 2
        told = self.send(diag_message.ReturnBusMessageCountRequest() if is_of_bus
                         else diag_message.ReturnSlaveMessageCountRequest())
        self.expect(self.repeated > before or told and tuple(told.message) == (sent,), "08/0B or 0E counts", sent)

    def between(self):
        """Requests that are events."""
        events = self.random.randrange(3)
        for _ in range(events):
            self.read_words(3, self.start(1), 1)
        return events

    def counter(self):
        before = self.repeated
        first = self.send(GetCommEventCounterRequest())
        events = self.between()
        second = self.send(GetCommEventCounterRequest())
        self.expect(self.repeated > before or first and second and first.status and second.status
                    and second.count == (first.count + events) & 0xFFFF, "11 counts", events)

    def log(self):
        before = self.repeated
        first = self.send(GetCommEventLogRequest())
        events = self.between()
        second = self.send(GetCommEventLogRequest())
        # The first request of the log was an event and a message itself.
        self.expect(self.repeated > before or first and second and first.status and second.events == []
                    and second.event_count == (first.event_count + events + 1) & 0xFFFF
                    and second.message_count == (first.message_count + events + 1) & 0xFFFF, "12 counts", events)

    def server_id(self):
        size = self.random.randint(1, 122)
        self.write_words(ID_AT, [size, *self.words(size)])
        answer = self.send(ReportSlaveIdRequest())
        told = bytes(word & 0xFF for word in self.held[ID_AT + 1:ID_AT + 1 + size])
        self.expect(answer and bytes(answer.identifier) == told, "17 tells", size)

    def random_run(self, most):
        count = self.random.randint(1, most)
        return self.random.randint(1, 0xFFFF), self.random.randint(0, 10000 - count), count

    def read_file(self):
        runs, most = self.random.choice(((1, 121), (2, 60), (7, 16), (35, 2)))
        asked = [self.random_run(most) for _ in range(runs)]
        answer = self.send(ReadFileRecordRequest([
            FileRecord(file_number=file, record_number=record, record_length=count) for file, record, count in asked]))
        told = [b"".join(self.held[record_at(file, record + i)].to_bytes(2, "big") for i in range(count))
                for file, record, count in asked]
        self.expect(answer and [record.record_data for record in answer.records] == told, "20 reads", asked)

    def write_file(self):
        runs, most = self.random.choice(((1, 122), (2, 59), (8, 11)))
        records = []
        for _ in range(runs):
            file, record, count = self.random_run(most)
            words = self.words(count)
            records.append(FileRecord(file_number=file, record_number=record,
                                      record_data=b"".join(word.to_bytes(2, "big") for word in words)))
            for i, word in enumerate(words):
                self.held[record_at(file, record + i)] = word
        answer = self.send(WriteFileRecordRequest(records))
        self.expect(answer and answer.records == records, "21 writes", records)

    def mask(self):
        at, and_mask, or_mask = self.start(1), self.word(), self.word()
        answer = self.send(MaskWriteRegisterRequest(at, and_mask, or_mask))
        self.expect(answer and (answer.address, answer.and_mask, answer.or_mask) == (at, and_mask, or_mask), "22 writes")
        self.held[at] = sum((self.held[at] if and_mask >> bit & 1 else or_mask) & 1 << bit for bit in range(16))

    def exchange(self):
        write_at, words, count = self.start(121), self.words(self.count(121)), self.count(125)
        near = max(0, write_at - 60)
        read_at = near if self.random.random() < 0.5 and near + count <= 0x10000 else self.start(count)
        seen = self.ask(self.client.exchange, read_at, count, write_at, words)
        self.held[write_at:write_at + len(words)] = words
        self.expect(seen == self.held[read_at:read_at + count], "23 writes, then reads", read_at, write_at)

    def queue(self):
        at = self.start(32)
        answer = self.send(ReadFifoQueueRequest(at))
        self.expect(answer and answer.values == self.held[at + 1:at + 1 + self.held[at] % 32], "24 reads", at)

    def identification(self):
        access = self.random.randint(1, 4)
        reach = {1: 3, 2: 6, 3: 8, 4: 8}[access]
        first = self.random.randrange(reach)
        answer = self.send(ReadDeviceInformationRequest(read_code=access, object_id=list(OBJECTS)[first]))
        if answer is None:
            return self.expect(False, "43 tells", access, first)
        end = first + 1 if access == 4 else reach
        seen = len(answer.information)
        told = dict(list(OBJECTS.items())[first:first + seen])
        self.expect({number: len(text) for number, text in answer.information.items()} == told, "43 tells", first)
        if answer.more_follows:
            self.expect(first + seen < end and answer.next_object_id == list(OBJECTS)[first + seen], "43 goes on")
        else:
            self.expect(first + seen == end and answer.next_object_id == 0, "43 ends")
        return self.expect(answer.conformity == 0x83, "43 tells its level")


def main(device, count, *functions):
    logging.disable(logging.CRITICAL)
    test = PymodbusAgreement(Client(device))
    test.run(int(count), list(map(int, functions)))
    return test.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
