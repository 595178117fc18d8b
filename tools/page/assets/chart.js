// SPDX-License-Identifier: MIT
// What a chart does under a pointer: a line with the values there, and zoom by dragging; a double click shows all again.
"use strict";

(() => {
  const namespace = "http://www.w3.org/2000/svg";
  const make = (name, attributes, parent) => {
    const element = parent.appendChild(document.createElementNS(namespace, name));
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };

  // The points of a path as the page writes them: M, L, H, V; "h0" after M is a dot.
  function pointsOf(path) {
    const points = [];
    for (const [, kind, x, y] of path.getAttribute("d").matchAll(/([MLHV])([-\d.]+)(?: ([-\d.]+))?/g)) {
      const last = points.at(-1);
      if (kind === "H") points.push({x: +x, y: last.y});
      else if (kind === "V") points.push({x: last.x, y: +x});
      else points.push({x: +x, y: +y, moved: kind === "M"});
    }
    return points;
  }

  // Where a line is at this x, or the edges of an area; none in a gap.
  function heightsAt(points, x) {
    const heights = [];
    for (let i = 1; i < points.length; ++i) {
      const [a, b] = [points[i - 1], points[i]];
      if (!b.moved && Math.min(a.x, b.x) <= x && x <= Math.max(a.x, b.x)) {
        heights.push(b.x === a.x ? b.y : a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
      }
    }
    return heights;
  }

  function nearest(points, x, y, reach) {
    let best = null;
    for (const p of points) {
      const distance = Math.hypot(p.x - x, p.y - y);
      if (distance < reach && (!best || distance < best.distance)) best = {...p, distance};
    }
    return best;
  }

  function steps(low, high, wanted) {
    const rough = (high - low) / wanted;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough);
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const ticks = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) ticks.push([i * step, (i * step).toFixed(decimals)]);
    return ticks;
  }
  const written = (text) => text.replace(/^-(?=[0.]*$)/, "").replace(/^-/, "\u2212");

  // The same for a logarithmic axis, of exponents of ten: at 1, 2 and 5 times the powers, or even ones where that is too few.
  function decadeSteps(low, high, wanted) {
    const ticks = [];
    for (let exponent = Math.floor(low); exponent <= high; ++exponent) {
      for (const factor of [1, 2, 5]) {
        const at = exponent + Math.log10(factor);
        if (at >= low && at <= high) ticks.push([at, String(Number((10 ** at).toPrecision(1)))]);
      }
    }
    return ticks.length >= 3 ? ticks : steps(10 ** low, 10 ** high, wanted).map(([value, text]) => [Math.log10(value), text]);
  }

  function enliven(svg) {
    const isLogarithmic = svg.dataset.xScale === "logarithmic";  // then all x are exponents of ten
    const all = {x: svg.dataset.x.split(" ").map(Number), y: svg.dataset.y.split(" ").map(Number)};
    if (isLogarithmic) all.x = all.x.map(Math.log10);
    const curves = svg.querySelector("svg.curves");
    const [left, top, width, height] = ["x", "y", "width", "height"].map((name) => Number(curves.getAttribute(name)));
    const [right, bottom] = [left + width, top + height];
    const lines = [...curves.querySelectorAll("path[data-name]")].map((path) => ({name: path.dataset.name,
      kind: ["dots", "area", "line"].find((kind) => path.classList.contains(kind)), role: path.getAttribute("class"), points: pointsOf(path)}));
    if (lines.length === 0) return;
    // A line that turns back has no value at an x: it is the outline of an area, or a path over ground.
    for (const line of lines) {
      if (line.kind === "line" && line.points.some(({x}, i) => i > 0 && x < line.points[i - 1].x - 1e-6)) line.kind = "outline";
    }
    const overflow = curves.getAttribute("overflow");
    const isPlace = (kind) => kind === "dots" || kind === "outline";
    const hasDotsOnly = lines.every((line) => isPlace(line.kind));
    // Dots and outlines with about the same scale both ways: a map, which must keep it.
    const isMap = hasDotsOnly && Math.abs((all.x[1] - all.x[0]) / width * height / (all.y[1] - all.y[0]) - 1) < 0.25;
    let shown = {...all};

    // From what is shown to its place, and between a place, its value and where it was first drawn.
    const scale = (axis, from, to, value) => from + (to - from) * (value - shown[axis][0]) / (shown[axis][1] - shown[axis][0]);
    const valueX = (px) => shown.x[0] + (shown.x[1] - shown.x[0]) * (px - left) / (right - left);
    const valueY = (py) => shown.y[0] + (shown.y[1] - shown.y[0]) * (bottom - py) / (bottom - top);
    const drawnX = (value) => left + (right - left) * (value - all.x[0]) / (all.x[1] - all.x[0]);
    const drawnY = (value) => bottom - (bottom - top) * (value - all.y[0]) / (all.y[1] - all.y[0]);
    const digits = (axis) => Math.max(0, 3 - Math.ceil(Math.log10(shown[axis][1] - shown[axis][0])));

    const writtenX = (x) => isLogarithmic ? String(Number((10 ** x).toPrecision(3))) : written(x.toFixed(digits("x")));

    const layer = make("g", {class: "cursor", "aria-hidden": "true"}, svg);
    const back = make("rect", {x: left, y: top, width: right - left, height: bottom - top, class: "catch"}, svg);
    const at = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return {x: Math.min(Math.max(p.x, left), right), y: Math.min(Math.max(p.y, top), bottom)};
    };

    const read = (place) => written((all.y[0] + (all.y[1] - all.y[0]) * (bottom - place) / height).toFixed(digits("y")));
    // What stands at a place, in the order of the drawing: "name: value", of an area its edges, of a dot both coordinates.
    function readings(p) {
      const px = drawnX(valueX(p.x)), py = drawnY(valueY(p.y));
      const rows = [];
      for (const {name, kind, role, points} of lines) {
        let value = null;
        if (isPlace(kind)) {
          const dot = nearest(points, px, py, 14 * (shown.x[1] - shown.x[0]) / (all.x[1] - all.x[0]));
          if (dot) value = `${writtenX(all.x[0] + (all.x[1] - all.x[0]) * (dot.x - left) / width)} \u2192 ${read(dot.y)}`;
        } else {
          const heights = heightsAt(points, px);
          if (kind === "area" && name && heights.length > 1) value = `${read(Math.max(...heights))} to ${read(Math.min(...heights))}`;
          if (kind === "line" && heights.length > 0) value = read(heights[0]);
        }
        if (value !== null) rows.push({role, text: name ? `${name}: ${value}` : value});
      }
      return rows;
    }

    function showCursor(p) {
      layer.replaceChildren();
      make("path", {class: "ruler", d: `M${p.x} ${top}V${bottom}`}, layer);
      const rows = [{role: "", text: `${svg.dataset.xName}: ${writtenX(valueX(p.x))}`}, ...readings(p)];
      const box = make("rect", {class: "tag", rx: 4}, layer);
      const texts = rows.map(({role, text}, i) => {
        const element = make("text", {y: top + 16 + 15 * i, class: role.replace(/line|dots|area|many|beneath|dash\d/g, "")}, layer);
        element.textContent = text;
        return element;
      });
      const width = Math.max(...texts.map((text) => text.getBBox().width)) + 12;
      const x = p.x + 8 + width <= right ? p.x + 8 : Math.max(left, p.x - 8 - width);
      for (const text of texts) text.setAttribute("x", x + 6);
      for (const [key, value] of Object.entries({x, y: top + 2, width, height: 15 * rows.length + 6})) box.setAttribute(key, value);
    }

    function axes(zoomed) {
      for (const element of svg.querySelectorAll(":scope > .tick, :scope > .grid, :scope > text:not([class]), :scope > .mark, :scope > .level")) {
        element.style.display = zoomed ? "none" : "";
      }
      svg.querySelectorAll(":scope > .again").forEach((element) => element.remove());
      if (!zoomed) return;
      const again = make("g", {class: "again"}, svg);
      svg.insertBefore(again, curves);
      for (const [value, text] of (isLogarithmic ? decadeSteps : steps)(...shown.x, (right - left) / 90)) {
        const x = scale("x", left, right, value);
        make("path", {class: "tick", d: `M${x} ${bottom}v4`}, again);
        make("text", {x, y: bottom + 17, "text-anchor": "middle"}, again).textContent = written(text);
      }
      for (const [value, text] of steps(...shown.y, Math.max((bottom - top) / 40, 2))) {
        const y = scale("y", bottom, top, value);
        make("path", {class: "grid", d: `M${left} ${y}H${right}`}, again);
        make("text", {x: left - 8, y: y + 4, "text-anchor": "end"}, again).textContent = written(text);
      }
    }

    function show(x, y) {
      const zoomed = x !== all.x || y !== all.y;
      shown = {x, y};
      const [x0, x1, y0, y1] = [drawnX(x[0]), drawnX(x[1]), drawnY(y[1]), drawnY(y[0])];
      svg.classList.toggle("zoomed", zoomed);
      curves.setAttribute("viewBox", `${x0} ${y0} ${x1 - x0} ${y1 - y0}`);
      curves.setAttribute("preserveAspectRatio", "none");
      if (zoomed || overflow === null) curves.removeAttribute("overflow");
      else curves.setAttribute("overflow", overflow);
      axes(zoomed);
      layer.replaceChildren();
    }

    // A drag along a line is about its x; one across, or among dots, is about both, and a map keeps its shape.
    const isBox = (a, b) => isMap || Math.abs(a.y - b.y) > (hasDotsOnly ? 8 : 30);
    function boxOf(a, b) {
      if (!isBox(a, b)) return {x: [Math.min(a.x, b.x), Math.max(a.x, b.x)], y: [top, bottom]};
      if (!isMap) return {x: [Math.min(a.x, b.x), Math.max(a.x, b.x)], y: [Math.min(a.y, b.y), Math.max(a.y, b.y)]};
      const part = Math.min(1, Math.max(Math.abs(a.x - b.x) / width, Math.abs(a.y - b.y) / height));
      const within = (middle, from, size) => {
        const begin = Math.min(Math.max(middle - 0.5 * part * size, from), from + (1 - part) * size);
        return [begin, begin + part * size];
      };
      return {x: within(0.5 * (a.x + b.x), left, width), y: within(0.5 * (a.y + b.y), top, height)};
    }
    let from = null;
    back.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "mouse") from = at(event);
    });
    back.addEventListener("pointermove", (event) => {
      const p = at(event);
      showCursor(p);
      if (from) {
        const box = boxOf(from, p);
        make("rect", {class: "drag", x: box.x[0], width: box.x[1] - box.x[0], y: box.y[0], height: box.y[1] - box.y[0]}, layer);
      }
    });
    addEventListener("pointerup", (event) => {
      if (!from) return;
      const [a, b] = [from, at(event)];
      from = null;
      if (Math.abs(a.x - b.x) < 8 && !(isMap && Math.abs(a.y - b.y) >= 8)) return;
      const box = boxOf(a, b);
      show(box.x.map(valueX), isBox(a, b) ? [valueY(box.y[1]), valueY(box.y[0])] : shown.y);
    });
    back.addEventListener("pointerleave", () => from || layer.replaceChildren());
    back.addEventListener("dblclick", () => show(all.x, all.y));
  }

  document.querySelectorAll("svg.chart[data-x]").forEach(enliven);
  // Paper has no folds.
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
})();
