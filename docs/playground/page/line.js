// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The frames as a table, and bytes that a person types.
"use strict";

class LogView {
  constructor(engine) {
    this.engine = engine;
    this.body = byId("frames").tBodies[0];
    byId("hide").addEventListener("change", () => this.redraw());
    this.clear();
  }

  clear() {
    this.frames = [];
    this.next = 0;
    this.chosen = null;
    this.body.replaceChildren();
    byId("detail").replaceChildren(make("p", { class: "quiet" }, "Choose a frame in the table."));
  }

  /// Whether the like of it was among the last frames: a drive that is watched says the same again and again.
  isNews(frame, at) {
    const alike = (other) => other.summary === frame.summary && other.from === frame.from && other.lost === frame.lost;
    return !this.frames.slice(Math.max(0, at - 14), at).some(alike);
  }

  take() {
    const fresh = this.engine.frames(this.next);
    if (fresh.length === 0) return;
    this.next = fresh[fresh.length - 1].number + 1;
    for (const frame of fresh) {
      this.frames.push(frame);
      this.showRow(frame, this.frames.length - 1);
    }
    this.frames.splice(0, Math.max(0, this.frames.length - 400));
  }

  redraw() {
    this.body.replaceChildren();
    this.frames.forEach((frame, at) => this.showRow(frame, at));
  }

  showRow(frame, at) {
    if (byId("hide").checked && !this.isNews(frame, at)) return;
    const note = frame.lost ? (frame.from === "drive" ? "lost in the cable: " : "does not reach the drive: ") : "";
    const choose = make("button", { type: "button" }, note + frame.summary);
    const kind = frame.unanswered || frame.lost ? "none" : frame.exception || frame.damaged ? "bad" : "";
    const row = make("tr", { class: kind, "data-number": frame.number },
      make("td", { class: "t mono" }, seconds(frame.end)),
      make("td", { class: "from " + frame.from }, frame.unanswered ? "" : frame.from),
      make("td", { class: "hex" }, frame.hex), make("td", {}, choose));
    choose.addEventListener("click", () => this.choose(frame.number, row));
    this.body.prepend(row);
    this.forget();
  }

  /// Keeps the newest rows, and the one that a keyboard stands on.
  forget() {
    const most = 150, rows = this.body.rows;
    for (let at = rows.length - 1; at > 0 && rows.length > most; --at) {
      if (!rows[at].contains(document.activeElement)) rows[at].remove();
    }
  }

  choose(number, row) {
    for (const each of this.body.querySelectorAll(".chosen")) each.classList.remove("chosen");
    row.classList.add("chosen");
    const frames = this.engine.explain(number).frames;
    byId("detail").replaceChildren(...(frames.length ? frames.flatMap(fieldsOf)
      : [make("p", { class: "quiet" }, "It is too old: its fields are not kept.")]));
  }
}

class DecodeView {
  constructor(engine, announcer, send) {
    this.engine = engine;
    byId("bytes").addEventListener("input", () => { byId("example").value = ""; this.show(); });
    byId("offer").addEventListener("click", () => { byId("bytes").value = this.offer; this.show(); byId("bytes").focus(); });
    byId("send").addEventListener("click", () => {
      const isTaken = send(byId("bytes").value);
      setText("sent", isTaken ? "Your bytes leave as soon as the line is free." : "Not sent: your bytes before these still wait for a free line.");
      announcer.say(byId("sent").textContent);
      announcer.announce();
    });
    byId("example").addEventListener("change", (event) => {
      if (event.target.value) { byId("bytes").value = event.target.value; this.show(); }
    });
  }

  /// Requests without a CRC, for the addresses of this drive.
  setExamples(drive) {
    const word = (value) => [value >> 8, value & 255].map((each) => each.toString(16).padStart(2, "0").toUpperCase()).join(" ");
    const examples = [
      ["read the status word", `01 03 ${word(drive.eta)} 00 01`],
      ["write the control word: shutdown", `01 06 ${word(drive.cmd)} 00 06`],
      ["a register that is not there", "01 03 FF F0 00 01"],
      ["a wrong CRC", `01 03 ${word(drive.eta)} 00 01 00 00`],
      ["identify yourself", "01 2B 0E 01 00"],
    ];
    byId("example").replaceChildren(make("option", { value: "" }, "Examples…"),
      ...examples.map(([name, hex]) => make("option", { value: hex }, name)));
    this.show();
  }

  show() {
    const found = this.engine.decode(byId("bytes").value);
    this.offer = found.offer;
    const [kind, text] = judged(found, byId("bytes").value);
    byId("judged").className = "judged " + kind;
    byId("judged").textContent = text;
    byId("offer").disabled = found.offer === "";
    byId("send").disabled = found.size === 0;
    setText("sent", "");
    byId("typed").replaceChildren(...(found.size ? found.frames.flatMap(fieldsOf) : []));
  }
}
