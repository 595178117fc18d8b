// SPDX-License-Identifier: MIT
// The rocket that turns as the flight did, beside one whose canards stay at trim, and what plays them.
function fantailScene(data, number, show) {
  "use strict";
  const element = (kind, properties, ...children) => {
    const made = Object.assign(document.createElement(kind), properties);
    made.append(...children);
    return made;
  };
  const turn = Math.PI / 180;
  const end = data.begin + data.step * (data.roll.length - 1);
  let time = data.shown;
  let speed = 1;
  let playing = false;
  let fresh = true;  // nobody has chosen a time yet

  // Between two samples on the line through them, as far as both are known.
  function at(values, t) {
    const place = (t - data.begin) / data.step;
    const before = Math.min(Math.max(Math.floor(place), 0), values.length - 1);
    const after = Math.min(before + 1, values.length - 1);
    const part = Math.min(Math.max(place - before, 0), 1);
    const [a, b] = [values[before], values[after]];
    return a == null || b == null ? null : (a + part * (b - a)) / 100;
  }

  function rocket(name, roll, canards, muted) {
    const canvas = element("canvas", {role: "img"});
    const angle = element("b");
    const turns = element("span");
    const box = element("figure", {}, element("figcaption", {}, element("span", {textContent: name}), angle, turns), canvas);
    const draw = fantailRocket(canvas);
    const words = () => {
      const degrees = at(roll, time);
      return degrees == null ? ["\u2013", "not known"]
        : [number(degrees.toFixed(1)) + "\u00b0", number((degrees / 360).toFixed(2)) + " turns from zero"];
    };
    return {
      box,
      draw() {
        [angle.textContent, turns.textContent] = words();
        draw((at(roll, time) ?? 0) * turn, canards.map((one) => { const degrees = at(one, time); return degrees == null ? null : degrees * turn; }), muted);
      },
      describe: () => canvas.setAttribute("aria-label", `${name}, ${number(time.toFixed(2))} s: rolled by ${words().join(", ")}`),
    };
  }

  const trim = Array.from({length: 4}, () => [0]);
  const rockets = [rocket(data.name, data.roll, data.canards, false)];
  if (data.free) rockets.push(rocket("Without control", data.free, trim, true));

  // --- where it is: only of a flight that knows ---
  const height = (t) => { const metres = at(data.path.height, t); return metres == null ? "\u2013" : number((10 * metres).toFixed(0)) + " m"; };
  function path() {
    const canvas = element("canvas", {role: "img"});
    const metres = element("b");
    const wind = data.path.wind?.words ?? "no wind";
    const draw = fantailPath(canvas, data.path);
    return {
      box: element("figure", {className: "path"},
        element("figcaption", {}, element("span", {textContent: "Height"}), metres, element("span", {textContent: wind})), canvas),
      draw() {
        metres.textContent = height(time);
        draw((time - data.begin) / data.step);
      },
      describe: () => canvas.setAttribute("aria-label", `Path at ${number(time.toFixed(2))} s: height ${height(time)}, ${wind}`),
    };
  }
  if (data.path) rockets.push(path());

  const play = element("button", {type: "button", className: "play"});
  const clock = element("output");
  const slider = element("input", {type: "range", min: data.begin, max: end, step: data.step / 2});
  slider.setAttribute("aria-label", "Time");
  const speeds = [.25, 1, 4].map((factor) => {
    const button = element("button", {type: "button", textContent: factor + "\u00d7"});
    button.setAttribute("aria-label", `${factor} times as fast as it was`);
    button.addEventListener("click", () => { speed = factor; press(); });
    return [factor, button];
  });
  function press() {
    for (const [factor, button] of speeds) button.setAttribute("aria-pressed", factor === speed);
    play.textContent = playing ? "Pause" : "Play";
  }

  function draw() {
    slider.value = time;
    clock.textContent = number(time.toFixed(2)) + " s";
    slider.setAttribute("aria-valuetext", clock.textContent);
    for (const one of rockets) one.draw();
    if (!playing) for (const one of rockets) one.describe();
  }

  /// Moves everything but the plots, which show this time already.
  function go(to) {
    fresh = false;
    time = Math.min(Math.max(to, data.begin), end);
    draw();
  }

  function stop() {
    playing = false;
    press();
    draw();
  }
  let last = 0;
  function tick(now) {
    if (!playing) return;
    const to = time + speed * Math.min(now - last, 100) / 1000;
    last = now;
    go(to);
    show(time);
    if (to >= end) stop();
    else requestAnimationFrame(tick);
  }
  play.addEventListener("click", () => {
    playing = !playing;
    press();
    if (!playing) return stop();
    if (fresh || time >= end) go(data.from);
    last = performance.now();
    requestAnimationFrame(tick);
  });
  slider.addEventListener("input", () => {
    const to = Number(slider.value);
    stop();  // which puts the slider where the rockets are
    go(to);
    show(time);
  });

  press();
  const bar = element("div", {className: "player"}, play, ...speeds.map(([, button]) => button), slider, clock);
  return {
    stage: element("div", {className: "stage"}, element("div", {className: "scene"}, ...rockets.map((one) => one.box)), bar,
      element("p", {className: "note", textContent: data.note})),
    draw, go, time: () => time, isPlaying: () => playing,
  };
}
