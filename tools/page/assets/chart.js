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

  // Between two points of a line; nothing in a gap.
  function heightAt(points, x) {
    for (let i = 1; i < points.length; ++i) {
      const [a, b] = [points[i - 1], points[i]];
      if (!b.moved && a.x <= x && x <= b.x) return b.x > a.x ? a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) : b.y;
    }
    return null;
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

  function enliven(svg) {
    const [left, top, right, bottom] = svg.dataset.frame.split(" ").map(Number);
    const all = {x: svg.dataset.x.split(" ").map(Number), y: svg.dataset.y.split(" ").map(Number)};
    const curves = svg.querySelector("svg.curves");
    const lines = [...curves.querySelectorAll("path[data-name]")].map((path) => ({
      name: path.dataset.name, dots: path.classList.contains("dots"), role: path.getAttribute("class"), points: pointsOf(path)}));
    if (lines.length === 0) return;
    const clips = curves.getAttribute("overflow");
    let shown = {x: all.x, y: all.y};

    // From the drawing as it was made to what is shown of it.
    const scale = (axis, from, to, value) => from + (to - from) * (value - shown[axis][0]) / (shown[axis][1] - shown[axis][0]);
    const valueX = (px) => shown.x[0] + (shown.x[1] - shown.x[0]) * (px - left) / (right - left);
    const valueY = (py) => shown.y[0] + (shown.y[1] - shown.y[0]) * (bottom - py) / (bottom - top);
    const drawnX = (value) => left + (right - left) * (value - all.x[0]) / (all.x[1] - all.x[0]);
    const drawnY = (value) => bottom - (bottom - top) * (value - all.y[0]) / (all.y[1] - all.y[0]);
    const digits = (axis) => Math.max(0, 3 - Math.ceil(Math.log10(shown[axis][1] - shown[axis][0])));

    const layer = make("g", {class: "cursor", "aria-hidden": "true"}, svg);
    const back = make("rect", {x: left, y: top, width: right - left, height: bottom - top, class: "catch"}, svg);
    const at = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return {x: Math.min(Math.max(p.x, left), right), y: Math.min(Math.max(p.y, top), bottom)};
    };

    function readings(p) {
      const px = drawnX(valueX(p.x)), py = drawnY(valueY(p.y));
      const rows = [];
      for (const line of lines) {
        const dot = line.dots ? nearest(line.points, px, py, 14 * (shown.x[1] - shown.x[0]) / (all.x[1] - all.x[0])) : null;
        const height = line.dots ? dot && dot.y : heightAt(line.points, px);
        if (height === null || height === undefined) continue;
        const value = all.y[0] + (all.y[1] - all.y[0]) * (bottom - height) / (bottom - top);
        const x = dot ? all.x[0] + (all.x[1] - all.x[0]) * (dot.x - left) / (right - left) : null;
        const before = x === null ? "" : written(x.toFixed(digits("x"))) + " \u2192 ";
        rows.push({role: line.role, text: `${line.name ? line.name + ": " : ""}${before}${written(value.toFixed(digits("y")))}`});
      }
      return rows;
    }

    function showCursor(p) {
      layer.replaceChildren();
      make("path", {class: "ruler", d: `M${p.x} ${top}V${bottom}`}, layer);
      const rows = [{role: "", text: `${svg.dataset.xName}: ${written(valueX(p.x).toFixed(digits("x")))}`}, ...readings(p)];
      const box = make("rect", {class: "tag", rx: 4}, layer);
      const texts = rows.map(({role, text}, i) => {
        const element = make("text", {y: top + 16 + 15 * i, class: role.replace(/line|dots|many|lone|beneath|dash\d/g, "")}, layer);
        element.textContent = text;
        return element;
      });
      const width = Math.max(...texts.map((text) => text.getBBox().width)) + 12;
      const x = p.x + 8 + width <= right ? p.x + 8 : Math.max(left, p.x - 8 - width);
      for (const text of texts) text.setAttribute("x", x + 6);
      for (const [key, value] of Object.entries({x, y: top + 2, width, height: 15 * rows.length + 6})) box.setAttribute(key, value);
    }

    function axes() {
      for (const element of svg.querySelectorAll(":scope > .tick, :scope > .grid, :scope > .at, :scope > .mark, :scope > .level")) {
        element.style.display = shown.zoomed ? "none" : "";
      }
      svg.querySelectorAll(":scope > .again").forEach((element) => element.remove());
      if (!shown.zoomed) return;
      const again = make("g", {class: "again"}, svg);
      svg.insertBefore(again, curves);
      for (const [value, text] of steps(...shown.x, (right - left) / 90)) {
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
      shown = {x, y, zoomed};
      const [x0, x1, y0, y1] = [drawnX(x[0]), drawnX(x[1]), drawnY(y[1]), drawnY(y[0])];
      svg.classList.toggle("zoomed", zoomed);
      curves.setAttribute("viewBox", `${x0} ${y0} ${x1 - x0} ${y1 - y0}`);
      if (zoomed || clips === null) curves.removeAttribute("overflow");
      else curves.setAttribute("overflow", clips);
      axes();
      layer.replaceChildren();
    }

    let from = null;
    back.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "mouse") from = at(event);
    });
    back.addEventListener("pointermove", (event) => {
      const p = at(event);
      showCursor(p);
      if (from) {
        const high = Math.abs(p.y - from.y) > 30;
        make("rect", {class: "drag", x: Math.min(from.x, p.x), width: Math.abs(p.x - from.x), y: high ? Math.min(from.y, p.y) : top,
          height: high ? Math.abs(p.y - from.y) : bottom - top}, layer);
      }
    });
    addEventListener("pointerup", (event) => {
      if (!from) return;
      const [a, b] = [from, at(event)];
      from = null;
      if (Math.abs(a.x - b.x) < 8) return;
      const sorted = (p, q) => p < q ? [p, q] : [q, p];
      show(sorted(valueX(a.x), valueX(b.x)), Math.abs(a.y - b.y) > 30 ? sorted(valueY(a.y), valueY(b.y)) : shown.y);
    });
    back.addEventListener("pointerleave", () => from || layer.replaceChildren());
    back.addEventListener("dblclick", () => show(all.x, all.y));
  }

  document.querySelectorAll("svg.chart[data-frame]").forEach(enliven);
  // Paper has no folds.
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
})();
