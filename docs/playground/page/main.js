// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Joins the parts: time, controls, views.
"use strict";

/// A frame of another page shows the line, the orders and what happens, and leads to all the rest.
const isSmall = new URLSearchParams(location.search).has("small");
document.documentElement.classList.toggle("small", isSmall);

/// The page is seen before the module is made.
requestAnimationFrame(() => setTimeout(async () => {
  let engine;
  try {
    engine = await loadModule(moduleText);
  } catch (problem) {
    document.body.prepend(make("p", { class: "trap", role: "alert" }, `The module does not start here: ${problem.message}`));
    return;
  }
  const machine = new MachineView(), curves = new CurvesView(), scene = new SceneView(), announcer = new Announcer();
  const log = new LogView(engine), decode = new DecodeView(engine, announcer, (bytes) => act("send", bytes));
  let isPaused = false, speed = 1, last = null, owed = 0, done = [];

  function show() {
    const state = engine.state();
    log.take();
    const recent = log.frames.slice(-60);
    showControls(state.drive);
    scene.turn(state);
    scene.show(state, recent);
    machine.show(state.drive);
    curves.note(state);
    curves.draw(state.time);
    drawStrip(recent, state, speed);
    announcer.note(state);
    announcer.announce();
    setText("time", seconds(state.time));
    setText("v-frequency", hertz(state.drive.frequency));
    setText("v-reference", (state.drive.reference / 10).toFixed(1) + " Hz");
    setText("v-client", state.client.linked ? (state.client.frequency / 10).toFixed(1) + " Hz" : "–");
    setText("v-current", state.drive.on ? state.drive.current : "–");
    setText("v-status", state.drive.on ? state.drive.status : "–");
    setText("v-command", state.drive.on ? state.drive.command : "–");
    setText("v-bits", state.drive.on ? `Status: ${state.drive.statusText}` : "");
  }

  /// The controls show what the module says of the drive, not what was pressed last: a loss of mains takes settings back.
  function showControls(drive) {
    press("mains", drive.on);
    press("fault", drive.cause);
    press("local", drive.local);
    byId("supervised").checked = drive.supervised;
    for (const id of ["local", "key", "supervised"]) byId(id).disabled = !drive.on;
    const mayTurn = drive.power || drive.shaft !== 0;
    byId("drive").disabled = mayTurn;
    setText("drive-note", mayTurn ? "Another type can be chosen once the motor stands without power." : "");
  }

  function trapped(problem) {
    isPaused = true;
    document.body.prepend(make("p", { class: "trap", role: "alert" }, `The module stopped: ${problem.message}. Reload the page.`));
  }

  function tick(now) {
    const passed = last === null ? 0 : Math.min(now - last, 100);
    last = now;
    try {
      if (!isPaused) {
        owed += passed * 1000 * speed;
        const whole = Math.floor(owed);
        owed -= whole;
        engine.run(whole);
        show();
      }
      requestAnimationFrame(tick);
    } catch (problem) { trapped(problem); }
  }

  /// What a person can do to drive, client and line, by the names that an address has for it.
  const acts = {
    power: (value) => engine.mains(value === "1"),
    fault: (value) => engine.fault(value === "1"),
    local: (value) => engine.local(value === "1"),
    key: () => engine.stopKey(),
    supervised: (value) => engine.supervised(value === "1"),
    start: (value) => engine.start(value),
    change: (value) => engine.change(value),
    stop: (value) => engine.stop(Number(value)),
    reset: () => engine.reset(),
    cable: (value) => engine.cable(Number(value)),
    send: (value) => engine.send(value),
  };
  function act(name, value = "") {
    const text = typeof value === "boolean" ? String(Number(value)) : String(value);
    done.push([engine.state().time, name, text]);
    return acts[name](text);
  }

  /// Something a person does; shown at once, even while time stands.
  const on = (id, event, act) => byId(id).addEventListener(event, (how) => { act(how); show(); });
  const press = (id, isOn) => byId(id).setAttribute("aria-pressed", String(isOn));
  const toggle = (id, act) => on(id, "click", () => act(byId(id).getAttribute("aria-pressed") !== "true"));
  /// What was typed, as it is: the module refuses what is no number, the drive's register what it cannot hold.
  const typed = () => byId("hertz").value.trim();
  const followTyped = () => { if (isNumber(typed())) byId("slider").value = typed(); };
  function reverse() {
    if (!isNumber(typed())) return;
    byId("hertz").value = typed().startsWith("-") ? typed().slice(1) : "-" + typed();
    followTyped();
  }

  /// A browser that comes back to the page restores its inputs; the drive begins anew, and they with it.
  function restoreInputs() {
    for (const each of document.querySelectorAll("input, textarea")) {
      if (["checkbox", "radio"].includes(each.type)) each.checked = each.defaultChecked;
      else each.value = each.defaultValue;
    }
    for (const each of document.querySelectorAll("option")) each.selected = each.defaultSelected;
  }

  function open(index) {
    engine.open(index);
    done = [];
    byId("drive").value = String(index);
    document.querySelector("input[name=cable][value='0']").checked = true;
    const drive = engine.describe();
    setText("p-name", drive.name.toUpperCase().replace("_", " "));
    byId("how").replaceChildren(...drive.stops.map((each) => make("option", { value: each.id }, each.name)));
    setText("how-note", drive.coasts ? "Until a start has checked the drive, every stop sends 0000, as another word might run it: the motor coasts." : "");
    for (const view of [curves, scene, log, announcer]) view.clear();
    machine.draw(engine.machine());
    decode.setExamples(drive);
    show();
  }

  /// Lets time pass; the last of it is seen in the curves.
  function pass(microseconds, note) {
    const step = 20000, unseen = Math.max(0, microseconds - curveSpan);
    if (unseen > 0) engine.run(unseen);
    for (let left = microseconds - unseen; left > 0; left -= step) {
      engine.run(Math.min(left, step));
      note(engine.state());
    }
  }

  /// The state that the address has, or the first one; an address that is wrong is told, and nothing of it done.
  function openAddress() {
    let state = { drive: engine.drives().length - 1, acts: [], time: 0 };
    setText("shared", "");
    try {
      if (location.hash.length > 1) state = readState(location.hash.slice(1), engine.drives());
    } catch (problem) { setText("shared", `The address has no state that this page can open: ${problem.message}.`); }
    open(state.drive);
    const until = (time) => pass(time - engine.state().time, (each) => curves.note(each));
    for (const [time, name, value] of state.acts) {
      until(time);
      act(name, value);
      if (["start", "change"].includes(name)) { byId("hertz").value = value; followTyped(); }
      if (name === "stop") byId("how").value = value;
      if (name === "cable") for (const each of document.querySelectorAll("input[name=cable]")) each.checked = each.value === value;
    }
    until(state.time);
    show();
  }

  /// The address of what is seen now, into the clipboard; where that is refused it stands above the page.
  async function share() {
    const text = writeState(engine.drives()[Number(byId("drive").value)], done, engine.state().time);
    if (text === "") {
      setText("shared", "Too much has happened for an address: open a drive anew.");
      return;
    }
    history.replaceState(null, "", `#${text}`);
    const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    setText("shared", copied ? "Copied. Whoever opens this address sees the same." : "The address of this state stands above the page: copy it there.");
  }

  restoreInputs();
  byId("drive").replaceChildren(...engine.drives().map((name, at) => make("option", { value: at }, name.toUpperCase().replace("_", " "))));
  on("drive", "change", (event) => open(Number(event.target.value)));
  toggle("mains", (isOn) => act("power", isOn));
  toggle("fault", (isOn) => act("fault", isOn));
  toggle("local", (isOn) => act("local", isOn));
  on("key", "click", () => act("key"));
  on("supervised", "change", (event) => act("supervised", event.target.checked));
  on("start", "click", () => act("start", typed()));
  on("change", "click", () => act("change", typed()));
  on("reverse", "click", () => { reverse(); act("change", typed()); });
  on("stop", "click", () => act("stop", byId("how").value));
  on("reset", "click", () => act("reset"));
  on("cable", "change", (event) => act("cable", event.target.value));
  on("slider", "input", (event) => { byId("hertz").value = event.target.value; });
  on("hertz", "input", followTyped);
  toggle("pause", pause);
  on("speed", "change", (event) => { speed = Number(event.target.value); });
  on("frame", "click", () => { pause(true); engine.nextFrame(); });
  on("second", "click", () => pass(1000000, (state) => { curves.note(state); announcer.note(state); }));
  byId("share").addEventListener("click", share);
  function pause(isOn) { isPaused = isOn; press("pause", isOn); }
  addEventListener("resize", () => show());
  addEventListener("hashchange", openAddress);
  const showAddress = () => { byId("whole").href = `index.html#${writeState(engine.drives()[Number(byId("drive").value)], done, engine.state().time)}`; };
  for (const event of ["pointerdown", "focus"]) byId("whole").addEventListener(event, showAddress);

  openAddress();
  document.documentElement.dataset.ready = "yes";
  requestAnimationFrame(tick);
}));
