// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Servers of modbus-serial and jsmodbus whose memory is set and told on the standard input and output, as
// memory_libmodbus.cpp has it. jsmodbus has all addresses up to the last, from 0.
//
//   NODE_PATH=... node memory_npm.js modbus-serial|jsmodbus DEVICE FIRST COUNT [usual]
//
// mbap:1502 for a device: Modbus TCP on that port of this machine.
"use strict";
const readline = require("readline");

const [kind, device, first, count, times] = process.argv.slice(2).map((word) => (/^\d+$/.test(word) ? Number(word) : word));
const lacking = new Set();
const tcp = device.startsWith("mbap:") ? Number(device.slice(5)) : 0;

// For modbus-serial: a function per value, which throws what it refuses.
function ofModbusSerial() {
    const all = {};
    for (const space of ["holding", "input", "coil", "discrete"]) {
        all[space] = new Array(count).fill(0);
    }
    const at = (address) => {
        if (address < first || address >= first + count) {
            throw { modbusErrorCode: 2, message: "no such address" };
        }
        return address - first;
    };
    const refuse = (code) => {
        if (lacking.has(code)) {
            throw { modbusErrorCode: 1, message: "no such function" };
        }
    };
    const writes = (space, code, isArray) => (address, given) => {
        refuse(code);
        const places = (isArray ? given : [given]).map((_, i) => at(address + i)); // all or nothing
        places.forEach((place, i) => (all[space][place] = Number(isArray ? given[i] : given)));
    };
    const { ServerSerial, ServerTCP } = require("modbus-serial");
    const held = {
        getCoil: (address) => all.coil[at(address)] !== 0,
        getDiscreteInput: (address) => all.discrete[at(address)] !== 0,
        getHoldingRegister: (address) => all.holding[at(address)],
        getInputRegister: (address) => all.input[at(address)],
        setCoil: writes("coil", 5, false),
        setCoilArray: writes("coil", 15, true),
        setRegister: writes("holding", 6, false),
        setRegisterArray: writes("holding", 16, true),
    };
    const server = tcp ? new ServerTCP(held, { host: "127.0.0.1", port: tcp, unitID: 1 })
        : new ServerSerial(held, { port: device, baudRate: 115200, unitID: 1, ...(times === "usual" ? {} : { interval: 4 }) });
    return {
        opened: (then) => server.on("initialized", then),
        put: (space, address, word) => (all[space][at(address)] = word),
        held: (space, address) => all[space][at(address)],
    };
}

function ofJsmodbus() {
    const jsmodbus = require("jsmodbus");
    const path = require("path").dirname(require.resolve("jsmodbus"));
    const { ExceptionResponseBody } = require(path + "/response");
    const handler = require(path + "/modbus-server-response-handler.js").default;
    const known = handler.prototype.handle;
    handler.prototype.handle = function (request, answer) {
        if (request && lacking.has(request.body.fc)) {
            const refused = this._fromRequest(request, new ExceptionResponseBody(request.body.fc, 1));
            answer(refused.createPayload());
            return refused;
        }
        return known.call(this, request, answer);
    };
    const memory = {
        holding: Buffer.alloc(2 * (first + count)), input: Buffer.alloc(2 * (first + count)),
        coils: Buffer.alloc((first + count) / 8), discrete: Buffer.alloc((first + count) / 8),
    };
    const port = tcp ? new (require("net").Server)()
        : new (require("serialport").SerialPort)({ path: device, baudRate: 115200 });
    new jsmodbus.server[tcp ? "TCP" : "RTU"](port, memory);
    if (tcp) {
        port.listen(tcp, "127.0.0.1");
    }
    const bits = (space) => (space === "coil" ? memory.coils : memory.discrete);
    const isBits = (space) => space === "coil" || space === "discrete";
    return {
        opened: (then) => port.on(tcp ? "listening" : "open", then),
        put: (space, address, word) => {
            if (!isBits(space)) {
                memory[space].writeUInt16BE(word, 2 * address);
                return;
            }
            const byte = bits(space)[address >> 3];
            bits(space)[address >> 3] = word ? byte | (1 << (address & 7)) : byte & ~(1 << (address & 7));
        },
        held: (space, address) =>
            isBits(space) ? (bits(space)[address >> 3] >> (address & 7)) & 1 : memory[space].readUInt16BE(2 * address),
    };
}

const server = kind === "jsmodbus" ? ofJsmodbus() : ofModbusSerial();

function told(words) {
    if (words[0] === "lack") {
        lacking.clear();
        words.slice(1).forEach((word) => lacking.add(Number(word)));
        return "done";
    }
    const [what, space, address] = [words[0], words[1], Number(words[2])];
    if (what === "set") {
        words.slice(3).forEach((word, i) => server.put(space, address + i, parseInt(word, 16)));
        return "done";
    }
    const all = [];
    for (let i = 0; i < Number(words[3]); ++i) {
        all.push(server.held(space, address + i).toString(16).padStart(4, "0"));
    }
    return all.join(" ");
}

server.opened(() => {
    readline.createInterface({ input: process.stdin }).on("line", (line) => console.log(told(line.trim().split(" "))));
    console.log("ready");
});
