// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a screen reader announces: how orders end, and what changes for the motor, each change once; never single frames.
"use strict";

/// What is told when it changes; an empty text is not told.
const tellings = [
  ({ drive }) => drive.fault && `The drive trips: ${drive.fault}`,
  ({ drive }) => drive.on ? "" : "The drive has no mains",
  ({ drive }) => drive.local ? "Somebody took the drive over at its keypad" : "",
  ({ client }) => client.rounds === 0 ? "" : client.linked ? "The client reads the drive" : "The client gets no answers",
  ({ client }) => client.order === "given up" ? "The client has given its order up" : "",
  ({ drive }) => `Motor: ${motorText(drive)}`,
];

class Announcer {
  constructor() {
    this.toSay = [];
    this.clear();
  }

  /// Begins anew, with another drive.
  clear() { this.told = null; this.ended = new Set(); }

  note(state) {
    for (const each of state.orders) {
      if (each.ending === 0 || this.ended.has(each.number)) continue;
      this.ended.add(each.number);
      this.say(`${each.what}: ${each.outcome}`);
    }
    const before = this.told;
    this.told = tellings.map((tell) => tell(state));
    if (before) this.told.forEach((text, at) => { if (text !== "" && text !== before[at]) this.say(text); });
  }

  say(text) { this.toSay.push(text); }

  /// Adds all that was to be said to a log, whose additions are read one after the other: none takes another's place.
  announce() {
    const log = byId("said"), most = 20;
    log.append(...this.toSay.map((text) => make("p", {}, text)));
    this.toSay = [];
    while (log.children.length > most) log.firstChild.remove();
  }
}
