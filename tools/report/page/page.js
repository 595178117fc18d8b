// SPDX-License-Identifier: MIT
// Draws the plots from the JSON in #flight-data. Without this script the page still has its picture and its numbers.
(() => {
  "use strict";
  const data = JSON.parse(document.getElementById("flight-data").textContent);
  if (data.plots.length === 0) return;
  const axisWidth = 52;
  const rightMargin = 10;
  const section = document.getElementById("plots");
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const phaseColor = {safe: "pad", armed: "pad", finished: "pad", launched: "launched", controlling: "controlling"};
  const styles = {
    reference: {color: "step", width: 1.5, stepped: true},
    settle: {color: "green", width: 1.8, dash: [7, 4], stepped: true},
    truth: {color: "orange", width: 5.5, alpha: .55},
    estimate: {color: "blue", width: 1.6},
    command: {color: "blue", width: 1.4},
    measured: {color: "orange", width: 2},
    excitation: {color: "grey", width: 1},
  };
  const number = (value) => String(value).replace("-", "\u2212");

  const charts = [];
  let view = [data.views[0].begin, data.views[0].end];
  let spreading = false;  // one plot's new range is being given to the others

  function show(begin, end) {
    view = [begin, end];
    spreading = true;
    for (const chart of charts) chart.setScale("x", {min: begin, max: end});
    spreading = false;
    drawTimeline();
    for (const button of toolbar.querySelectorAll("button")) {
      const pressed = Number(button.dataset.begin) === begin && Number(button.dataset.end) === end;
      button.setAttribute("aria-pressed", pressed);
    }
  }

  // --- the strip of event names that stays in sight above the plots ---
  const timeline = document.createElement("div");
  timeline.className = "timeline";
  let mostRows = 1;  // the strip never shrinks, or the plots would jump under the pointer
  function drawTimeline() {
    timeline.replaceChildren();
    const width = timeline.clientWidth;
    const rowHeight = 17;
    const ends = [];
    for (const event of data.events) {
      if (!event.label || event.time < view[0] || event.time > view[1]) continue;
      const x = axisWidth + (width - axisWidth - rightMargin) * (event.time - view[0]) / (view[1] - view[0]);
      const span = document.createElement("span");
      span.textContent = event.label;
      span.title = number(event.time.toFixed(3)) + " s";
      timeline.append(span);
      const needed = span.offsetWidth + 6;
      const turned = x + needed > width;
      const begin = turned ? x - needed : x;
      let row = 0;
      while (row < ends.length && ends[row] > begin) row++;
      ends[row] = begin + needed;
      span.classList.toggle("turned", turned);
      span.style.left = (turned ? x - needed + 6 : x) + "px";
      span.style.top = row * rowHeight + 3 + "px";
    }
    mostRows = Math.max(mostRows, ends.length);
    timeline.style.height = mostRows * rowHeight + 6 + "px";
  }

  // --- what lies behind the lines of a plot ---
  function drawBackground(chart, plot) {
    const {ctx, bbox} = chart;
    const x = (time) => chart.valToPos(Math.min(Math.max(time, view[0]), view[1]), "x", true);
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const phase of data.phases) {
      ctx.fillStyle = color(phaseColor[phase.phase]);
      ctx.fillRect(x(phase.begin), bbox.top, x(phase.end) - x(phase.begin), bbox.height);
    }
    ctx.lineWidth = devicePixelRatio;
    ctx.strokeStyle = color("event");
    for (const event of data.events) {
      if (event.time < view[0] || event.time > view[1] || (!event.label && isSmall(plot))) continue;
      ctx.globalAlpha = event.label ? 1 : .5;
      ctx.beginPath();
      ctx.moveTo(x(event.time), bbox.top);
      ctx.lineTo(x(event.time), bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.globalAlpha = 1;
    if (plot.limits && data.limits) drawLimits(chart);
    ctx.restore();
  }

  function drawLimits(chart) {
    const {ctx, bbox} = chart;
    const bottom = bbox.top + bbox.height;
    const upper = chart.valToPos(data.limits.plan, "y", true);
    const lower = chart.valToPos(-data.limits.plan, "y", true);
    ctx.fillStyle = color("beyond");
    ctx.fillRect(bbox.left, bbox.top, bbox.width, upper - bbox.top);
    ctx.fillRect(bbox.left, lower, bbox.width, bottom - lower);
    ctx.strokeStyle = ctx.fillStyle = color("limit");
    ctx.font = 11 * devicePixelRatio + "px system-ui, sans-serif";
    ctx.textAlign = "right";
    ctx.textBaseline = "bottom";
    for (const [name, label] of [["plan", "plan limit"], ["stop", "mechanical stop"], ["hard", "hard limit"]]) {
      const limit = data.limits[name];
      if (limit > chart.scales.y.max) continue;
      for (const side of [limit, -limit]) {
        const y = chart.valToPos(side, "y", true);
        ctx.beginPath();
        ctx.moveTo(bbox.left, y);
        ctx.lineTo(bbox.left + bbox.width, y);
        ctx.stroke();
      }
      const y = chart.valToPos(limit, "y", true);
      ctx.fillText(`${label} ${limit} deg`, bbox.left + bbox.width - 4 * devicePixelRatio, y - devicePixelRatio);
    }
  }

  // Room around the lines; a plot with limits always shows the plan limit and a strip beyond it.
  const heightRange = (plot) => (chart, low, high) => {
    if (low == null || high == null) [low, high] = [-1, 1];
    if (plot.limits && data.limits) {
      const shown = data.limits.plan * 1.35;
      [low, high] = [Math.min(low, -shown), Math.max(high, shown)];
    }
    const margin = Math.max((high - low) * .06, .05);
    return [low - margin, high + margin];
  };

  function chartOptions(plot, width, height) {
    const axis = {
      stroke: color("soft"), font: "12px system-ui, sans-serif", grid: {stroke: color("grid"), width: 1},
      ticks: {show: false},
    };
    return {
      width, height,
      padding: [8, rightMargin, 0, 0],
      scales: {x: {time: false, min: view[0], max: view[1]}, y: {range: heightRange(plot)}},
      cursor: {
        sync: {key: "fantail", setSeries: false, filters: {pub: (type) => type === "mousemove" || type === "mouseleave"}},
        drag: {x: true, y: false}, points: {size: 6}, y: false,
        bind: {dblclick: () => () => show(data.views[0].begin, data.views[0].end)},
      },
      axes: [
        {...axis, size: 26, space: 60, values: (chart, ticks) => ticks.map(number)},
        {...axis, size: axisWidth, gap: 6, space: 28, values: (chart, ticks) => ticks.map(number)},
      ],
      series: [
        {label: "time", value: (chart, value) => value == null ? "\u2013" : number(value.toFixed(3)) + " s"},
        ...plot.series.map((series) => {
          const style = plot.series.length > 1 ? styles[series.style] : {...styles[series.style], width: 2, alpha: 1};
          return {
            label: series.name, stroke: color(style.color), width: style.width, dash: style.dash, alpha: style.alpha ?? 1,
            paths: style.stepped ? uPlot.paths.stepped({align: 1}) : undefined, points: {show: false},
            value: (chart, value) => value == null ? "\u2013" : number(value.toFixed(2)),
          };
        }),
      ],
      hooks: {
        drawClear: [(chart) => drawBackground(chart, plot)],
        setScale: [(chart, key) => {
          if (key !== "x" || spreading || !charts.includes(chart)) return;
          const {min, max} = chart.scales.x;
          if (min !== view[0] || max !== view[1]) show(min, max);
        }],
      },
    };
  }

  const unpacked = new Map(data.plots.map((plot) => [plot.id, [
    plot.milliseconds.map((t) => t / 1000),
    ...plot.series.map((series) => series.hundredths.map((v) => v === null ? null : v / 100)),
  ]]));
  const isSmall = (plot) => /^(canard-|height|speed)/.test(plot.id);

  const holders = [];
  let pair = null;
  const toolbar = document.createElement("div");
  toolbar.className = "toolbar";
  const content = document.createElement("div");
  content.append(toolbar, timeline);
  for (const plot of data.plots) {
    const holder = document.createElement("div");
    holder.className = "plot";
    holder.innerHTML = "<h3></h3>";
    holder.firstChild.textContent = plot.title + " ";
    const unit = document.createElement("small");
    unit.textContent = plot.unit;
    holder.firstChild.append(unit);
    if (isSmall(plot)) {
      if (!pair) content.append(pair = Object.assign(document.createElement("div"), {className: "pair"}));
      pair.append(holder);
    } else {
      pair = null;
      content.append(holder);
    }
    holders.push(holder);
  }
  for (const {label, begin, end} of data.views) {
    const button = Object.assign(document.createElement("button"), {type: "button", textContent: label});
    button.dataset.begin = begin;
    button.dataset.end = end;
    button.addEventListener("click", () => show(begin, end));
    toolbar.append(button);
  }
  toolbar.append(Object.assign(document.createElement("span"), {
    className: "hint", textContent: "Drag across a plot to look closer; double-click goes back.",
  }));

  const heightOf = (plot) => isSmall(plot) ? 150 : plot.id === "roll-angle" ? 300 : 200;
  function build() {
    for (const chart of charts.splice(0)) chart.destroy();
    data.plots.forEach((plot, i) => {
      charts.push(new uPlot(chartOptions(plot, holders[i].clientWidth, heightOf(plot)), unpacked.get(plot.id), holders[i]));
    });
    show(...view);
  }

  document.getElementById("overview").hidden = true;
  section.append(content);
  build();
  let lastWidth = content.clientWidth;
  new ResizeObserver(() => {
    if (content.clientWidth === lastWidth) return;
    lastWidth = content.clientWidth;
    charts.forEach((chart, i) => chart.setSize({width: holders[i].clientWidth, height: heightOf(data.plots[i])}));
    drawTimeline();
  }).observe(content);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", build);
})();
