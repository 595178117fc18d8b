// SPDX-License-Identifier: MIT
// What both live pages have: a connection that tries again, columns for uPlot, and plots that fit. Nothing goes the other way.
"use strict";

// Frames of /events: take(frame) for each, lost() when the connection has gone.
function fantailListen(take, lost) {
  const source = new EventSource("events");
  source.addEventListener("page", (message) => {  // another program may be served by now where this page came from
    const page = JSON.parse(message.data);
    if (page.page !== document.body.dataset.page || page.version !== document.getElementById("version").textContent) {
      location.reload();
      return;
    }
    document.title = page.title;
    for (const id of ["source", "command"]) {
      const at = document.getElementById(id);
      if (at) at.textContent = page[id];
    }
  });
  source.onmessage = (message) => take(JSON.parse(message.data));
  source.onerror = () => {  // a browser tries again by itself, but not after every kind of failure
    source.close();
    lost();
    setTimeout(fantailListen, 1000, take, lost);
  };
}

// Puts a stretch of plot_history.hpp behind `columns` (times first). No line is drawn over a longer gap.
function fantailAddStretch(columns, row) {
  const longest_line_s = 0.25;
  const [begin, end, times] = [row[0] / 1000, row[1] / 1000, columns[0]];
  if (times.length > 0 && begin - times[times.length - 1] > longest_line_s) {
    times.push((begin + times[times.length - 1]) / 2);
    for (const column of columns.slice(1)) column.push(null);
  }
  for (const which of end > begin ? [0, 1] : [1]) {
    times.push(which === 0 ? begin : end);
    for (let i = 1; i < columns.length; i++) {
      const value = row[2 * i + which];
      columns[i].push(value === null ? null : value / 100);
    }
  }
}

// Builds the plots in `holder` (each then has chart and place), as wide as their places and in the colours of the screen.
function fantailKeepPlots(holder, plots, height, build) {
  build();
  new ResizeObserver(() => {
    for (const {chart, place} of plots) {
      if (place.clientWidth > 0 && place.clientWidth !== chart.width) chart.setSize({width: place.clientWidth, height});
    }
  }).observe(holder);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", build);
}
