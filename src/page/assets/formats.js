// Numbers for people and for formats, and what is copied. Each text is the one that the command prints.

/** A number in plain notation, the shortest that reads back as the same. */
function plain(x) {
  const text = String(x === 0 ? 0 : x);
  if (!text.includes("e")) return text;
  const [, sign, whole, , fraction = "", exponent] = text.match(/^(-?)(\d)(\.(\d+))?e([+-]\d+)$/);
  const shift = Number(exponent), digits = whole + fraction;
  if (shift < 0) return `${sign}0.${"0".repeat(-shift - 1)}${digits}`;
  return sign + digits.padEnd(shift + 1, "0");
}

/** A bound, rounded up to some digits. */
function bound(x, digits) {
  if (x === null || x === undefined) return "–";
  if (x === 0) return "0";
  if (x < 2e-15) return "<2e-15";
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e").map(Number);
  const step = 10 ** (1 - digits);
  const raised = Number(`${mantissa}e${exponent}`) < x * (1 - 1e-14) ? mantissa + step : mantissa;
  return people(Number(`${raised.toFixed(digits - 1)}e${exponent}`), digits);
}

/** A number at some digits. */
function people(x, digits) {
  if (x === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(x)) + 1e-12);
  if (exponent < -3 || exponent > 5) return x.toExponential(digits - 1).replace("e+", "e").replace("-", "−").replace("e-", "e−");
  return x.toFixed(Math.max(0, digits - 1 - exponent)).replace("-", "−");
}

/** How many decimals a number has in plain notation. */
const decimalsOf = x => (plain(x).split(".")[1] ?? "").length;

/** The sum of two decimals as a person would write it. */
function decimalSum(a, b) {
  const digits = Math.max(decimalsOf(a), decimalsOf(b));
  return digits <= 15 ? Number((a + b).toFixed(digits)) : a + b;
}

/** A third of a decimal: that of 8.244 is 2.748. */
function decimalThird(x) {
  const third = x / 3, digits = decimalsOf(x);
  const rounded = digits <= 15 ? Number(third.toFixed(digits)) : third;
  return decimalSum(rounded, decimalSum(rounded, rounded)) === x ? rounded : third;
}

/** A quadratic as the cubic that it is. */
function raise(points) {
  if (points.length !== 3) return points;
  const [p, q, r] = points;
  const toward = (a, b) => [0, 1].map(i => decimalThird(decimalSum(a[i], decimalSum(b[i], b[i]))));
  return [p, toward(p, q), toward(r, q), r];
}

/** The command that draws what is shown; `format` is an -f, or nothing for path data. */
function commandFor(step, drawing, format) {
  const words = format === "ps" ? step.words_ps : step.words;
  const precision = drawing.precision === null ? "" : ` -p ${drawing.precision}`;
  const { words: method } = page.methods.find(one => one.id === drawing.method);
  return `curveto ${words} ${method} -n ${drawing.segments}${precision}${format ? ` -f ${format}` : ""}`;
}

/** The error of the points as printed. */
function errorOf(step, { error: [outward, inward] }) {
  const peak = Math.max(outward, inward);
  return { outward, inward, peak, relative_peak: peak / Math.max(...step.shape.radii) };
}

const FORMATS = {
  path: drawing => drawing.path,
  ps(drawing) {
    const { segments, start, closed } = readPath(drawing.path);
    const line = (points, operator) => [...points.flat().map(plain), operator].join(" ");
    const lines = segments.map(points => line(raise(points).slice(1), "curveto"));
    return [line([start], "moveto"), ...lines, ...(closed ? ["closepath"] : [])].join("\n");
  },
  tikz(drawing) {
    const { segments, start, closed } = readPath(drawing.path);
    const pair = ([x, y]) => `(${plain(x)},${plain(y)})`;
    const part = (points, i) => {
      const [, from, to, end] = raise(points).map(pair);
      return `${i > 0 && i % 4 === 0 ? "\n  " : " "}.. controls ${from} and ${to} .. ${end}`;
    };
    return `\\draw ${pair(start)}${segments.map(part).join("")}${closed ? " -- cycle" : ""};`;
  },
  canvas(drawing) {
    const { segments, start, closed } = readPath(drawing.path);
    const call = (name, points) => `${name}(${points.flat().map(plain).join(", ")})`;
    const lines = segments.map(points => call(points.length === 3 ? "quadraticCurveTo" : "bezierCurveTo", points.slice(1)));
    return [call("moveTo", [start]), ...lines, ...(closed ? ["closePath()"] : [])].join("\n");
  },
  json(drawing, step, joints) {
    const { segments, closed } = readPath(drawing.path);
    const document = {
      version: 1, shape: step.shape, method: drawing.method,
      ...(drawing.quadrature ? { quadrature: drawing.quadrature } : {}), closed,
      segments: segments.map((points, i) => ({
        points, angles: [joints[i], joints[i + 1]],
        power: { x: power(points.map(p => p[0])), y: power(points.map(p => p[1])) },
        derivatives: derivatives(points),
      })),
      error: errorOf(step, drawing),
    };
    if (drawing.corner !== undefined) document.corner = drawing.corner;
    document.path = drawing.path;
    return JSON.stringify(document, null, 1);
  },
};

/** The derivatives at both ends by the parameter from 0 to 1. */
function derivatives(points) {
  const degree = points.length - 1;
  return [0, degree - 1].map(i => [0, 1].map(axis => tidy(degree * (points[i + 1][axis] - points[i][axis]), points.map(p => p[axis]))));
}

/** A value rounded to the decimals of these coordinates, where those are few. */
function tidy(x, values) {
  const decimals = Math.max(...values.map(value => (plain(value).split(".")[1] || "").length));
  return decimals <= 12 ? Number(x.toFixed(decimals)) + 0 : x;
}

/** Lancaster's equation space: [A, B, C, D] of At³ + Bt² + Ct + D, rounded to the decimals of the points. */
function power(values) {
  const [a, b, c, d] = values;
  const found = values.length === 4
    ? [d - a + 3 * (b - c), 3 * (c - b - (b - a)), 3 * (b - a), a]
    : [0, c - b - (b - a), 2 * (b - a), a];
  return found.map(x => tidy(x, values));
}
