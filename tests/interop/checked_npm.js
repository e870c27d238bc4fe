// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Clients of modbus-serial and jsmodbus as `rtuwire check --client` starts them.
//
//   NODE_PATH=... node checked_npm.js modbus-serial|jsmodbus PORT TIMEOUT [read UNIT ADDRESS COUNT | write UNIT ADDRESS VALUE]...
"use strict";
const [kind, port, timeout, ...words] = process.argv.slice(2);

async function ofModbusSerial() {
    const ModbusRTU = require("modbus-serial");
    const line = new ModbusRTU();
    await line.connectRTUBuffered(port, { baudRate: 19200 });
    line.setTimeout(Number(timeout));
    return {
        read: async (unit, address, count) => (line.setID(unit), (await line.readHoldingRegisters(address, count)).data),
        write: async (unit, address, value) => (line.setID(unit), line.writeRegister(address, value)),
    };
}

async function ofJsmodbus() {
    const { SerialPort } = require("serialport");
    const { client } = require("jsmodbus");
    const line = new SerialPort({ path: port, baudRate: 19200, autoOpen: false });
    const units = new Map();
    const of = (unit) => units.get(unit) ?? units.set(unit, new client.RTU(line, unit, Number(timeout))).get(unit);
    of(1); // it listens from here on
    await new Promise((resolve, reject) => line.open((why) => (why ? reject(why) : resolve())));
    return {
        read: async (unit, address, count) => (await of(unit).readHoldingRegisters(address, count)).response.body.valuesAsArray,
        write: async (unit, address, value) => of(unit).writeSingleRegister(address, value),
    };
}

async function main() {
    const line = await (kind === "jsmodbus" ? ofJsmodbus() : ofModbusSerial());
    for (let at = 0; at + 4 <= words.length; at += 4) {
        try {
            const answer = await line[words[at]](...words.slice(at + 1, at + 4).map(Number));
            console.log(words[at] === "read" ? answer.join(" ") : "ok");
        } catch (why) {
            console.log("error:", why.message ?? why.err ?? why);
        }
    }
    process.exit(0);
}

main();
