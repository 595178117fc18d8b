// SPDX-License-Identifier: MIT
// The way of a rocket above the ground, seen from the south and from above, with one scale for all directions.
function fantailPath(canvas, path) {
  "use strict";
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  const turned = Math.PI / 7;
  const raised = Math.PI / 9;
  // Right and up on the canvas, of metres to the east, to the north and upwards.
  const seen = (east, north, height) => {
    const deep = Math.sin(turned) * east + Math.cos(turned) * north;
    return [Math.cos(turned) * east - Math.sin(turned) * north, Math.cos(raised) * height + Math.sin(raised) * deep];
  };
  const points = path.height.map((height, i) => height == null ? null : [path.east[i] / 10, path.north[i] / 10, height / 10]);
  const known = points.filter(Boolean);
  const reach = Math.max(20, ...known.map(([east, north]) => Math.hypot(east, north)), .12 * Math.max(...known.map((point) => point[2])));
  const ground = [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]];
  const corners = [...ground.map(([east, north]) => seen(east, north, 0)), ...known.map((point) => seen(...point))];
  const [left, right] = [Math.min(...corners.map((c) => c[0])), Math.max(...corners.map((c) => c[0]))];
  const [low, high] = [Math.min(...corners.map((c) => c[1])), Math.max(...corners.map((c) => c[1]))];

  /// `place`: how many samples from the first one, not a whole number.
  return function draw(place) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    const scale = devicePixelRatio;
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    const ctx = canvas.getContext("2d");
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
    const size = Math.min((width - 90) / (right - left), (height - 24) / (high - low));
    const at = (point) => {
      const [x, y] = seen(...point);
      return [width / 2 + size * (x - (left + right) / 2), height - 14 - size * (y - low)];
    };
    const line = (list, stroke, thick, dash = []) => {
      ctx.beginPath();
      for (const point of list) ctx.lineTo(...at(point));
      Object.assign(ctx, {strokeStyle: stroke, lineWidth: thick, lineJoin: "round", lineCap: "round"});
      ctx.setLineDash(dash);
      ctx.stroke();
    };
    ctx.beginPath();
    for (const [east, north] of ground) ctx.lineTo(...at([east, north, 0]));
    ctx.fillStyle = color("wash");
    ctx.fill();
    line([...ground, ground[0]].map(([east, north]) => [east, north, 0]), color("line"), 1);
    line([[0, -reach, 0], [0, reach, 0]], color("line"), 1);
    line([[-reach, 0, 0], [reach, 0, 0]], color("line"), 1);
    ctx.font = "11px system-ui, sans-serif";
    ctx.fillStyle = color("soft");
    const [x, y] = at([0, 1.12 * reach, 0]);
    ctx.fillText("N", x - 3, y + 2);
    if (path.wind) {  // blows across the middle of the ground's far edge
      const to = [Math.sin(path.wind.to), Math.cos(path.wind.to)];
      const tip = [to[0] * reach * .8, to[1] * reach * .8, 0];
      line([[-tip[0], -tip[1], 0], tip], color("second"), 2);
      for (const side of [-.25, .25]) {
        const [c, s] = [Math.cos(side), Math.sin(side)];
        line([tip, [tip[0] - .4 * reach * (c * to[0] - s * to[1]), tip[1] - .4 * reach * (s * to[0] + c * to[1]), 0]], color("second"), 2);
      }
    }
    line(known, color("neutral"), 1);
    const end = Math.max(0, Math.min(Math.floor(place), points.length - 1));
    const flown = points.slice(0, end + 1).filter(Boolean);
    if (flown.length === 0) return;
    line(flown, color("measured"), 2.5);
    const here = flown[flown.length - 1];
    line([here, [here[0], here[1], 0]], color("neutral"), 1, [3, 3]);
    ctx.beginPath();
    ctx.arc(...at(here), 4.5, 0, 2 * Math.PI);
    ctx.fillStyle = color("model");
    ctx.fill();
  };
}
