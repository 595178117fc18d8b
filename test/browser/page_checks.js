// SPDX-License-Identifier: MIT
// What pages_test.py asks of a page that is open; each answer is a list of sentences, empty when all is well.
window.fantailChecks = (() => {
  "use strict";
  const slack_px = 1.5;
  const named = (element) => `${element.tagName.toLowerCase()}${element.id ? "#" + element.id : ""}`
    + `${element.className?.length ? "." + element.className.trim().replaceAll(" ", ".") : ""}`
    + ` "${(element.textContent ?? "").trim().slice(0, 40)}"`;
  const shown = (element) => element.getClientRects().length > 0 && getComputedStyle(element).visibility !== "hidden";
  const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
  const cuts = (element) => ["hidden", "clip"].includes(getComputedStyle(element).overflowX);

  function holderOf(element) {
    for (let at = element.parentElement; at && at !== document.body; at = at.parentElement) {
      if (scrolls(at) || cuts(at)) return at;
    }
    return null;
  }

  // Nothing is cut off, and what scrolls shows that it does.
  function cutOff(width_px) {  // of the screen: a telephone shows a wider page smaller, and innerWidth grows with it
    const said = [];
    const page = document.documentElement;
    if (page.scrollWidth > width_px) said.push(`the page is ${page.scrollWidth} px wide`);
    for (const element of document.body.querySelectorAll("*")) {
      if (element.closest("script, style, svg svg, title") || !shown(element) || (element.ownerSVGElement && element.tagName !== "text")) continue;
      const box = element.getBoundingClientRect();
      if (box.width <= 1 || box.height <= 1) continue;
      const holder = element.ownerSVGElement ?? holderOf(element);
      if (holder && holder.tagName !== "svg" && scrolls(holder)) continue;
      const room = holder ? holder.getBoundingClientRect() : {left: 0, right: width_px, top: -1e9, bottom: 1e9};
      const out = Math.max(room.left - box.left, box.right - room.right, holder ? room.top - box.top : 0, holder ? box.bottom - room.bottom : 0);
      if (out > slack_px) said.push(`${named(element)} is cut off by ${out.toFixed(1)} px`);
    }
    for (const element of document.body.querySelectorAll("*")) {
      if (!shown(element) || !scrolls(element) || element.scrollWidth <= element.clientWidth + 1) continue;
      if (!getComputedStyle(element).backgroundImage.includes("gradient")) said.push(`${named(element)} scrolls without a cue`);
      const first = element.querySelector("tbody th, tbody td");
      if (first && getComputedStyle(first).position !== "sticky") said.push(`${named(element)}: the first column does not stay`);
      if (first && first.getBoundingClientRect().width > .55 * element.clientWidth) said.push(`${named(element)}: the first column leaves no room`);
    }
    return said;
  }

  function blankRows() {
    return [...document.querySelectorAll("tr")].filter((row) => shown(row) && !row.textContent.trim()).map(() => "a blank row");
  }

  // No two texts of a drawing or of the strip of events lie on each other.
  function overlaps() {
    const said = [];
    for (const group of document.querySelectorAll("svg, .timeline")) {
      const texts = [...group.querySelectorAll("text, span")].filter((text) => shown(text) && text.textContent.trim())
        .map((text) => [text, text.getBoundingClientRect()]);
      texts.forEach(([text, a], i) => {
        for (const [other, b] of texts.slice(i + 1)) {
          const [x, y] = [Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)];
          if (x > 2 && y > 4) said.push(`${named(text)} lies on ${named(other)}`);
        }
      });
    }
    return said;
  }

  // A canvas is a picture with a name that has figures in it.
  function unnamedCanvases() {
    return [...document.querySelectorAll("canvas")].filter((canvas) =>
      !/[0-9]/.test(canvas.closest("[role=img]")?.getAttribute("aria-label") ?? "")).map((canvas) => `${named(canvas.parentElement)}: a canvas without a name with figures`);
  }

  function tooSmall() {
    const least_px = 7;  // from the top of a letter to the foot of another
    return [...document.querySelectorAll("svg text")].filter((text) => shown(text) && text.textContent.trim() && text.getBoundingClientRect().height < least_px)
      .map((text) => `${named(text)} is ${text.getBoundingClientRect().height.toFixed(1)} px high`);
  }

  return {all: (width_px) => [...cutOff(width_px), ...tooSmall(), ...blankRows(), ...overlaps(), ...unnamedCanvases()]};
})();
