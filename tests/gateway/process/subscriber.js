// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A subscriber that nobody here wrote: mqtt of npm, of both versions of the protocol. It connects again by itself.
//
//   node subscriber.js PORT SECONDS 4|5
const mqtt = require('mqtt');
const [port, seconds, protocolVersion] = process.argv.slice(2).map(Number);
const client = mqtt.connect({ host: '127.0.0.1', port, protocolVersion, reconnectPeriod: 200 });
client.on('connect', () => client.subscribe(['rtuwire/#', 'homeassistant/#'], () => console.log(JSON.stringify({ ready: true }))));
client.on('message', (topic, payload, packet) => console.log(JSON.stringify(
    { arrived: Date.now() / 1000, topic, payload: payload.toString(), retained: packet.retain, qos: packet.qos })));
setTimeout(() => client.end(true, () => process.exit(0)), seconds * 1000);
