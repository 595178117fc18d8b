// SPDX-License-Identifier: MIT
// Shows the frames of /events. Nothing goes the other way.
(() => {
  "use strict";
  const span_s = 30;
  const signals = 7;  // roll, reference, rate, command, mean of the canards, height, speed: plot_history.hpp
  const $ = (id) => document.getElementById(id);
  const fixed = (value, digits) => value == null ? "\u2013" : fantailNumber(value.toFixed(digits));
  const signed = (value, digits) => value == null ? "\u2013" : (value >= 0 || Number(value.toFixed(digits)) === 0 ? "+" : "\u2212") + Math.abs(value).toFixed(digits);
  const text = (id, words) => { const at = $(id); if (at.textContent !== words) at.textContent = words; };

  let now = null;        // the newest frame
  let settlesOff = null, connected = false, lostSince = null, changed = false;
  let dropped = 0, drawn = 0;  // frames that did not reach this page, and frames that it has shown
  let columns = Array.from({length: signals + 1}, () => []), events = [];

  // --- what comes ---
  function take(frame) {
    if (now && frame.source === undefined) {
      if (frame.frame <= now.frame) return;
      dropped += frame.frame - now.frame - 1;
    }
    if (frame.source !== undefined) settlesOff = frame.settles_off_deg;  // the first of a connection tells everything
    if (frame.source !== undefined || (now && frame.run !== now.run)) {
      columns = columns.map(() => []);
      events = [];
    }
    now = frame;
    for (const row of frame.plot) fantailAddStretch(columns, row);
    events.push(...frame.events);
    while (events.length > 100) events.shift();
    const first = columns[0].findIndex((time) => time > (frame.time_s ?? 0) - span_s - 1);
    if (first > 200) columns = columns.map((column) => column.slice(first));
    if (frame.events.length > 0 || frame.source !== undefined) showEvents();
    changed = true;
  }

  function listen() {
    fantailListen((frame) => {
      [connected, lostSince] = [true, null];
      take(frame);
    }, () => {
      if (connected || lostSince === null) lostSince = performance.now();
      [connected, changed] = [false, true];
    });
  }

  // --- words and numbers ---
  const phases = {
    safe: ["SAFE", "not armed; canards at trim, except in a bench session or self-test"],
    armed: ["ARMED", "waits for the launch; canards at trim"],
    launched: ["LAUNCHED", "not yet clear of the guide; canards at trim"],
    dormant: ["DORMANT", "canards at trim until the plan's gate opens"],
    controlling: ["CONTROLLING", "the canards hold the roll"],
    finished: ["FINISHED", "control is over; canards at trim"],
  };

  function showWords() {
    const link = now ? now.link : {is: "silent"};
    const old = !connected || link.is === "old";
    document.body.classList.toggle("is-old", old && now !== null && now.phase !== undefined);
    if (now?.ended) {  // told by the program itself before it left
      text("link", `${now.ended} has ended; the last data are shown`);
    } else if (!connected) {
      const since = lostSince === null ? "" : ` for ${((performance.now() - lostSince) / 1000).toFixed(0)} s`;
      text("link", now ? `OLD: no connection${since}; the last data are shown` : "no connection; trying again");
    } else {
      text("link", link.is === "live" ? "live" : link.is === "silent" ? "nothing received yet"
        : `OLD: nothing new for ${link.age_s.toFixed(0)} s; the last data are shown`);
    }
    $("link").className = "pill " + (now?.ended ? "" : connected && link.is === "live" ? "live" : old ? "old" : "");
    if (!now || now.phase === undefined) return;
    const [word, about] = phases[now.phase] ?? [now.phase, ""];
    text("phase", word);
    text("phase-about", about + (now.timing_fault ? "; TIMING FAULT" : ""));
    $("phase-card").className = "card phase " + now.phase;
    text("clock", now.since_launch_s == null ? "\u2013" : "T+" + now.since_launch_s.toFixed(1) + " s");
    for (const [id, name] of [["height", "height_m"], ["speed", "speed_m_s"], ["tilt", "tilt_deg"], ["force", "force_m_s2"]]) {
      text(id, fixed(now[name], 1));
    }
    text("time", fixed(now.time_s, 2));
    text("roll", signed(now.roll_deg, 1));
    text("rate", signed(now.rate_deg_s, 1));
    text("link-about", `In the last ${link.span_s} s: ${link.received} messages received, ${link.lost} lost, ${link.late} late`
      + (link.restarts > 0 ? `; the sender has restarted ${link.restarts} times` : "")
      + `; ${dropped} frames did not reach this page.`);
    const health = now.health;
    text("sensors", health ? `Gyro ${health.gyro}, accelerometer ${health.accelerometer}`
      + (health.longest_tick_us == null ? "" : `; longest tick ${health.longest_tick_us} us`)
      + (health.late_ticks == null ? "" : `, ${health.late_ticks} late`) + "." : "");
  }

  function showCanards() {
    const rows = $("canards");
    const list = now.canards ?? [];
    if (list.length === 0) return;
    while (rows.children.length < list.length || rows.children[0].children.length < 5) {
      if (rows.children[0]?.children.length === 1) rows.replaceChildren();
      for (let i = 0, row = rows.insertRow(); i < 5; i++) row.insertCell().className = i > 0 && i < 4 ? "n" : "";
    }
    list.forEach((canard, i) => {
      const verdict = canard.verdict ?? "unknown";
      const words = [String(i + 1), signed(canard.command_deg, 2), signed(canard.encoder_deg, 2), fixed(canard.limit_deg, 2),
                     verdict + (canard.limited ? ", limited" : "")];
      words.forEach((word, j) => { const cell = rows.children[i].children[j]; if (cell.textContent !== word) cell.textContent = word; });
      rows.children[i].children[4].className = verdict === "healthy" ? "good" : canard.verdict ? "bad" : "";
    });
  }

  function showEvents() {
    if (events.length === 0) return;
    $("events").replaceChildren(...events.slice().reverse().map((event) => {
      const item = document.createElement("li");
      item.append(Object.assign(document.createElement("time"), {textContent: event.time_s.toFixed(2) + " s"}), event.text);
      return item;
    }));
  }

  // --- drawings ---
  const svg = (kind, attributes, parent) => {
    const element = parent.appendChild(document.createElementNS("http://www.w3.org/2000/svg", kind));
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  };
  const turned = (element, degrees) => element.setAttribute("transform", `rotate(${degrees.toFixed(2)})`);
  const hide = (element, hidden) => element.setAttribute("visibility", hidden ? "hidden" : "visible");

  // Clockwise is positive: from behind, as the canards see it.
  const dial = (() => {
    const at = $("dial");
    svg("circle", {r: 92, class: "rim"}, at);
    for (let degrees = 0; degrees < 360; degrees += 15) {
      turned(svg("line", {y1: degrees % 45 === 0 ? -78 : -85, y2: -92, class: "tick"}, at), degrees);
    }
    for (const [degrees, name] of [[0, "0"], [90, "90"], [180, "180"], [270, "\u221290"]]) {
      const angle = degrees * Math.PI / 180;
      svg("text", {x: (62 * Math.sin(angle)).toFixed(1), y: (-62 * Math.cos(angle)).toFixed(1)}, at).textContent = name;
    }
    const reference = svg("g", {}, at);
    svg("path", {d: "M0 -93 l7 -14 h-14 z", class: "reference"}, reference);
    const settle = svg("g", {}, at);
    svg("circle", {cy: -100, r: 5.5, class: "settle"}, settle);
    const needle = svg("g", {}, at);
    svg("line", {y1: 22, y2: 0, class: "tail"}, needle);
    svg("line", {y2: -76, class: "needle"}, needle);
    return {at, reference, settle, needle};
  })();

  const rocket = (() => {
    const at = $("rocket");
    const body = svg("g", {}, at);
    const canards = [0, 1, 2, 3].map((i) => {
      const arm = svg("g", {transform: `rotate(${90 * i})`}, body);
      svg("line", {y1: -30, y2: -72, class: "shaft"}, arm);
      const tip = svg("g", {transform: "translate(0 -72)"}, arm);
      const fin = svg("path", {d: "M0 -24 Q6 -14 4 0 L1 24 H-1 L-4 0 Q-6 -14 0 -24 Z", class: "fin"}, tip);
      const asked = svg("line", {y1: -32, y2: 32, class: "asked"}, tip);
      const name = svg("text", {x: 26, y: -50}, arm);
      name.textContent = i + 1;
      return {asked, fin, name};
    });
    svg("circle", {r: 30, class: "body"}, body);
    svg("line", {y1: -30, y2: -14, class: "up"}, body);
    return {at, body, canards};
  })();

  function draw() {
    const {roll_deg: roll, reference_deg: reference} = now;
    const settle = settlesOff == null || reference == null ? null : reference + settlesOff;
    for (const [mark, angle] of [[dial.needle, roll], [dial.reference, reference], [dial.settle, settle]]) {
      hide(mark, angle == null);
      if (angle != null) turned(mark, angle);
    }
    $("settle-key").hidden = settlesOff == null;
    turned(rocket.body, roll ?? 0);
    (now.canards ?? []).forEach((canard, i) => {
      const {fin, asked, name} = rocket.canards[i];
      fin.setAttribute("class", "fin" + (canard.encoder_deg == null ? " unknown" : "")
        + (canard.verdict && canard.verdict !== "healthy" ? " bad" : ""));
      turned(fin, canard.encoder_deg ?? 0);
      hide(asked, canard.command_deg == null);
      if (canard.command_deg != null) turned(asked, canard.command_deg);
      name.setAttribute("transform", `rotate(${(-90 * i - (roll ?? 0)).toFixed(2)} 26 -50)`);
    });
  }

  // Once a second and with new plots, for who does not see the drawings.
  function describe() {
    if (!now || now.phase === undefined) return;
    dial.at.setAttribute("aria-label", `Roll angle ${signed(now.roll_deg, 1)} degrees, reference ${signed(now.reference_deg, 1)}`);
    rocket.at.setAttribute("aria-label", "Encoders of the canards in degrees: "
      + (now.canards ?? []).map((canard, i) => `${i + 1}: ${signed(canard.encoder_deg, 2)}`).join(", "));
    for (const {place, title, lines} of plots) {
      place.setAttribute("aria-label", title + ", now: "
        + lines.map(([name, column]) => `${name} ${fixed(columns[column][columns[column].length - 1] ?? null, 1)}`).join(", "));
    }
  }

  // --- plots: name, column, colour, dashes ---
  const plots = [
    {title: "Roll angle", unit: "deg", lines: [["roll", 1, "measured", []], ["reference", 2, "model", [7, 4]]]},
    {title: "Canards", unit: "deg", lines: [["mean of the encoders", 5, "measured", []], ["command", 4, "model", [7, 4]]]},
    {title: "Roll rate", unit: "deg/s", lines: [["roll rate", 3, "measured", []]]},
    {title: "Height and speed", unit: "m, m/s", lines: [["height", 6, "measured", []], ["speed along the guide", 7, "model", [7, 4]]]},
  ];
  const height = 150;

  function build() {
    $("plots").replaceChildren();
    for (const plot of plots) {
      const {holder, place} = fantailPlotFrame(plot);
      plot.place = place;
      $("plots").append(holder);
      plot.chart = new uPlot(options(plot, place.clientWidth), data(plot), place);
    }
    describe();
  }

  const data = (plot) => [columns[0], ...plot.lines.map(([, column]) => columns[column])];

  function options(plot, width) {
    const {axes, y, series} = fantailPlotOptions(plot.lines);
    const range = () => { const end = Math.max(now?.time_s ?? span_s, span_s); return [end - span_s, end]; };
    return {width, height, legend: {show: false}, cursor: {show: false}, scales: {x: {time: false, range}, y}, axes, series};
  }

  function step() {
    if (changed) {
      changed = false;
      drawn += 1;
      showWords();
      if (now?.phase !== undefined) {
        showCanards();
        draw();
      }
      for (const plot of plots) plot.chart.setData(data(plot));
    }
    requestAnimationFrame(step);
  }

  fantailKeepPlots($("plots"), plots, height, build);
  // On paper: as wide as the sheet, in its colours (panel.css, chart.css).
  for (const [when, is] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(when, () => { document.documentElement.classList.toggle("on-paper", is); build(); });
  }
  setInterval(() => {
    describe();
    if (!connected) changed = true;  // the age goes on
  }, 1000);
  listen();
  requestAnimationFrame(step);
  window.fantail = {figures: () => ({drawn, dropped, connected, frame: now?.frame ?? null, time_s: now?.time_s ?? null, phase: now?.phase ?? null})};
})();
