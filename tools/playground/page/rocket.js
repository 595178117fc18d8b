// SPDX-License-Identifier: MIT
// The rocket as a drawing: it lies on its side, nose to the right, and turns about its long axis with the roll angle.
"use strict";

const fantailRocket = (canvas) => {
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const radius = 11;

  // A flat plate at an angle around the body: its root on the skin, its tip further out. `turned` is about its own shaft.
  function plate(context, around, {front, chord, sweep, span, tip, turned = 0}, fill) {
    const up = Math.cos(around);         // which way it stands, seen from the side
    const towards = Math.sin(around);    // above zero: on our side of the body
    const middle = front - chord / 2;
    // Its outline along the body and outwards; turned about the middle of its root, what moves across is seen by `towards`.
    const outline = [[front, radius], [front - sweep, radius + span], [front - sweep - tip, radius + span], [front - chord, radius]];
    context.beginPath();
    for (const [x, out] of outline) {
      const along = (x - middle) * Math.cos(turned);
      const across = (x - middle) * Math.sin(turned);
      context.lineTo(middle + along, -out * up + across * towards);
    }
    context.closePath();
    context.fillStyle = fill;
    context.globalAlpha = towards > 0 ? 1 : 0.45;
    context.fill();
    context.stroke();
    context.globalAlpha = 1;
  }

  // A stripe along the body: which side of it we see.
  function stripe(context, around, from, to) {
    if (Math.sin(around) <= 0) return;
    const y = -radius * Math.cos(around);
    context.beginPath();
    context.moveTo(from, y);
    context.lineTo(to, y);
    context.lineWidth = 2.5 * Math.sin(around);
    context.strokeStyle = color("model");
    context.stroke();
  }

  // Angles in degrees; a positive canard angle rolls it positively. What is not known is drawn at zero.
  function draw(rollDegrees, canardDegrees) {
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const scale = Math.min(width / 320, height / 92) * ratio;
    context.setTransform(scale, 0, 0, scale, canvas.width / 2, canvas.height / 2);
    context.lineJoin = "round";
    const roll = (rollDegrees || 0) * Math.PI / 180;
    const deflection = (canardDegrees || 0) * Math.PI / 180;
    const around = [0, 1, 2, 3].map((i) => roll + i * Math.PI / 2);
    const plates = (behind) => {
      for (const angle of around.filter((angle) => (Math.sin(angle) <= 0) === behind)) {
        context.lineWidth = 1;
        context.strokeStyle = color("ink");
        plate(context, angle, {front: -92, chord: 44, sweep: 26, span: 24, tip: 22}, color("wash"));
        context.strokeStyle = color("measured");
        plate(context, angle, {front: 92, chord: 20, sweep: 6, span: 17, tip: 11, turned: deflection}, color("measured"));
      }
    };
    plates(true);
    context.beginPath();
    context.moveTo(-145, -radius);
    context.lineTo(102, -radius);
    context.bezierCurveTo(130, -radius, 148, -4, 152, 0);
    context.bezierCurveTo(148, 4, 130, radius, 102, radius);
    context.lineTo(-145, radius);
    context.closePath();
    context.fillStyle = color("wash");
    context.fill();
    context.lineWidth = 1.2;
    context.strokeStyle = color("ink");
    context.stroke();
    for (let i = 0; i < 4; i++) if (i !== 2) stripe(context, roll + Math.PI / 4 + i * Math.PI / 2, i === 0 ? -140 : -60, i === 0 ? 100 : -20);
    plates(false);
    canvas.setAttribute("aria-label", `The rocket at a roll angle of ${(rollDegrees || 0).toFixed(0)} degrees, canards at ${(canardDegrees || 0).toFixed(1)}`);
  }

  return {draw};
};
