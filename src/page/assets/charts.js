// Charts: a quantity along the curve, and the error by the number of segments.

/** Round steps that cut [low, high] into about `count` parts. */
function ticks(low, high, count) {
  const rough = (high - low) / count || 1, size = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map(x => x * size).find(x => x >= rough * .999) || size;
  const result = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i++) result.push(i * step);
  return result;
}

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const tenTo = n => n === 0 ? "1" : n === 1 ? "10" : `10${[...String(n)].map(c => RAISED[c]).join("")}`;

/** The labels of ticks, with as many decimals as their step has, and the power of ten that they are in. */
function labels(values) {
  const largest = Math.max(...values.map(Math.abs), 0);
  const exponent = largest === 0 ? 0 : Math.floor(Math.log10(largest) + 1e-9);
  const power = exponent < -2 || exponent > 4 ? exponent : 0;
  const step = (values[1] - values[0] || 1) / 10 ** power;
  const decimals = [0, 1, 2, 3, 4, 5, 6].find(d => Math.abs(step * 10 ** d - Math.round(step * 10 ** d)) < 1e-6) ?? 6;
  return { power, texts: values.map(v => (v / 10 ** power).toFixed(decimals).replace("-", "−")) };
}

/** A sheet of the size of its place, with room for axes; words keep the size of the page's. */
function sheet(place, titled) {
  const width = Math.max(place.clientWidth, 240), height = Math.max(place.clientHeight, 160);
  const em = parseFloat(getComputedStyle(place).fontSize) * .78;
  const frame = { left: 4.6 * em, right: width - 1.7 * em, top: 1.9 * em, bottom: height - 3.4 * em };
  const picture = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-labelledby": titled });
  return { picture, frame, em, width, height };
}

const words = (x, y, text, attributes = {}) => svg("text", { x: short(x), y: short(y), ...attributes }, text);

/** The quantity's range with a little room, never empty. */
function rangeOf(values) {
  let low = Math.min(...values), high = Math.max(...values);
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low <= 1e-7 * size || size === 0) {
    const margin = size === 0 ? 1 : size * .1;
    [low, high] = [low - margin, high + margin];
  }
  const room = .06 * (high - low);
  return [low - room, high + room];
}

/** Draws series of (degrees, value) along the curve. `filled` paints what lies between the first and 0 by its sign. */
function drawAlong(place, titled, series, joints, unit, filled) {
  const { picture, frame, em, height } = sheet(place, titled);
  const all = series.flatMap(one => one.parts.flat()).filter(([, y]) => Number.isFinite(y));
  const [x0, x1] = [Math.min(...joints), Math.max(...joints)];
  const [y0, y1] = rangeOf(all.map(([, y]) => y).concat(filled ? [0] : []));
  const X = x => frame.left + (x - x0) / (x1 - x0) * (frame.right - frame.left);
  const Y = y => frame.bottom - (y - y0) / (y1 - y0) * (frame.bottom - frame.top);
  const levels = ticks(y0, y1, Math.max(3, (frame.bottom - frame.top) / (2.6 * em))), said = labels(levels);
  levels.forEach((level, i) => {
    picture.append(svg("path", { class: level === 0 ? "axis" : "grid", d: `M${frame.left} ${short(Y(level))}H${frame.right}` }));
    picture.append(words(frame.left - .5 * em, Y(level) + .35 * em, said.texts[i], { "text-anchor": "end" }));
  });
  const scale = said.power ? `× ${tenTo(said.power)} ${unit}` : unit;
  picture.append(words(frame.left, frame.top - .7 * em, scale));
  const count = (frame.right - frame.left) / (5 * em);
  const turn = [1, 2, 5, 10, 15, 30, 45, 60, 90, 180].find(step => (x1 - x0) / step <= count) || 360;
  for (let i = Math.ceil(x0 / turn - 1e-9); i * turn <= x1 + 1e-9; i++) {
    picture.append(svg("path", { class: "axis", d: `M${short(X(i * turn))} ${frame.bottom}v${.4 * em}` }));
    picture.append(words(X(i * turn), frame.bottom + 1.5 * em, `${String(i * turn).replace("-", "−")}°`, { "text-anchor": "middle" }));
  }
  for (const joint of joints.length <= 37 ? joints : []) {
    picture.append(svg("path", { class: "grid", d: `M${short(X(joint))} ${frame.top}V${frame.bottom}` }));
  }
  picture.append(words((frame.left + frame.right) / 2, height - .4 * em, "angle about the centre; vertical lines are joints", { "text-anchor": "middle" }));
  if (filled) {
    for (const [side, clip] of [["outward", d => Math.max(d, 0)], ["inward", d => Math.min(d, 0)]]) {
      const areas = series[0].parts.map(part =>
        `M${short(X(part[0][0]))} ${short(Y(0))}${part.map(([x, y]) => `L${short(X(x))} ${short(Y(clip(y)))}`).join("")}L${short(X(part.at(-1)[0]))} ${short(Y(0))}Z`);
      picture.append(svg("path", { class: side, style: "stroke:none", d: areas.join("") }));
    }
  }
  for (const one of [...series].reverse()) {
    const d = one.parts.map(part => polyline(part.map(([x, y]) => [X(x), Y(y)]))).join("");
    picture.append(svg("path", { class: `series ${one.kind}`, d }));
  }
  place.replaceChildren(picture);
}

/** What the charts along the curve show of a drawing: the parts of the distance, and of the curvature and its derivatives. */
function alongOf(drawing, step, joints) {
  const frame = frameOf(step.shape), { segments } = readPath(drawing.path);
  const sense = Math.sign(step.shape.sweep) || 1;
  const degrees = (number, t) => {
    const from = joints[number], to = joints[number + 1];
    const rough = from + t * (to - from), angle = frame.angle(pointAt(segments[number], t));
    return angle + 360 * Math.round((rough - angle) / 360);
  };
  const distance = distances(drawing, frame).map((profile, number) => profile.map(([t, d]) => [degrees(number, t), d]));
  const curvature = [0, 1, 2].map(order => segments.map((segment, number) => {
    const part = [];
    for (let i = 0; i <= 64; i++) {
      const value = curvatureAt(segment, i / 64)[order];
      if (Number.isFinite(value)) part.push([degrees(number, i / 64), value * sense]);
    }
    return part;
  }).filter(part => part.length));
  return { distance, curvature };
}

/** Draws the error by the number of segments, both axes logarithmic. */
function drawCounts(place, view, label, choose) {
  const { picture, frame, em, height } = sheet(place, "counts-title");
  frame.right -= 7.5 * em;
  const counts = view.choice.counts;
  const lines = view.page.methods.map(({ id }) => ({
    id,
    kind: id === view.method ? "chosen" : id === view.beside ? "beside" : "",
    points: counts.map(n => [n, view.find(id, n)?.figures[view.criterion]]).filter(([, y]) => y > 2e-15),
  })).filter(line => line.points.length);
  const values = lines.flatMap(line => line.points.map(([, y]) => y));
  const [n0, n1] = [Math.min(...counts) / 1.08, Math.max(...counts) * 1.08];
  const [y0, y1] = values.length ? [Math.min(...values) / 1.5, Math.max(...values) * 1.5] : [1e-6, 1];
  const log = (x, low, high) => Math.log(x / low) / Math.log(high / low);
  const X = n => frame.left + log(n, n0, n1) * (frame.right - frame.left);
  const Y = y => frame.bottom - log(y, y0, y1) * (frame.bottom - frame.top);
  const every = Math.max(1, Math.ceil(Math.log10(y1 / y0) / ((frame.bottom - frame.top) / (2.2 * em))));
  for (let e = Math.ceil(Math.log10(y0)); e <= Math.log10(y1); e++) {
    picture.append(svg("path", { class: "grid", d: `M${frame.left} ${short(Y(10 ** e))}H${frame.right}` }));
    if (e % every === 0) picture.append(words(frame.left - .5 * em, Y(10 ** e) + .35 * em, tenTo(e), { "text-anchor": "end" }));
  }
  for (const n of counts) {
    picture.append(svg("path", { class: "grid", d: `M${short(X(n))} ${frame.top}V${frame.bottom}` }));
    picture.append(words(X(n), frame.bottom + 1.5 * em, n, { "text-anchor": "middle" }));
  }
  picture.append(words(frame.left, frame.top - .7 * em, label));
  picture.append(words((frame.left + frame.right) / 2, height - .4 * em, "segments", { "text-anchor": "middle" }));
  lines.sort((a, b) => a.kind.length - b.kind.length);
  for (const line of lines) {
    const dots = line.points.map(([n, y]) => {
      const here = line.id === view.method && n === view.count ? " here" : "";
      const dot = svg("circle", { class: `dot ${line.kind}${here}`, cx: short(X(n)), cy: short(Y(y)), r: short((line.kind ? .42 : .3) * em) },
        svg("title", {}, `${line.id}, n = ${n}: ${bound(y, 4)}`));
      dot.addEventListener("click", () => choose(line.id, n));
      return dot;
    });
    picture.append(svg("path", { class: `series ${line.kind}`, d: polyline(line.points.map(([n, y]) => [X(n), Y(y)])) }), ...dots);
  }
  const named = lines.filter(line => line.kind);
  const ends = named.map(line => Y(line.points.at(-1)[1]) + .35 * em);
  if (ends.length === 2 && Math.abs(ends[0] - ends[1]) < 1.2 * em) ends[ends[0] > ends[1] ? 0 : 1] = Math.max(...ends) + 1.2 * em;
  named.forEach((line, i) => picture.append(words(frame.right + .5 * em, ends[i], shortened(line.id), { class: line.kind })));
  place.replaceChildren(picture);
}

const shortened = id => id.length > 14 ? `${id.slice(0, 13)}…` : id;
