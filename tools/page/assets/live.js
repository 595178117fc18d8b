// SPDX-License-Identifier: MIT
// Draws the plots from the JSON in #live-data. Without this script the page still has its picture and its numbers.
(() => {
  "use strict";
  const data = JSON.parse(document.getElementById("live-data").textContent);
  if (data.plots.length === 0) return;
  const axisWidth = 52;
  const rightMargin = 10;
  const place = document.getElementById("live");
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const strokes = {
    target: {width: 5}, measured: {width: 1.6}, model: {width: 1.8, dash: [10, 4]}, second: {width: 1.8, dash: [7, 4]},
    reference: {width: 1.5}, limit: {width: 1.4}, neutral: {width: 1},
  };
  const number = (value) => String(value).replace(/^-(?=[0.]*$)/, "").replace("-", "\u2212");  // never less than a zero

  const charts = [];  // beside data.plots; null: nobody has asked for it yet
  let view = [data.views[0].begin, data.views[0].end];
  let spreading = false;  // one plot's new range is being given to the others

  function show(begin, end) {
    view = [begin, end];
    spreading = true;
    for (const chart of charts) chart?.setScale("x", {min: begin, max: end});
    spreading = false;
    charts.forEach((chart, i) => chart?.root.querySelector(".u-wrap").setAttribute("aria-label", inWords(data.plots[i])));
    drawTimeline();
    if (scene) queueMicrotask(() => placeCursors(scene.time()));  // when the plots have taken their new range
    for (const button of toolbar.querySelectorAll("[data-begin]")) {
      const pressed = Number(button.dataset.begin) === begin && Number(button.dataset.end) === end;
      button.setAttribute("aria-pressed", pressed);
    }
  }

  // --- the rocket that turns: its time is where the cursor of the plots stands ---
  function placeCursors(time) {
    const inside = time >= view[0] && time <= view[1];
    for (const chart of charts) {
      chart?.setCursor(inside ? {left: chart.valToPos(time, "x"), top: 1} : {left: -10, top: -10});
    }
  }
  function followPointer(chart) {
    if (scene) chart.over.addEventListener("mousemove", () => scene.isPlaying() || scene.go(chart.posToVal(chart.cursor.left, "x")));
    if (scene) chart.over.addEventListener("mouseleave", () => placeCursors(scene.time()));
    // uPlot knows no touch. A finger moves the cursor of all plots, where a mouse would zoom; up and down it scrolls.
    chart.over.style.touchAction = "pan-y";
    for (const kind of ["pointerdown", "pointermove"]) chart.over.addEventListener(kind, (event) => {
      if (event.pointerType !== "touch" || scene?.isPlaying()) return;
      const time = chart.posToVal(event.clientX - chart.over.getBoundingClientRect().left, "x");
      scene?.go(time);
      placeCursors(time);
    });
  }
  const scene = data.scene ? fantailScene(data.scene, number, placeCursors) : null;

  // For who does not see a plot: between what values each of its lines runs in the view.
  function inWords(plot) {
    const [times, ...columns] = unpacked.get(plot);
    const lines = plot.series.flatMap(({name, edge}, i) => {
      if (!name) return [];  // the lower edge of a band
      const seen = (edge ? [columns[i - 1], columns[i]] : [columns[i]]).flatMap((values) =>
        values.filter((value, j) => value !== null && times[j] >= view[0] && times[j] <= view[1]));
      return seen.length === 0 ? name + " has no data"
        : `${name} ${number(Math.min(...seen).toFixed(1))} to ${number(Math.max(...seen).toFixed(1))}`;
    });
    return `${plot.title}, ${plot.unit}, from ${number(view[0].toFixed(1))} to ${number(view[1].toFixed(1))} s: ${lines.join("; ")}`;
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
    ctx.globalAlpha = .13;
    for (const stripe of data.stripes) {
      ctx.fillStyle = color(stripe.role);
      ctx.fillRect(x(stripe.begin), bbox.top, x(stripe.end) - x(stripe.begin), bbox.height);
    }
    ctx.lineWidth = devicePixelRatio;
    ctx.strokeStyle = color("ink");
    for (const event of data.events) {
      if (event.time < view[0] || event.time > view[1] || (!event.label && !plot.wide)) continue;
      ctx.globalAlpha = event.label ? .4 : .2;
      line(ctx, x(event.time), bbox.top, x(event.time), bbox.top + bbox.height);
    }
    ctx.globalAlpha = 1;
    drawLevels(chart, plot.levels);
    ctx.restore();
  }

  function line(ctx, fromX, fromY, toX, toY) {
    ctx.beginPath();
    ctx.moveTo(fromX, fromY);
    ctx.lineTo(toX, toY);
    ctx.stroke();
  }

  function drawLevels(chart, levels) {
    const {ctx, bbox} = chart;
    for (const level of levels) {
      const y = chart.valToPos(level.value, "y", true);
      ctx.strokeStyle = color(level.role);
      line(ctx, bbox.left, y, bbox.left + bbox.width, y);
    }
  }

  // Last of all: the grid would go through the words.
  function nameLevels(chart, levels) {
    const {ctx, bbox} = chart;
    ctx.save();
    ctx.font = 11 * devicePixelRatio + "px system-ui, sans-serif";
    ctx.textAlign = "right";
    ctx.textBaseline = "bottom";
    for (const level of levels) {
      ctx.fillStyle = color(level.role);
      ctx.fillText(level.label, bbox.left + bbox.width - 4 * devicePixelRatio,
                   chart.valToPos(level.value, "y", true) - 2 * devicePixelRatio);
    }
    ctx.restore();
  }

  // Room around the lines, and around what must be in sight.
  const heightRange = (plot) => (chart, low, high) => {
    if (low == null || high == null) [low, high] = [-1, 1];
    if (plot.sight) [low, high] = [Math.min(low, plot.sight.low), Math.max(high, plot.sight.high)];
    const margin = Math.max((high - low) * .06, .05);
    return [low - margin, high + margin];
  };

  function chartOptions(plot, width, height) {
    const axis = {
      stroke: color("soft"), font: "12px system-ui, sans-serif", grid: {stroke: color("line"), width: 1},
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
        {...axis, size: 26, space: 60, values: (chart, ticks) => ticks.map((tick) => number(tick) + " s")},
        {...axis, size: axisWidth, gap: 6, space: 28, values: (chart, ticks) => ticks.map(number)},
      ],
      series: [
        {label: "time", value: (chart, value) => value == null ? "\u2013" : number(chart.posToVal(chart.cursor.left, "x").toFixed(3)) + " s"},  // one time for all plots: each has samples of its own
        ...plot.series.map((series) => {
          const stroke = series.edge ? {width: 0} : plot.series.length > 1 ? strokes[series.role] : {width: 2};
          return {
            ...stroke, label: series.name, stroke: color(series.role),
            paths: series.step ? uPlot.paths.stepped({align: 1}) : undefined, points: {show: false},
            value: (chart, value, i, sample) => {
              const values = series.edge && sample != null ? [chart.data[i - 1][sample], value] : [value];
              return values.includes(null) || value == null ? "\u2013" : values.map((one) => number(one.toFixed(2))).join(" to ");
            },
          };
        }),
      ],
      bands: plot.bands.map(({low, high, role}) =>
        ({series: [high + 1, low + 1], fill: `color-mix(in srgb, ${color(role)} 28%, transparent)`})),
      legend: {markers: {fill: (chart, i) => plot.series[i - 1]?.edge ? `color-mix(in srgb, ${color(plot.series[i - 1].role)} 28%, transparent)` : null}},
      hooks: {
        init: [(chart) => chart.root.querySelectorAll(".u-series").forEach((row, i) => {
          if (plot.series[i - 1]?.edge && !plot.series[i - 1].name) row.style.display = "none";  // the lower edge of a band
        })],
        drawClear: [(chart) => drawBackground(chart, plot)],
        draw: [(chart) => nameLevels(chart, plot.levels)],
        setScale: [(chart, key) => {
          if (key !== "x" || spreading || !charts.includes(chart)) return;
          const {min, max} = chart.scales.x;
          if (min !== view[0] || max !== view[1]) show(min, max);
        }],
      },
    };
  }

  const unpacked = new Map(data.plots.map((plot) => [plot, [
    plot.milliseconds.map((t) => t / 1000),
    ...plot.series.map((series) => series.hundredths.map((v) => v === null ? null : v / 100)),
  ]]));

  const element = (kind, properties) => Object.assign(document.createElement(kind), properties);
  const stripes = element("div", {className: "stripes"});
  for (const stripe of new Map(data.stripes.map((stripe) => [stripe.label, stripe])).values()) {
    const name = element("span", {textContent: stripe.label});
    name.prepend(element("i", {className: stripe.role}));
    stripes.append(name);
  }
  const toolbar = element("div", {className: "toolbar"});
  const content = document.createElement("div");
  const more = element("div", {hidden: true});
  content.append(toolbar, timeline);
  const holders = [];
  let pair = null;
  for (const plot of data.plots) {
    const holder = element("div", {className: "plot"});
    const title = element("h3", {textContent: plot.title + " "});
    title.append(element("small", {textContent: plot.unit}));
    holder.append(title);
    const place = plot.more ? more : content;
    if (plot.wide) {
      pair = null;
    } else if (pair?.parentNode !== place) {
      place.append(pair = element("div", {className: "pair"}));
    }
    (pair ?? place).append(holder);
    holders.push(holder);
  }
  for (const {label, begin, end} of data.views) {
    const button = element("button", {type: "button", textContent: label});
    button.dataset.begin = begin;
    button.dataset.end = end;
    button.addEventListener("click", () => show(begin, end));
    toolbar.append(button);
  }
  if (more.hasChildNodes()) {
    const button = element("button", {type: "button", textContent: data.more});
    button.setAttribute("aria-pressed", false);
    button.addEventListener("click", () => {
      more.hidden = !more.hidden;
      button.setAttribute("aria-pressed", !more.hidden);
      build();
    });
    toolbar.append(button);
    content.append(more);
  }

  function build() {
    for (const chart of charts.splice(0)) chart?.destroy();
    data.plots.forEach((plot, i) => {
      if (plot.more && more.hidden) return charts.push(null);
      const height = plot.height * (!document.documentElement.matches(".on-paper") ? 1 : plot.wide ? .52 : .7);
      charts.push(new uPlot(chartOptions(plot, holders[i].clientWidth, height), unpacked.get(plot), holders[i]));
      charts[i].root.querySelector(".u-wrap").role = "img";
    });
    charts.filter(Boolean).forEach(followPointer);
    scene?.draw();
    show(...view);
  }

  toolbar.append(stripes);
  content.append(element("p", {className: "note hint", textContent: "Drag across a plot to look closer; double-click goes back."}));
  place.replaceChildren(...(scene ? [scene.stage] : []), content);
  place.classList.toggle("with-stage", scene !== null);
  build();
  let lastWidth = content.clientWidth;
  new ResizeObserver(() => {
    if (content.clientWidth === lastWidth) return;
    lastWidth = content.clientWidth;
    charts.forEach((chart, i) => chart?.setSize({width: holders[i].clientWidth, height: data.plots[i].height}));
    scene?.draw();
    show(...view);
  }).observe(content);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", build);
  // On paper: as wide as the sheet, in its colours (page.css, chart.css).
  const onPaper = (is) => () => {
    document.documentElement.classList.toggle("on-paper", is);
    mostRows = 1;
    build();
  };
  addEventListener("beforeprint", onPaper(true));
  addEventListener("afterprint", onPaper(false));
})();
