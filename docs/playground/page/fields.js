// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The fields of a frame, and what bytes are that a person types: as the module tells them.
"use strict";

/// Fields as the decoder of the library gives them.
function fieldsOf(frame) {
  const parts = [];
  frame.readings.forEach((reading) => {
    const list = make("dl");
    const bytes = frame.hex.split(" ");
    for (const field of reading.fields) {
      const hex = bytes.slice(field.offset, field.offset + field.length).join(" ");
      list.append(make("dt", { class: "mono" }, hex), make("dd", {}, field.name), make("dd", {}, field.value));
    }
    parts.push(make("p", {}, make("b", {}, `As a ${reading.as}`)), list);
    if (reading.flaw) parts.push(make("p", { class: "flaw" }, reading.flaw));
  });
  return parts;
}

const judgements = {
  "good": ["good", "A whole frame, and its CRC is right."],
  "crc missing": ["open", "A whole request but for its CRC, which would be "],
  "crc wrong": ["bad", "The CRC is wrong; right is "],
  "not a frame": ["open", "No whole frame yet."],
  "frames": ["good", "Whole frames, and their CRCs are right."],
};

const isGood = (frame) => frame.whole && frame.crc && !frame.readings[0]?.flaw;

function judged(found, text) {
  if (found.flaw) return ["bad", found.flaw];
  if (found.size === 0) return ["", text.trim() === "" ? "Nothing typed yet." : "No byte in it yet."];
  const isMany = found.frames.length > 1 && found.frames.every(isGood);
  const [kind, words] = judgements[isMany ? "frames" : found.kind];
  return [kind, words + found.offer.split(" ").slice(-2).join(" ")];
}
