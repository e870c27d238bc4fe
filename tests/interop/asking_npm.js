// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Clients of modbus-serial and jsmodbus, as asking_libmodbus.cpp; they have no 22 and no 23.
//
//   NODE_PATH=... node asking_npm.js modbus-serial|jsmodbus PORT
"use strict";
const readline = require("readline");

const [kind, port] = [process.argv[2], Number(process.argv[3])];
const bits = (values) => values.map((value) => value !== 0);

async function ofModbusSerial() {
    const client = new (require("modbus-serial"))();
    await client.connectTCP("127.0.0.1", { port });
    client.setID(1);
    client.setTimeout(20000);
    const reads = { 1: "readCoils", 2: "readDiscreteInputs", 3: "readHoldingRegisters", 4: "readInputRegisters" };
    return {
        ask: async (code, address, words) => {
            if (reads[code]) {
                return (await client[reads[code]](address, words[0])).data.slice(0, words[0]).map(Number);
            }
            await { 5: () => client.writeCoil(address, words[0] !== 0), 6: () => client.writeRegister(address, words[0]),
                15: () => client.writeCoils(address, bits(words)), 16: () => client.writeRegisters(address, words) }[code]();
            return [];
        },
        exceptionOf: (error) => error.modbusCode,
        close: () => client.close(() => {}),
    };
}

async function ofJsmodbus() {
    const socket = new (require("net").Socket)();
    const client = new (require("jsmodbus")).client.TCP(socket, 1, 20000);
    await new Promise((resolve, reject) => socket.once("connect", resolve).once("error", reject).connect({ host: "127.0.0.1", port }));
    const reads = { 1: "readCoils", 2: "readDiscreteInputs", 3: "readHoldingRegisters", 4: "readInputRegisters" };
    return {
        ask: async (code, address, words) => {
            if (reads[code]) {
                const found = (await client[reads[code]](address, words[0])).response.body.valuesAsArray;
                return found.slice(0, words[0]).map(Number);
            }
            await { 5: () => client.writeSingleCoil(address, words[0] !== 0), 6: () => client.writeSingleRegister(address, words[0]),
                15: () => client.writeMultipleCoils(address, bits(words)),
                16: () => client.writeMultipleRegisters(address, words) }[code]();
            return [];
        },
        exceptionOf: (error) => error.response && error.response.body && error.response.body.code,
        close: () => socket.end(),
    };
}

(async () => {
    const client = await (kind === "jsmodbus" ? ofJsmodbus() : ofModbusSerial());
    for await (const line of readline.createInterface({ input: process.stdin })) {
        const [code, address, ...words] = line.trim().split(" ").map(Number);
        try {
            console.log(["ok", ...(await client.ask(code, address, words))].join(" "));
        } catch (error) {
            const found = client.exceptionOf(error);
            console.log(found ? `exception ${found}` : `failed ${error.message || JSON.stringify(error)}`);
        }
    }
    client.close();
})();
