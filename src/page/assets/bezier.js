// Béziers as they are given: path data to control points, points and derivatives at t.

/** The curves of absolute path data with M, C, Q, L and Z: lists of control points. */
function readPath(path) {
  const segments = [];
  let start = null, here = null;
  for (const [, letter, words] of path.matchAll(/([MCQLZ])([^MCQLZ]*)/g)) {
    const numbers = (words.match(/-?\d*\.?\d+/g) || []).map(Number);
    if (letter === "M") {
      start = here = [numbers[0], numbers[1]];
      continue;
    }
    const step = { C: 6, Q: 4, L: 2, Z: 0 }[letter];
    for (let i = 0; step && i < numbers.length; i += step) {
      const points = [here];
      for (let j = 0; j < step; j += 2) points.push([numbers[i + j], numbers[i + j + 1]]);
      segments.push(points);
      here = points[points.length - 1];
    }
  }
  return { segments, start, closed: path.endsWith("Z") };
}

/** The point of a segment at t, by de Casteljau. */
function pointAt(points, t) {
  let row = points;
  while (row.length > 1) {
    const next = [];
    for (let i = 0; i + 1 < row.length; i++) {
      next.push([row[i][0] + t * (row[i + 1][0] - row[i][0]), row[i][1] + t * (row[i + 1][1] - row[i][1])]);
    }
    row = next;
  }
  return row[0];
}

/** The control points of the derivative. */
function derivative(points) {
  const degree = points.length - 1;
  const result = [];
  for (let i = 0; i < degree; i++) {
    result.push([degree * (points[i + 1][0] - points[i][0]), degree * (points[i + 1][1] - points[i][1])]);
  }
  return result.length ? result : [[0, 0]];
}

const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1];

/** [κ, dκ/ds, d²κ/ds²] at t, from the derivatives of the Bézier: κ = (p′ × p″)/|p′|³, and d/ds = (1/|p′|) d/dt. */
function curvatureAt(segment, t) {
  const first = derivative(segment), second = derivative(first), third = derivative(second);
  const [d1, d2, d3] = [first, second, third].map(points => pointAt(points, t));
  // The fourth derivative of a cubic is 0.
  const w = dot(d1, d1), w1 = 2 * dot(d1, d2), w2 = 2 * (dot(d2, d2) + dot(d1, d3));
  const c = cross(d1, d2), c1 = cross(d1, d3), c2 = cross(d2, d3);
  const k = c * w ** -1.5;
  const k1 = c1 * w ** -1.5 - 1.5 * c * w1 * w ** -2.5;
  const k2 = c2 * w ** -1.5 - 3 * c1 * w1 * w ** -2.5 - 1.5 * c * w2 * w ** -2.5 + 3.75 * c * w1 * w1 * w ** -3.5;
  return [k, k1 / Math.sqrt(w), k2 / w - k1 * w1 / (2 * w * w)];
}

/** The frame of the true shape: to its own axes and back, its outward normal, its angles. */
function frameOf(shape) {
  const turn = shape.rotation * Math.PI / 180, cos = Math.cos(turn), sin = Math.sin(turn);
  const [cx, cy] = shape.center, [rx, ry] = shape.radii;
  const own = ([x, y]) => [cos * (x - cx) + sin * (y - cy), cos * (y - cy) - sin * (x - cx)];
  return {
    radius: Math.max(rx, ry),
    at(degrees) {
      const a = degrees * Math.PI / 180, x = rx * Math.cos(a), y = ry * Math.sin(a);
      return [cx + cos * x - sin * y, cy + sin * x + cos * y];
    },
    normal(point) {
      const [x, y] = own(point), u = x / (rx * rx), v = y / (ry * ry), size = Math.hypot(u, v);
      return [(cos * u - sin * v) / size, (sin * u + cos * v) / size];
    },
    angle(point) {
      const [x, y] = own(point);
      return Math.atan2(y / ry, x / rx) * 180 / Math.PI;
    },
  };
}

/** How many steps of t the distance along a segment is drawn in. */
const FINE = 96;

/** The signed distance along each segment as [t, distance]: the polynomial through the engine's values, by the barycentric formula. */
function distances(drawing, frame) {
  const unit = drawing.figures[0] * frame.radius / 1000;
  const kinds = drawing.profile_of || Array(drawing.segments).fill(1);
  const node = (i, steps) => (1 - Math.cos(Math.PI * i / steps)) / 2;
  return kinds.map(number => {
    let values = drawing.profiles[Math.abs(number) - 1];
    // Of a profile that mirrors itself the first half is given.
    if (values.length === 13) values = [...values, ...values.slice(0, -1).reverse()];
    if (number < 0) values = [...values].reverse();
    const last = values.length - 1;
    const at = (t, i) => {
      if (i * last % FINE === 0) return values[i * last / FINE];
      let sum = 0, weights = 0;
      for (let j = 0; j <= last; j++) {
        const weight = (j % 2 ? -1 : 1) * (j === 0 || j === last ? .5 : 1) / (t - node(j, last));
        sum += weight * values[j];
        weights += weight;
      }
      return sum / weights;
    };
    return Array.from({ length: FINE + 1 }, (_, i) => [node(i, FINE), at(node(i, FINE), i) * unit]);
  });
}
