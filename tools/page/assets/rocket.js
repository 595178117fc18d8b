// SPDX-License-Identifier: MIT
// A rocket in three dimensions on a canvas: flat faces, the farthest first. x points to its nose, roll is positive from y to
// z, which is clockwise from behind.
function fantailRocket(canvas) {
  "use strict";
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const unit = (a) => { const length = Math.hypot(...a); return a.map((value) => value / length); };

  // Seen from behind, from the right and from above.
  const away = unit([.62, .72, -.34]);
  const right = unit(cross(away, [0, 0, 1]));
  const up = cross(right, away);
  const light = unit([-.35, -.35, .87]);

  // --- the body: rings of corners from tail to tip, [x, radius, name of the colour] of what begins there ---
  const sides = 24;
  const rings = [[-3.1, .34, "shell"], [-2.2, .34, "shell"], [1.15, .34, "band"], [1.75, .34, "nose"], [2.25, .3, "nose"],
    [2.7, .21, "nose"], [3.05, .1, "nose"], [3.2, .012, "nose"]];
  const faces = [];
  for (let ring = 0; ring + 1 < rings.length; ring++) {
    const [[x0, r0, name], [x1, r1]] = [rings[ring], rings[ring + 1]];
    for (let side = 0; side < sides; side++) {
      const corner = (x, r, angle) => [x, r * Math.cos(angle), r * Math.sin(angle)];
      const [a, b] = [side, side + 1].map((i) => 2 * Math.PI * i / sides);
      // A quarter of the body is painted, or nobody would see it roll.
      const painted = name === "shell" && side >= 3 && side < 9;
      faces.push({corners: [corner(x0, r0, a), corner(x0, r0, b), corner(x1, r1, b), corner(x1, r1, a)],
        name: painted ? "paint" : name});
    }
  }
  faces.push({corners: Array.from({length: sides}, (unused, i) => [-3.1, .34 * Math.cos(-2 * Math.PI * i / sides),
    .34 * Math.sin(-2 * Math.PI * i / sides)]), name: "tail"});

  // A fin in the plane of the axis and a direction: [along x, out from the axis].
  const fin = [[-3.1, .34], [-3.2, 1.0], [-2.65, 1.0], [-2.1, .34]];
  const canard = [[-.16, .36], [-.12, .86], [.06, .86], [.2, .36]];
  const shaft = 1.45;

  function blades(canards) {
    const all = [];
    for (let i = 0; i < 4; i++) {
      const angle = Math.PI / 2 * i;
      const [out, round] = [[0, Math.cos(angle), Math.sin(angle)], [0, -Math.sin(angle), Math.cos(angle)]];
      const put = (along, distance, turn) => [along * Math.cos(turn) , 0, 0].map((x, k) =>
        x + distance * out[k] + along * Math.sin(turn) * round[k]);
      all.push({corners: fin.map(([x, r]) => put(x, r, 0)), name: "fin", flat: true});
      // The leading edge goes where the force is to go.
      all.push({corners: canard.map(([x, r]) => { const at = put(x, r, canards[i] ?? 0); return [at[0] + shaft, at[1], at[2]]; }),
        name: canards[i] == null ? "unknown" : "canard", flat: true});
    }
    return all;
  }

  function palette(muted) {
    const [ink, paper] = [color("ink"), color("paper")];
    const mix = (part, of) => `color-mix(in srgb, ${of} ${part}%, ${paper})`;
    return muted
      ? {shell: mix(18, ink), paint: mix(55, ink), band: mix(28, ink), nose: mix(24, ink), tail: mix(60, ink), fin: mix(38, ink),
        canard: mix(48, ink), unknown: mix(20, ink)}
      : {shell: mix(14, color("measured")), paint: color("measured"), band: mix(40, color("neutral")), nose: mix(45, color("measured")),
        tail: mix(75, ink), fin: mix(72, color("measured")), canard: color("model"), unknown: mix(35, color("neutral"))};
  }

  /// Angles in radians; a canard that nobody knows is null and drawn pale at its trim.
  return function draw(roll, canards, muted) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    const scale = devicePixelRatio;
    if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
    if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
    const ctx = canvas.getContext("2d");
    ctx.setTransform(scale, 0, 0, scale, width * scale / 2, height * scale / 2);
    ctx.clearRect(-width / 2, -height / 2, width, height);
    const size = Math.min(width / 5.8, height / 3.4);
    const [c, s] = [Math.cos(roll), Math.sin(roll)];
    const colors = palette(muted);
    const drawn = [];
    for (const face of [...faces, ...blades(canards)]) {
      const corners = face.corners.map(([x, y, z]) => [x, c * y - s * z, s * y + c * z]);
      const normal = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
      const facing = dot(normal, away);
      if (!face.flat && facing > 0) continue;
      const depth = corners.reduce((sum, corner) => sum + dot(corner, away), 0) / corners.length;
      const lit = Math.abs(dot(normal, light)) * (face.flat || dot(normal, light) > 0 ? 1 : 0);
      drawn.push({corners, depth, shade: .42 * (1 - lit), fill: colors[face.name]});
    }
    drawn.sort((a, b) => b.depth - a.depth);
    ctx.lineJoin = "round";
    ctx.lineWidth = .7;  // or there are gaps between faces
    for (const {corners, shade, fill} of drawn) {
      ctx.beginPath();
      for (const corner of corners) {
        const near = size * 14 / (14 + dot(corner, away));
        ctx.lineTo(near * dot(corner, right) + .4 * size, -near * dot(corner, up) - .25 * size);  // its tail is near, and larger
      }
      ctx.closePath();
      ctx.fillStyle = ctx.strokeStyle = `color-mix(in srgb, black ${(100 * shade).toFixed(1)}%, ${fill})`;
      ctx.fill();
      ctx.stroke();
    }
  };
}
