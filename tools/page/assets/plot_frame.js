// SPDX-License-Identifier: MIT
// What the live page and the playground have around and behind the lines of a plot.
"use strict";

// A number that was made text: a minus as wide as a figure, and none before zeros.
const fantailNumber = (text) => text.replace(/^-(?=[0.]*$)/, "").replace(/^-/, "\u2212");

// {title, unit, lines: [[name, column, role, dashes], ...]} -> {holder, place}: a heading with a key of each line, and where uPlot is
// to draw.
function fantailPlotFrame({title, unit, lines}) {
  const heading = document.createElement("h3");
  heading.append(`${title}, ${unit}`);
  for (const [name, , role, dashes] of lines) {
    const key = document.createElement("span");
    const swatch = Object.assign(document.createElement("i"), {className: dashes.length > 0 ? "dashed" : ""});
    swatch.style.setProperty("--role", `var(--${role})`);
    key.append(swatch, name);
    heading.append(key);
  }
  const holder = Object.assign(document.createElement("div"), {className: "plot"});
  const place = document.createElement("div");
  place.setAttribute("role", "img");
  place.setAttribute("aria-label", title);
  holder.append(heading, place);
  return {holder, place};
}

// Options of uPlot: both axes, room above and below the lines, and the lines.
function fantailPlotOptions(lines) {
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const axis = {stroke: color("soft"), font: "11px system-ui, sans-serif", grid: {stroke: color("line"), width: 1}, ticks: {show: false}};
  const values = (unit) => (chart, ticks) => ticks.map((tick) => fantailNumber(String(tick)) + unit);
  return {
    axes: [{...axis, size: 24, space: 60, values: values(" s")}, {...axis, size: 46, gap: 4, space: 24, values: values("")}],
    y: {range: (chart, low, high) => {
      if (low == null) return [-1, 1];
      const margin = Math.max((high - low) * .08, .5);
      return [low - margin, high + margin];
    }},
    series: [{}, ...lines.map(([, , role, dashes]) =>
      ({stroke: color(role), width: dashes.length > 0 ? 1.5 : 2, dash: dashes, points: {show: false}}))],
  };
}
