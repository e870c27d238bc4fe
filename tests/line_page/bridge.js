// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Between the pages' ports and pseudo-terminals: a web socket server of a few lines, and what an adapter does to bytes: lumps,
// delay, loss, an echo, a wrong bit rate, a cable that is pulled. It keeps all that a page sent.
"use strict";
const { execFileSync } = require("node:child_process");
const crypto = require("node:crypto");
const fs = require("node:fs");
const http = require("node:http");
const tty = require("node:tty");

/// The CRC of a frame without it.
function crcOf(bytes) {
  let crc = 0xFFFF;
  for (const each of bytes) {
    crc ^= each;
    for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
  }
  return crc;
}
const frameOf = (...bytes) => Buffer.from([...bytes, crcOf(bytes) & 255, crcOf(bytes) >> 8]);

/// A unit without a terminal, which answers to every address. It has input registers only, `words` from address 0 on, else each holds
/// its own address. `answers` says how a response comes: [[milliseconds, bytes], ...].
class Unit {
  constructor(words = []) {
    this.words = words;
    this.owes = 0; ///< responses that are still to come
    this.answers = (response) => [[5, response]];
  }

  take(request, bring) {
    for (const [later, bytes] of this.answers(this.response(request), request)) {
      ++this.owes;
      setTimeout(() => { --this.owes; bring(bytes); }, later);
    }
  }
  response(request) {
    const [unit, code] = request;
    if (code !== 4) return frameOf(unit, code | 0x80, code === 3 ? 2 : 1);
    const start = request.readUInt16BE(2), count = request.readUInt16BE(4);
    const words = Array.from({ length: count }, (_, at) => this.words[start + at] ?? start + at);
    return frameOf(unit, code, 2 * count, ...words.flatMap((word) => [word >> 8, word & 255]));
  }
}

/// What a page sent, and how it is answered.
class Adapter {
  constructor(device, setting) {
    this.device = device;
    this.setting = setting; ///< "19200,8,even,1"; empty: any
    this.sent = [];
    this.opened = [];
    this.echoes = false;
    this.lumps = 0; ///< milliseconds for which bytes are kept back
    this.delay = 0; ///< milliseconds by which all comes later
    this.loses = 0; ///< of so many bytes one, drawn
    this.refuses = []; ///< settings that it does not open at
    this.isPlugged = true;
    this.seed = 1;
    if (typeof device !== "string") return;
    execFileSync("stty", ["-F", device, "raw", "-echo"]);
    // The flag keeps a terminal from becoming this process's own.
    this.file = fs.openSync(device, fs.constants.O_RDWR | fs.constants.O_NOCTTY | fs.constants.O_NONBLOCK);
    this.stream = new tty.ReadStream(this.file);
    this.stream.on("data", (bytes) => this.bring(bytes));
    this.stream.on("error", () => {});
  }

  get isRight() { return this.setting === "" || this.setting === this.now; }

  get isTaken() { return Boolean(this.socket && !this.socket.isOver); }

  open(socket, setting) {
    this.socket = socket;
    this.held = null;
    this.now = setting;
    this.opened.push({ setting, at: Date.now() });
  }

  /// From the line to the page. Bytes of another rate are other bytes.
  bring(bytes) {
    const heard = this.lose(this.isRight ? bytes : Buffer.from(bytes.map((each) => each & 0xF0 | 0x80)));
    this.held = Buffer.concat([this.held ?? Buffer.alloc(0), heard]);
    if (this.lumps + this.delay === 0) return this.hand();
    this.timer ??= setTimeout(() => this.hand(), this.lumps + this.delay);
  }
  lose(bytes) {
    if (this.loses === 0) return bytes;
    return Buffer.from([...bytes].filter(() => { this.seed = (this.seed * 1103515245 + 12345) % 2147483648; return Math.floor(this.seed / 2147483648 * this.loses) !== 0; }));
  }
  hand() {
    this.timer = null;
    if (this.isPlugged && this.held?.length) this.socket?.send(this.held);
    this.held = null;
  }

  take(bytes) {
    this.sent.push({ bytes: Buffer.from(bytes), at: Date.now() });
    if (this.echoes) this.bring(bytes);
    if (!this.isPlugged || !this.isRight) return;
    if (typeof this.device === "string") fs.writeSync(this.file, this.lose(bytes));
    else if (this.lose(bytes).length === bytes.length) this.device.take(Buffer.from(bytes), (answer) => this.bring(answer));
  }

  /// A client of others, or noise.
  inject(bytes) { this.bring(Buffer.from(bytes)); }
  damage() { this.socket?.sendText("ParityError"); }
  pull() {
    this.isPlugged = false;
    this.socket?.end();
    this.socket = null;
  }
  plug() { this.isPlugged = true; }
  close() { this.stream?.destroy(); }
}

class WebSocketEnd {
  constructor(stream, take) {
    this.stream = stream;
    this.buffer = Buffer.alloc(0);
    stream.on("data", (bytes) => { this.buffer = Buffer.concat([this.buffer, bytes]); this.read(take); });
    stream.on("error", () => {});
    stream.on("close", () => { this.isOver = true; });
  }

  read(take) {
    for (;;) {
      if (this.buffer.length < 6) return;
      const [first, second] = this.buffer;
      let size = second & 127, at = 2;
      if (size === 126) { size = this.buffer.readUInt16BE(2); at = 4; }
      if (this.buffer.length < at + 4 + size) return;
      const mask = this.buffer.subarray(at, at + 4);
      const bytes = Buffer.from(this.buffer.subarray(at + 4, at + 4 + size).map((each, place) => each ^ mask[place % 4]));
      this.buffer = this.buffer.subarray(at + 4 + size);
      const kind = first & 15;
      if (kind === 8) { this.isOver = true; this.frame(8, bytes); this.stream.end(); return; }
      if (kind === 2) take(bytes);
    }
  }

  frame(kind, bytes) {
    const head = bytes.length < 126 ? Buffer.from([0x80 | kind, bytes.length]) : Buffer.from([0x80 | kind, 126, bytes.length >> 8, bytes.length & 255]);
    if (!this.stream.destroyed) this.stream.write(Buffer.concat([head, bytes]));
  }
  send(bytes) { this.frame(2, bytes); }
  sendText(text) { this.frame(1, Buffer.from(text)); }
  end() { this.stream.destroy(); }
}

/// Adapters by name; where the pages find them.
async function makeBridge(adapters) {
  const server = http.createServer((_, response) => response.writeHead(404).end());
  server.on("upgrade", (request, stream) => {
    const [name, setting] = request.url.slice(1).split("?");
    const adapter = adapters[name];
    if (!adapter?.isPlugged || adapter.isTaken || adapter.refuses.includes(setting)) return stream.destroy();
    const key = crypto.createHash("sha1").update(request.headers["sec-websocket-key"] + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest("base64");
    stream.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\n\r\n`);
    stream.setNoDelay(true);
    const socket = new WebSocketEnd(stream, (bytes) => adapter.take(bytes));
    adapter.open(socket, setting);
    return socket;
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { place: `ws://127.0.0.1:${server.address().port}`, close: () => { server.close(); server.closeAllConnections(); } };
}

/// A frame as the specification has it, read without any of our code: why it is no read; empty where it is one.
function whyNoRead(bytes) {
  if (bytes.length < 4 || bytes.readUInt16LE(bytes.length - 2) !== crcOf(bytes.subarray(0, -2))) return "no whole frame";
  if (bytes[0] < 1 || bytes[0] > 247) return `address ${bytes[0]}`;
  if ([1, 2, 3, 4].includes(bytes[1])) return bytes.length === 8 ? "" : "length";
  return bytes[1] === 0x2B && bytes[2] === 0x0E && bytes.length === 7 ? "" : `function ${bytes[1]}`;
}

module.exports = { Adapter, Unit, frameOf, makeBridge, whyNoRead };
