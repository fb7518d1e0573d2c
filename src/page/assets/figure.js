// The shape: the curve, its joints and handles, the true shape, and the deviation many times as large.

const SVG = "http://www.w3.org/2000/svg";

/** An element of SVG with attributes and children. */
function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== null) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

/** An element of HTML. */
function html(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === true) element.setAttribute(key, "");
    else if (value !== undefined && value !== null && value !== false) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

const short = x => Number(x.toPrecision(9));
const polyline = points => points.map(([x, y], i) => `${i ? "L" : "M"}${short(x)} ${short(y)}`).join("");

/** The regions between the true shape and the curve magnified `factor` times: where it is outside, and where inside. */
function lobes(drawing, frame, factor) {
  const { segments } = readPath(drawing.path);
  const regions = { outward: [], inward: [] };
  distances(drawing, frame).forEach((profile, number) => {
    const place = ([t, d]) => {
      const p = pointAt(segments[number], t), n = frame.normal(p);
      const at = size => [p[0] + size * n[0], p[1] + size * n[1]];
      return { d, true: at(-d), drawn: at((factor - 1) * d) };
    };
    let run = [];
    const close = () => {
      if (run.length > 1) {
        const side = run.some(place => place.d > 0) ? "outward" : "inward";
        regions[side].push([...run.map(place => place.drawn), ...run.map(place => place.true).reverse()]);
      }
      run = [];
    };
    let before = null;
    for (const step of profile) {
      if (before && before[1] * step[1] < 0) {
        const part = before[1] / (before[1] - step[1]);
        const zero = place([before[0] + part * (step[0] - before[0]), 0]);
        run.push(zero);
        close();
        run.push(zero);
      }
      run.push(place(step));
      before = step;
    }
    close();
  });
  return regions;
}

/** The true shape of a step, as points. */
function truthOf(shape, frame) {
  const steps = 240;
  return Array.from({ length: steps + 1 }, (_, i) => frame.at(shape.start + shape.sweep * i / steps));
}

/** Room for points: [x, y, width, height] with a margin. */
function room(points, margin) {
  const [xs, ys] = [0, 1].map(axis => points.map(p => p[axis]));
  const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
  return [low[0] - margin, low[1] - margin, high[0] - low[0] + 2 * margin, high[1] - low[1] + 2 * margin];
}

/** Draws the figure; says whether the magnified deviation leaves it. */
function drawFigure(view, at) {
  const { step, drawing } = view, frame = frameOf(step.shape);
  const { segments, closed } = readPath(drawing.path);
  const truth = truthOf(step.shape, frame);
  const box = room([...truth, ...segments.flat()], .2 * frame.radius);
  const unit = Math.max(box[2], box[3]) / 150;
  const title = `${step.title}, ${counted(drawing.segments)} by ${drawing.method}`;
  const picture = svg("svg", { viewBox: box.map(short).join(" "), role: "img", "aria-labelledby": "figure-title figure-desc" },
    svg("title", { id: "figure-title" }, title),
    svg("desc", { id: "figure-desc" }, `Deviation drawn ${people(view.magnify, 3)} times as large.`));
  const regions = lobes(drawing, frame, view.magnify);
  if (view.show.has("deviation")) {
    for (const side of ["outward", "inward"]) {
      const d = regions[side].map(points => `${polyline(points)}Z`).join("");
      picture.append(svg("path", { class: side, d }));
    }
  }
  if (view.show.has("truth")) picture.append(svg("path", { class: "truth", d: polyline(truth) }));
  picture.append(svg("path", { class: "curve", d: drawing.path }));
  if (view.show.has("handles")) {
    for (const points of segments) {
      const [first, last] = [points[0], points[points.length - 1]];
      const ends = points.length === 4 ? [[first, points[1]], [last, points[2]]] : [[first, points[1]], [last, points[1]]];
      for (const [joint, control] of ends) {
        picture.append(svg("path", { class: "handle", d: polyline([joint, control]) }));
        picture.append(svg("circle", { class: "control", cx: control[0], cy: control[1], r: unit * .8 }));
      }
    }
  }
  if (view.show.has("joints")) {
    const joints = segments.map(points => points[0]);
    if (!closed) joints.push(segments[segments.length - 1].at(-1));
    for (const [x, y] of joints) {
      picture.append(svg("rect", { class: "joint", x: short(x - unit), y: short(y - unit), width: 2 * unit, height: 2 * unit }));
    }
  }
  at.replaceChildren(picture);
  const inside = ([x, y]) => x >= box[0] && y >= box[1] && x <= box[0] + box[2] && y <= box[1] + box[3];
  return [...regions.outward, ...regions.inward].flat().every(inside);
}

const counted = n => n === 1 ? "1 segment" : `${n} segments`;
