// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Between the pages' ports and pseudo-terminals: a web socket server of a few lines, and what an adapter does to bytes: lumps,
// an echo, a wrong bit rate, a cable that is pulled. It keeps all that a page sent.
"use strict";
const { execFileSync } = require("node:child_process");
const crypto = require("node:crypto");
const fs = require("node:fs");
const http = require("node:http");
const tty = require("node:tty");

/// What a page sent, and how it is answered.
class Adapter {
  constructor(device, setting) {
    this.device = device;
    this.setting = setting; ///< "19200,8,even,1"; empty: any
    this.sent = [];
    this.opened = [];
    this.echoes = false;
    this.lumps = 0; ///< milliseconds for which bytes are kept back
    this.isPlugged = true;
    execFileSync("stty", ["-F", device, "raw", "-echo"]);
    // The flag keeps a terminal from becoming this process's own.
    this.file = fs.openSync(device, fs.constants.O_RDWR | fs.constants.O_NOCTTY | fs.constants.O_NONBLOCK);
    this.stream = new tty.ReadStream(this.file);
    this.stream.on("data", (bytes) => this.bring(bytes));
    this.stream.on("error", () => {});
  }

  get isRight() { return this.setting === "" || this.setting === this.now; }

  open(socket, setting) {
    this.socket = socket;
    this.now = setting;
    this.opened.push({ setting, at: Date.now() });
  }

  /// From the line to the page. Bytes of another rate are other bytes.
  bring(bytes) {
    const heard = this.isRight ? bytes : Buffer.from(bytes.map((each) => each & 0xF0 | 0x80));
    this.held = Buffer.concat([this.held ?? Buffer.alloc(0), heard]);
    if (this.lumps === 0) return this.hand();
    this.timer ??= setTimeout(() => this.hand(), this.lumps);
  }
  hand() {
    this.timer = null;
    if (this.isPlugged && this.held?.length) this.socket?.send(this.held);
    this.held = null;
  }

  take(bytes) {
    this.sent.push({ bytes: Buffer.from(bytes), at: Date.now() });
    if (this.echoes) this.bring(bytes);
    if (this.isPlugged && this.isRight) fs.writeSync(this.file, bytes);
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
  close() { this.stream.destroy(); }
}

class WebSocketEnd {
  constructor(stream, take) {
    this.stream = stream;
    this.buffer = Buffer.alloc(0);
    stream.on("data", (bytes) => { this.buffer = Buffer.concat([this.buffer, bytes]); this.read(take); });
    stream.on("error", () => {});
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
      if (kind === 8) { this.frame(8, bytes); this.stream.end(); return; }
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
    if (!adapter?.isPlugged) return stream.destroy();
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
  let crc = 0xFFFF;
  for (const each of bytes.subarray(0, -2)) {
    crc ^= each;
    for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
  }
  if (bytes.length < 4 || bytes.readUInt16LE(bytes.length - 2) !== crc) return "no whole frame";
  if (bytes[0] < 1 || bytes[0] > 247) return `address ${bytes[0]}`;
  if ([1, 2, 3, 4].includes(bytes[1])) return bytes.length === 8 ? "" : "length";
  return bytes[1] === 0x2B && bytes[2] === 0x0E && bytes.length === 7 ? "" : `function ${bytes[1]}`;
}

module.exports = { Adapter, makeBridge, whyNoRead };
