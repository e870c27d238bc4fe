// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module as functions of the worker: bytes, texts and times go in, bytes and what JSON says come out. `moduleText` is the
// module in base64.
"use strict";

const formatNames = ["8E1", "8N1", "8O1", "8N2", "8E2", "8O2"];

async function loadLine(moduleText) {
  const code = Uint8Array.from(atob(moduleText), (each) => each.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(code, {});
  const api = instance.exports;
  api._initialize();
  const memory = () => new Uint8Array(api.memory.buffer);
  const textAt = (place) => new TextDecoder().decode(memory().subarray(place, memory().indexOf(0, place)));
  const parsed = (place) => JSON.parse(textAt(place));
  const output = (size) => memory().slice(api.line_output(), api.line_output() + size);
  const put = (bytes) => {
    const kept = bytes.subarray(0, api.line_input_size());
    memory().set(kept, api.line_input());
    return kept.length;
  };
  const putText = (text) => {
    const bytes = new TextEncoder().encode(text);
    if (bytes.length > api.line_input_size()) throw new RangeError(`${bytes.length} bytes of text: at most ${api.line_input_size()} go at once`);
    return put(bytes);
  };
  /// In pieces that fit the input.
  const inPieces = (bytes, take) => {
    for (let at = 0; at < bytes.length; at += api.line_input_size()) take(put(bytes.subarray(at)));
  };
  const format = (name) => Math.max(0, formatNames.indexOf(name));
  return {
    open: (baud, name, now) => api.line_open(baud, format(name), now, Date.now()),
    set: (baud, name, now) => api.line_set(baud, format(name), now),
    receive: (bytes, now) => inPieces(bytes, (size) => api.line_receive(size, now)),
    receiveError: (now) => api.line_receive_error(now),
    pass: (now) => output(api.line_pass(now)),
    sent: (now) => api.line_sent(now),
    timeLeft: () => api.line_time_left(),
    events: () => parsed(api.line_events()),
    listen: () => api.line_listen(),
    stop: () => api.line_stop(),
    setTimeout: (milliseconds) => api.line_set_timeout(milliseconds),
    scan: (first, last) => api.line_scan(first, last),
    identify: (unit) => api.line_identify(unit),
    consent: (unit) => api.line_consent(unit),
    watch: (unit, points, period, most = 0) => {
      const [word] = textAt(api.line_watch(unit, putText(points), period, most)).split("\t");
      return word && `'${word}' names nothing here: type a name from the list, an address (3201), or a place such as input:1000:f32, holding:40-43:i16, coil:0-7. ` +
        "Types: u16 i16 u32 i32 u64 i64 f32 f64 bcd16 bcd32 hex bits text8; then the order of the bytes: abcd, cdab, badc, dcba";
    },
    backUp: (unit, time) => api.line_back_up(unit, putText(time)),
    file: () => textAt(api.line_file()),
    capture: () => output(api.line_capture()),
    frames: (from) => parsed(api.line_frames(from)),
    explain: (frame) => parsed(api.line_explain(frame)),
    decode: (text, drive) => parsed(api.line_decode(putText(text), drive)),
    registers: (unit) => parsed(api.line_registers(unit)),
    simulated: {
      open: (baud, name, now) => api.sim_open(baud, format(name), now),
      receive: (bytes, now) => inPieces(bytes, (size) => api.sim_receive(size, now)),
      pass: (now) => output(api.sim_pass(now)),
    },
  };
}

if (typeof module !== "undefined") module.exports = { loadLine, formatNames };
