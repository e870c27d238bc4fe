// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module as functions of the page: texts go in and come out as JavaScript's. `moduleText` is the module in base64.
"use strict";

/// The first column of a dump, in any line: digits with a colon, or more digits than the bytes behind them have.
const offsetColumn = /^[ \t]*(?:[0-9a-f]{4,8}:|[0-9a-f]{4}[ \t]{2,}[0-9a-f]|[0-9a-f]{8}[ \t]+[0-9a-f]{2}[ \t])/im;

/// Why a text is not read as bytes at all; empty where it is.
function unreadable(text) {
  const longest = 2000;
  if (text.length > longest) return `${text.length} characters: ${longest} are read at most, and a frame has 256 bytes at most`;
  return offsetColumn.test(text) ? "a line begins with an offset, as in a dump: leave that column out" : "";
}

async function loadModule(moduleText) {
  const bytes = Uint8Array.from(atob(moduleText), (each) => each.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const api = instance.exports;
  api._initialize();
  const textAt = (place) => {
    const memory = new Uint8Array(api.memory.buffer);
    return new TextDecoder().decode(memory.subarray(place, memory.indexOf(0, place)));
  };
  const parsed = (place) => JSON.parse(textAt(place));
  const put = (text) => {
    const input = api.playground_input();
    const bytes = new TextEncoder().encode(text).subarray(0, api.playground_input_size());
    new Uint8Array(api.memory.buffer).set(bytes, input);
    return bytes.length;
  };
  /// A reference as it was typed. A text that is too long to be shown is no number any more.
  const putReference = (typed) => {
    const text = String(typed).trim() || "no", longest = 24;
    return put(text.length > longest ? text.slice(0, longest) + "…" : text);
  };
  return {
    drives: () => parsed(api.playground_drives()),
    open: (drive) => api.playground_open(drive) === 1,
    describe: () => parsed(api.playground_describe()),
    machine: () => parsed(api.playground_machine()),
    run(microseconds) {
      const longest = 1000000;
      for (let left = microseconds; left > 0; left -= longest) api.playground_run(Math.min(left, longest));
    },
    nextFrame: () => api.playground_next_frame(),
    state: () => parsed(api.playground_state()),
    frames: (from) => parsed(api.playground_frames(from)),
    explain: (frame) => parsed(api.playground_explain(frame)),
    mains: (on) => api.playground_mains(on ? 1 : 0),
    cable: (where) => api.playground_cable(where),
    fault: (present) => api.playground_fault(present ? 1 : 0),
    local: (isLocal) => api.playground_local(isLocal ? 1 : 0),
    stopKey: () => api.playground_stop_key(),
    supervised: (is) => api.playground_supervised(is ? 1 : 0),
    start: (reference) => api.playground_start(putReference(reference)),
    change: (reference) => api.playground_change(putReference(reference)),
    stop: (how) => api.playground_stop(how),
    reset: () => api.playground_reset(),
    decode: (text) => unreadable(text) ? { size: 0, flaw: unreadable(text), kind: "", offer: "", frames: [] } : parsed(api.playground_decode(put(text))),
    send: (text) => !unreadable(text) && api.playground_send(put(text)) === 1,
  };
}

if (typeof module !== "undefined") module.exports = { loadModule };
