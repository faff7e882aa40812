// The path on a canvas, or in space by plotly. What it draws are the points that the engine gives.
"use strict";

const HOLE = 3; // pixels
const VIEWS = { xy: ["x", "y"], zx: ["z", "x"], yz: ["y", "z"] };

/** The ends of a path's pieces before the step `until`, of rapid moves or of the others. */
function* pieces({ path, until }, isRapid) {
  for (let i = 1; i < path.x.length && path.step[i] < until; ++i)
    if (!path.begins[i] && (path.kind[i] === 0) === isRapid) yield i;
}

/** Draw paths, [{path, until, rapid, cut}], each to its step `until`, in a plane. */
function drawPlane(canvas, paths, view, colours) {
  const scale = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const to = canvas.getContext("2d");
  to.scale(scale, scale);
  const [a, b] = VIEWS[view];
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { path } of paths)
    for (let i = 0; i < path.x.length; ++i) {
      left = Math.min(left, path[a][i]);
      right = Math.max(right, path[a][i]);
      low = Math.min(low, path[b][i]);
      high = Math.max(high, path[b][i]);
    }
  if (!(left <= right)) return; // nothing is drawn
  const size = Math.min((width - 60) / Math.max(right - left, 1e-6), (height - 50) / Math.max(high - low, 1e-6));
  const px = (value) => width / 2 + (value - (left + right) / 2) * size;
  const py = (value) => height / 2 - (value - (low + high) / 2) * size;
  to.font = "12px system-ui";
  to.fillStyle = colours.front;
  to.fillText(`${a.toUpperCase()} ${left.toFixed(3)} to ${right.toFixed(3)}   ${b.toUpperCase()} ${low.toFixed(3)} to ${high.toFixed(3)}`, 8, height - 8);
  for (const one of paths)
    for (const isRapid of [true, false]) {
      const { path, cut, rapid } = one;
      to.beginPath();
      to.strokeStyle = isRapid ? rapid : cut;
      to.lineWidth = isRapid ? 1 : 1.6;
      to.setLineDash(isRapid ? [4, 3] : []);
      for (const i of pieces(one, isRapid)) {
        const [x, y] = [px(path[a][i]), py(path[b][i])];
        to.moveTo(px(path[a][i - 1]), py(path[b][i - 1]));
        to.lineTo(x, y);
        const seen = [a, b].some((axis) => path[axis][i] !== path[axis][i - 1]);
        if (isRapid || seen) continue;
        to.moveTo(x + HOLE, y); // a cut along the line of sight, such as a hole, is a ring
        to.arc(x, y, HOLE, 0, 7);
      }
      to.stroke();
    }
  const { path, until } = paths[0];
  let tool = -1;
  while (tool + 1 < path.x.length && path.step[tool + 1] < until) ++tool;
  if (tool < 0) return;
  to.beginPath();
  to.setLineDash([]);
  to.fillStyle = colours.mark;
  to.arc(px(path[a][tool]), py(path[b][tool]), 4, 0, 7);
  to.fill();
}

let plotly = null;

/** Load plotly from the folder, once. */
function loadPlotly() {
  plotly = plotly || new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = "plotly.min.js";
    script.onload = () => done(window.Plotly);
    script.onerror = () => failed(new Error("plotly.min.js is not in the folder of the page"));
    document.head.append(script);
  });
  return plotly;
}

async function drawSpace(element, paths, colours) {
  const Plotly = await loadPlotly();
  const lines = paths.flatMap((one) => [true, false].map((isRapid) => {
    const { path, cut, rapid, name } = one;
    const of = { x: [], y: [], z: [] };
    for (const i of pieces(one, isRapid))
      for (const axis of ["x", "y", "z"]) of[axis].push(path[axis][i - 1], path[axis][i], null);
    return { type: "scatter3d", mode: "lines", ...of, name: `${name}: ${isRapid ? "rapid" : "feed"}`, hoverinfo: "x+y+z",
      line: { color: isRapid ? rapid : cut, width: isRapid ? 2 : 4 } };
  }));
  const axis = (title) => ({ title: { text: title }, color: colours.front, gridcolor: colours.rapid });
  await Plotly.react(element, lines, { margin: { l: 0, r: 0, t: 0, b: 0 }, paper_bgcolor: colours.back, font: { color: colours.front },
    uirevision: "kept", scene: { aspectmode: "data", xaxis: axis("X"), yaxis: axis("Y"), zaxis: axis("Z") } }, { responsive: true, displaylogo: false });
}
