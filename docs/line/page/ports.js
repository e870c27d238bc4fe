// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Ends of a line for the worker. Each opens at a bit rate and a format, writes bytes, and tells what comes: `bytes`, `damage`
// (a byte with a wrong parity or stop bit), `lost` (the adapter is gone).
"use strict";

const settingOf = (baud, format) => ({ baudRate: baud, dataBits: 8, parity: { E: "even", O: "odd", N: "none" }[format[1]], stopBits: Number(format[2]), bufferSize: 4096 });

/// An adapter: a port of Web Serial.
class SerialEnd {
  constructor(port) { this.port = port; }

  async open(baud, format, tells) {
    await this.port.open(settingOf(baud, format));
    this.isOpen = true;
    this.writer = this.port.writable.getWriter();
    this.reading = this.read(tells);
  }

  async read(tells) {
    let problem;
    while (this.isOpen && this.port.readable && !problem) {
      this.reader = this.port.readable.getReader();
      try {
        for (let next; !(next = await this.reader.read()).done;) tells.bytes(next.value);
        problem = new Error("the port has ended");
      } catch (why) {
        // After what is a byte's fault the port has a new stream.
        if (["BreakError", "FramingError", "ParityError", "BufferOverrunError"].includes(why.name)) tells.damage();
        else problem = why;
      }
      this.reader.releaseLock();
    }
    if (this.isOpen) this.lose(tells, problem ?? new Error("the port has ended"));
  }

  lose(tells, problem) {
    this.isOpen = false;
    tells.lost(problem.message);
  }

  async write(bytes) { await this.writer.write(bytes); }

  /// Whatever of it is gone already.
  async close() {
    this.isOpen = false;
    await this.reader?.cancel().catch(() => {});
    await this.reading;
    this.writer?.releaseLock();
    await this.port.close().catch(() => {});
  }
}

/// A port that only the page can open: the worker of a file has no ports of its own. Bytes come and go as messages, which no
/// hidden page slows down.
class RelayedEnd {
  constructor(ask) { this.ask = ask; }

  async open(baud, format, tells) {
    this.tells = tells;
    await this.ask("open", { baud, format });
  }
  take(what, value) { this.tells?.[what](value); }
  async write(bytes) { await this.ask("write", { bytes }); }
  async close() {
    this.tells = null;
    await this.ask("close", {});
  }
}

/// The drive and the meter of the module, for who has none. Bytes take the time that they take on a wire.
class SimulatedEnd {
  constructor(units) { this.units = units; }

  async open(baud, format, tells) {
    this.character = 1000 * (format === "8N1" ? 10 : 11) / baud;
    this.units.open(baud, format, performance.now());
    const pass = () => {
      const said = this.units.pass(performance.now());
      if (said.length > 0) setTimeout(() => this.timer && tells.bytes(said), said.length * this.character);
    };
    this.timer = setInterval(pass, 2);
  }
  async write(bytes) {
    setTimeout(() => this.timer && this.units.receive(bytes, performance.now()), bytes.length * this.character);
  }
  async close() {
    clearInterval(this.timer);
    this.timer = null;
  }
}

if (typeof module !== "undefined") module.exports = { SerialEnd, SimulatedEnd, settingOf };
