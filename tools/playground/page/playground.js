// SPDX-License-Identifier: MIT
(() => {
  "use strict";
  const $ = (id) => document.getElementById(id);
  const fixed = (value, digits, unit) => value == null ? "\u2013" : `${fantailNumber(value.toFixed(digits))} ${unit}`;
  const native = JSON.parse($("native").textContent || "{}");
  const names = {held: "Held", off_command: "Steady, off the command", outside_model: "Outside the model", not_held: "Not held", oscillates: "Oscillates",
    cut_short: "Cut short", not_judged: "Not judged", no_control: "No control", ascent_failed: "Ascent failed"};

  const usual = "tasha3_launch2";
  let wanted = {scenario: usual, settings: new Map()};
  let columnNames = [], built = "", surroundings = "", flight = null, flown = 0, slowest = 0;
  let at = null, playing = !matchMedia("(prefers-reduced-motion: reduce)").matches, begun = 0;

  const turn = Math.PI / 180;
  const draw = fantailRocket($("rocket"));
  const plots = fantailPlots($("plots"), (time) => { at = time; });
  const controls = fantailControls(() => { controls.showOthers(); fly(); }, refuse);
  const flights = fantailFlights(take);

  function pill(words, kind) {
    $("state").textContent = words;
    $("state").className = `pill ${kind}`;
  }

  function refuse(sentence, runs = true) {
    $("refusal").hidden = false;
    $("refusal-text").textContent = sentence;
    // Where something has flown, "As shipped" stands beside it.
    $("start").hidden = !runs || flight !== null;
    $("start").textContent = `Start from ${known(wanted.scenario) ? wanted.scenario : usual} as shipped`;
    document.body.classList.toggle("is-empty", flight === null);
    document.body.classList.add("is-old");
    pill("refused", "bad");
  }

  // --- what is asked for ---
  const known = (scenario) => [...$("scenario").options].some(({value}) => value === scenario);

  function fly() {
    try {
      history.replaceState(null, "", fantailSettings.toLink(wanted));
    } catch {
      // Some browsers allow a hundred of them in half a minute; the next change writes the whole link anyway.
    }
    pill("flying", "");
    flights.wish(wanted);
  }

  function open(read) {
    if (read.refusal) return refuse(read.refusal);
    wanted = read;
    if (known(wanted.scenario)) {
      $("scenario").value = wanted.scenario;
      flights.controls(wanted.scenario);
    }
    return fly();
  }

  // --- what comes ---
  function take(message) {
    if (message.trouble) return refuse(`The simulator does not run in this browser: ${message.trouble}`, false);
    if (message.about) {
      columnNames = message.about.columns;
      if ($("scenario").options.length > 0) return undefined;  // of a worker that was started anew
      $("scenario").replaceChildren(...message.about.scenarios.map((name) => new Option(name, name)));
      return open(fantailSettings.ofLink(location.hash));
    }
    if (message.controls) {
      if (message.of !== wanted.scenario || message.controls.refusal) return undefined;
      built = message.of;
      const answer = JSON.parse(message.controls.answer);
      surroundings = answer.surroundings;
      controls.build(answer);
      return controls.show(wanted.settings);
    }
    return show(message.flown, message.asked);
  }

  function show(result, asked) {
    if (result.refusal !== undefined) {
      return refuse(result.broken ? `This is an error in Fantail, not in your settings: ${result.refusal}.` : result.refusal);
    }
    const summary = JSON.parse(result.summary);
    const columns = Object.fromEntries(columnNames.map((name, i) => [name, result.columns.subarray(i * result.rows, (i + 1) * result.rows)]));
    flown += 1;
    slowest = Math.max(slowest, result.milliseconds);
    flight = {summary, columns, rows: result.rows, span: spanOf(summary, columns), milliseconds: result.milliseconds, memory: result.memory};
    $("refusal").hidden = true;
    document.body.classList.remove("is-old", "is-empty");
    $("verdict-card").className = `card verdict ${summary.outcome}`;
    $("title").textContent = `${asked.scenario}, ${summary.vehicle}`;
    pill(`flown in ${result.milliseconds.toFixed(0)} ms`, "good");
    showWords(summary);
    showRecord(summary, asked);
    plots.show(columns, ...flight.span);
    begun = performance.now();
    return undefined;
  }

  // From shortly before lift-off, or before control in the tunnel, to apogee or the end.
  function spanOf({events}, {time_s: time}) {
    if (time.length === 0) return [0, 1];
    const last = time[time.length - 1];
    const end = Math.min(last, (events.apogee_s ?? last) + 1);
    return [Math.max(time[0], events.control_start_s == null && events.liftoff_s == null ? time[0] : -1), end];
  }

  // As the report has it (report::top_speed_name).
  const speedName = (summary) => surroundings !== "flight" ? "largest air speed" : summary.at_apogee == null ? "top speed" : "top speed over ground";

  function showWords(summary) {
    $("outcome").textContent = names[summary.outcome] ?? summary.outcome;
    $("verdict").textContent = summary.verdict;
    const margin = summary.loop_margins.reduce((least, {phase_margin_deg: value}) => Math.min(least, value), Infinity);
    const figures = [
      ["largest hold error", fixed(summary.outcome === "not_judged" ? null : summary.largest_hold_error_deg, 1, "deg")],
      ["rests from its command", fixed(summary.outcome === "not_judged" ? null : summary.rest_error_deg, 1, "deg")],
      ["canards at their limit", summary.saturated_fraction == null ? "\u2013" : fixed(100 * summary.saturated_fraction, 1, "%")],
      ["authority margin", fixed(summary.authority_margin_deg, 1, "deg")],
      ["least phase margin", fixed(Number.isFinite(margin) ? margin : null, 0, "deg")],
      ["control starts at", fixed(summary.events.control_start_s, 2, "s")],
      [speedName(summary), fixed(summary.max_speed_m_s, 1, "m/s")],
      ["apogee", fixed(summary.apogee_m, 0, "m")],
    ];
    $("figures").replaceChildren(...figures.map(([name, value]) => {
      const box = document.createElement("div");
      box.append(Object.assign(document.createElement("dt"), {textContent: name}), Object.assign(document.createElement("dd"), {textContent: value}));
      return box;
    }));
    $("notes-box").hidden = summary.notes.length === 0;
    $("notes").replaceChildren(...summary.notes.map((note) => Object.assign(document.createElement("li"), {textContent: note})));
  }

  function showRecord({log_sha256: digest}, asked) {
    const {command, fault} = fantailSettings.native(asked);
    $("command").textContent = command;
    $("fault-text").hidden = fault === null;
    $("fault-text").textContent = fault === null ? ""
      : `# my_scenario.toml is a copy of sim/scenarios/${asked.scenario}.toml with this at its end:\n${fault}`;
    $("digest").textContent = digest ?? "nothing was recorded";
    $("record").textContent = digest ? "the SHA-256 of the record is" : "";
    const known = asked.settings.size === 0 ? native.digests?.[asked.scenario] : undefined;
    const same = $("same");
    same.className = known === undefined ? "soft" : known === digest ? "same" : "differs";
    same.textContent = known === undefined
      ? (asked.settings.size === 0 ? "" : "This page has the native program's digests of the shipped scenarios only. For your settings, run the command below and compare.")
      : known === digest ? "Equal to the digest of the native program, taken when this page was made."
        : `DIFFERENT from the digest of the native program, ${known}. This is an error in Fantail.`;
  }

  // --- the rocket turns ---
  function rowAt(time) {
    const times = flight.columns.time_s;
    let [low, high] = [0, times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle; else high = middle - 1;
    }
    return low;
  }

  function step(now) {
    if (flight && flight.rows > 0) {
      const [from, to] = flight.span;
      if (!playing && at === null) begun = now - 1000 * (flight.shown ?? 0);
      const time = at ?? from + ((now - begun) / 1000) % Math.max(to - from, 0.1);
      if (at === null && playing) flight.shown = time - from;
      const row = rowAt(time);
      const {true_roll_deg: truth, roll_deg: estimate, canard_deg: canard, speed_m_s: speed} = flight.columns;
      const roll = Number.isNaN(truth[row]) ? estimate[row] : truth[row];
      draw((roll || 0) * turn, Array(4).fill(Number.isNaN(canard[row]) ? null : canard[row] * turn), false);
      $("rocket").setAttribute("aria-label", `The rocket from behind and the right, rolled by ${fixed(roll, 0, "degrees")}, its canards at ${fixed(Number.isNaN(canard[row]) ? null : canard[row], 1, "degrees")}`);
      $("now").textContent = `${fixed(time, 2, "s")}: roll ${fixed(roll, 0, "deg")}, canards ${fixed(Number.isNaN(canard[row]) ? null : canard[row], 1, "deg")}, ${fixed(speed[row], 0, "m/s")}`;
    }
    requestAnimationFrame(step);
  }

  $("play").addEventListener("click", () => {
    playing = !playing;
    $("play").textContent = playing ? "Pause" : "Play";
  });
  $("play").textContent = playing ? "Pause" : "Play";
  $("scenario").addEventListener("change", () => open({scenario: $("scenario").value, settings: new Map()}));
  $("start").addEventListener("click", () => open({scenario: known(wanted.scenario) ? wanted.scenario : usual, settings: new Map()}));
  $("reset").addEventListener("click", () => open({scenario: $("scenario").value, settings: new Map()}));
  $("copy").addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      $("copy").textContent = "Copied";
    } catch {
      $("copy").textContent = "It is in the address bar";
    }
    setTimeout(() => { $("copy").textContent = "Copy link"; }, 2000);
  });
  addEventListener("hashchange", () => open(fantailSettings.ofLink(location.hash)));  // not of what the page itself writes there

  requestAnimationFrame(step);
  flights.start().catch((error) => refuse(`The simulator does not run in this browser: ${error.message}`, false));
  window.fantail = {figures: () => ({flown, slowest, built, busy: flights.isBusy(), outcome: flight?.summary.outcome ?? null,
    digest: flight?.summary.log_sha256 ?? null, milliseconds: flight?.milliseconds ?? null, memory: flight?.memory ?? null})};
})();
