// SPDX-License-Identifier: MIT
// Plots of one flight (uPlot). They share a cursor, which says the time that the rocket is shown at.
"use strict";

const fantailPlots = (place, onTime) => {
  const shown = [
    {title: "Roll angle", unit: "deg", lines: [["truth", "true_roll_deg", "measured", []], ["reference", "reference_deg", "model", [7, 4]],
                                               ["where it settles", "settle_deg", "second", [3, 3]]]},
    {title: "Canards", unit: "deg", lines: [["mean of the encoders", "canard_deg", "measured", []], ["command", "command_deg", "model", [7, 4]]]},
    {title: "Roll rate", unit: "deg/s", lines: [["roll rate", "rate_deg_s", "measured", []]]},
    {title: "Height and speed", unit: "m, m/s", lines: [["height", "height_m", "measured", []], ["speed", "speed_m_s", "model", [7, 4]]]},
  ];
  const height = 170;
  let flight = null, span = [0, 1];

  // uPlot wants null where there is nothing.
  const list = (values) => Array.from(values, (value) => Number.isNaN(value) ? null : value);
  const data = (plot) => [list(flight.time_s), ...plot.lines.map(([, column]) => list(flight[column]))];

  function options(plot, width) {
    const {axes, y, series} = fantailPlotOptions(plot.lines);
    return {
      width, height, legend: {show: false},
      cursor: {sync: {key: "fantail"}, y: false, drag: {x: false, y: false}, points: {show: false}},
      hooks: {setCursor: [(chart) => { if (chart.cursor.event) onTime(chart.cursor.left >= 0 ? chart.posToVal(chart.cursor.left, "x") : null); }]},
      scales: {x: {time: false, range: () => span}, y}, axes, series,
    };
  }

  function build() {
    place.replaceChildren();
    for (const plot of shown) {
      const frame = fantailPlotFrame(plot);
      plot.at = frame.place;
      plot.at.setAttribute("aria-label", `${plot.title} over time since lift-off`);
      place.append(frame.holder);
      plot.chart = new uPlot(options(plot, plot.at.clientWidth), flight ? data(plot) : [[], ...plot.lines.map(() => [])], plot.at);
    }
  }

  // `columns`: a Float32Array by the name of each; `from` and `to`: which seconds are shown.
  function show(columns, from, to) {
    flight = columns;
    span = [from, to];
    for (const plot of shown) plot.chart.setData(data(plot));
  }

  build();
  new ResizeObserver(() => {
    for (const {chart, at} of shown) if (at.clientWidth > 0 && at.clientWidth !== chart.width) chart.setSize({width: at.clientWidth, height});
  }).observe(place);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", build);
  return {show};
};
