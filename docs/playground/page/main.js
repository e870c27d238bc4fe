// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Joins the parts: time, controls, views.
"use strict";

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
  const log = new LogView(engine), decode = new DecodeView(engine, announcer);
  let isPaused = false, speed = 1, last = null, owed = 0;

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

  restoreInputs();
  byId("drive").replaceChildren(...engine.drives().map((name, at) => make("option", { value: at }, name.toUpperCase().replace("_", " "))));
  byId("drive").value = String(engine.drives().length - 1);
  on("drive", "change", (event) => open(Number(event.target.value)));
  toggle("mains", (isOn) => engine.mains(isOn));
  toggle("fault", (isOn) => engine.fault(isOn));
  toggle("local", (isOn) => engine.local(isOn));
  on("key", "click", () => engine.stopKey());
  on("supervised", "change", (event) => engine.supervised(event.target.checked));
  on("start", "click", () => engine.start(typed()));
  on("change", "click", () => engine.change(typed()));
  on("reverse", "click", () => { reverse(); engine.change(typed()); });
  on("stop", "click", () => engine.stop(Number(byId("how").value)));
  on("reset", "click", () => engine.reset());
  on("cable", "change", (event) => engine.cable(Number(event.target.value)));
  on("slider", "input", (event) => { byId("hertz").value = event.target.value; });
  on("hertz", "input", followTyped);
  toggle("pause", pause);
  on("speed", "change", (event) => { speed = Number(event.target.value); });
  on("frame", "click", () => { pause(true); engine.nextFrame(); });
  on("second", "click", () => {
    const step = 20000;
    for (let passed = 0; passed < 1000000; passed += step) {
      engine.run(step);
      const state = engine.state();
      curves.note(state);
      announcer.note(state);
    }
  });
  function pause(isOn) { isPaused = isOn; press("pause", isOn); }
  addEventListener("resize", () => show());

  open(engine.drives().length - 1);
  document.documentElement.dataset.ready = "yes";
  requestAnimationFrame(tick);
}));
