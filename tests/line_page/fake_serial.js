// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A `navigator.serial` of the tests, in the page and in its worker: a port's bytes go through a web socket to the test's
// process, which knows a pseudo-terminal. It behaves as Web Serial does: a stream that ends with an error has a successor where
// the error is a byte's, and none where the adapter is gone.
"use strict";

function fakeSerial(bridge, names) {
  class FakePort extends EventTarget {
    constructor(name) {
      super();
      this.name = name;
      this.readable = this.writable = null;
    }

    async open({ baudRate, dataBits, parity, stopBits }) {
      if (this.socket) throw new DOMException("The port is already open.", "InvalidStateError");
      const socket = new WebSocket(`${bridge}/${this.name}?${baudRate},${dataBits},${parity},${stopBits}`);
      socket.binaryType = "arraybuffer";
      await new Promise((resolve, reject) => {
        socket.onopen = resolve;
        socket.onerror = () => reject(new DOMException("Failed to open serial port.", "NetworkError"));
      });
      this.socket = socket;
      this.beginStream();
      this.writable = new WritableStream({ write: (chunk) => { socket.send(chunk); } });
      socket.onmessage = ({ data }) => typeof data === "string" ? this.fail(data) : this.controller?.enqueue(new Uint8Array(data));
      socket.onclose = () => this.socket === socket && this.fail("NetworkError");
    }

    beginStream() {
      this.readable = new ReadableStream({
        start: (controller) => { this.controller = controller; },
        cancel: () => { this.controller = null; },
      });
    }

    fail(name) {
      const failed = this.controller;
      const isLost = name === "NetworkError";
      if (isLost) {
        this.readable = this.writable = this.controller = null;
        this.socket = null;
      } else {
        this.beginStream();
      }
      failed?.error(new DOMException(isLost ? "The device has been lost." : "A byte is damaged.", name));
    }

    getInfo() { return {}; }

    async close() {
      const socket = this.socket;
      this.socket = this.readable = this.writable = this.controller = null;
      if (!socket || socket.readyState > 1) return;
      await new Promise((resolve) => { socket.onclose = resolve; socket.close(); });
    }
  }

  const serial = new EventTarget();
  serial.ports = names.map((name) => new FakePort(name));
  serial.getPorts = async () => serial.ports;
  serial.requestPort = async () => {
    const { name } = serial.choice ?? { name: names[0] };
    if (!name) throw new DOMException("No port selected by the user.", "NotFoundError");
    return serial.ports.find((each) => each.name === name);
  };
  /// An adapter is plugged in again: its port tells, and the event comes up to here.
  serial.plug = (name) => {
    const event = new Event("connect");
    Object.defineProperty(event, "target", { value: serial.ports.find((each) => each.name === name) });
    serial.dispatchEvent(event);
  };
  Object.defineProperty(navigator, "serial", { value: serial, configurable: true });
}

/// What runs in the page before its own scripts: `inWorker` says whether the worker has ports, too.
function installFakeSerial({ fake, bridge, names, inWorker }) {
  (0, eval)(fake);
  globalThis.fakeSerial(bridge, names);
  // The worker is made of a text, which a Blob takes: what it needs goes before that. A worker of a file imports no script.
  const before = inWorker ? `${fake}\nfakeSerial(${JSON.stringify(bridge)}, ${JSON.stringify(names)});\n`
    : "Object.defineProperty(navigator, 'serial', { value: undefined });\n";
  const Real = globalThis.Blob;
  globalThis.Blob = class extends Real {
    constructor(parts, options) { super(options?.type === "text/javascript" ? [before, ...parts] : parts, options); }
  };
}

if (typeof module !== "undefined") {
  module.exports = { installFakeSerial, fakeText: fakeSerial.toString() + "\nglobalThis.fakeSerial = fakeSerial;" };
}
