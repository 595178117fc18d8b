// SPDX-License-Identifier: MIT
// The sheet of a bench while it fills: angles of the canards as they move, and each part of the sheet as it is known.
(() => {
  "use strict";
  const canards = 4;
  const height = 130;
  const $ = (id) => document.getElementById(id);
  const text = (id, words) => { const at = $(id); if (at.textContent !== words) at.textContent = words; };
  const signed = (value) => value == null ? "\u2013" : (value > -.005 ? "+" : "\u2212") + Math.abs(value).toFixed(2);
  const nothing = () => Array.from({length: 2 * canards + 1}, () => []);  // time, command and encoder of each canard

  const empty = $("sheet").innerHTML;
  let now = null, connected = false, changed = false, columns = nothing();

  function take(frame) {
    connected = true;
    if (frame.first) {
      columns = nothing();
      if (frame.sheet === undefined) $("sheet").innerHTML = empty;  // that of another exercise
    } else if (now && frame.frame <= now.frame) return;
    now = frame;
    for (const row of frame.plot) fantailAddStretch(columns, row);
    if (frame.sheet !== undefined) $("sheet").innerHTML = frame.sheet;  // made by this program, its texts escaped
    changed = true;
  }

  function showWords() {
    const state = !now ? ["connecting", ""]
      : now.ended ? ["Ended", now.why ? "failed" : "ended"]
      : !connected ? ["No connection: the exercise did not end while this page was connected", "old"]
      : now.of_s === 0 ? ["Waiting", ""] : ["Moving", "moving"];
    text("state", state[0]);
    $("now-bar").className = "now " + state[1];
    document.body.classList.toggle("is-old", state[1] === "old");
    if (!now) return;
    text("doing", now.why || (now.ended ? "the canards have been commanded to their centres" : now.now));
    if (now.of_s === 0) return;
    text("clock", `${now.time_s.toFixed(1)} of ${now.of_s.toFixed(1)} s`);
    $("progress").value = now.ended && !now.why ? 1 : now.time_s / now.of_s;
    plots.forEach(({value}, i) => { value.textContent = signed(now.canards[i].encoder_deg) + "\u00b0"; });
  }

  // --- plots ---
  const plots = Array.from({length: canards}, (unused, i) => ({title: `Canard ${i + 1}`, unit: "deg",
    lines: [["command", 2 * i + 1, "model", [7, 4]], ["encoder", 2 * i + 2, "measured", []]]}));
  const data = (plot) => [columns[0], ...plot.lines.map(([, column]) => columns[column])];

  function build() {
    $("plots").replaceChildren();
    plots.forEach((plot, i) => {
      const {holder, place} = fantailPlotFrame(plot);
      plot.place = place;
      plot.value = holder.firstChild.appendChild(document.createElement("b"));
      $("plots").append(holder);
      const {axes, series} = fantailPlotOptions(plot.lines);
      const wide = () => 1.25 * Math.max(now?.canards[i].limit_deg ?? 0, 1);
      const reach = (chart, low, high) => { const most = Math.max(wide(), -(low ?? 0), high ?? 0); return [-most, most]; };
      plot.chart = new uPlot({width: place.clientWidth, height, legend: {show: false}, cursor: {show: false},
        scales: {x: {time: false, range: () => [0, Math.max(now?.of_s || 1, columns[0].at(-1) ?? 0)]}, y: {range: reach}}, axes, series}, data(plot), place);
    });
    changed = true;
  }

  function step() {
    if (changed) {
      changed = false;
      showWords();
      for (const plot of plots) plot.chart.setData(data(plot));
    }
    requestAnimationFrame(step);
  }

  fantailKeepPlots($("plots"), plots, height, build);
  setInterval(() => {  // for who does not see the plots
    plots.forEach(({place, title}, i) => {
      const canard = now?.canards[i];
      place.setAttribute("aria-label", `${title}, degrees: command ${signed(canard?.command_deg)}, encoder ${signed(canard?.encoder_deg)}`);
    });
  }, 1000);
  fantailListen(take, () => { [connected, changed] = [false, true]; });
  requestAnimationFrame(step);
})();
