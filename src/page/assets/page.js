// The view: what is chosen, drawn anew after each choice, kept in the fragment of the address.

const page = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const COPIES = { path: "Path data", ps: "PostScript", tikz: "TikZ", canvas: "Canvas", json: "JSON", command: "Command", link: "Link" };
const MOST_MAGNIFIED = 10000;

const view = {
  page, shape: "asked", at: 0, method: "", beside: "", count: 0, magnify: 500, by: page.by, sort: "method", down: false,
  source: "lancaster", copy: "path", theme: "", show: new Set(["deviation", "joints", "handles", "truth"]),
  get choice() { return page.shapes.find(choice => choice.id === this.shape); },
  get step() { return this.choice.steps[this.at]; },
  get drawing() { return this.find(this.method, this.count); },
  get criterion() { return page.criteria.findIndex(one => one.id === this.by); },
  get joints() { return this.step.joints[this.choice.counts.indexOf(this.count)]; },
  find(method, count) { return this.step.drawings.find(d => d.method === method && d.segments === count); },
};

/** Makes the view one that can be shown, changing as little as possible. */
function settle() {
  view.at = Math.min(Math.max(view.at, 0), view.choice.steps.length - 1);
  if (view.drawing) return;
  const { drawings } = view.step;
  const near = (list, n) => [...list].sort((a, b) => Math.abs(a.segments - n) - Math.abs(b.segments - n))[0];
  const same = near(drawings.filter(d => d.method === view.method), view.count || 4);
  const drawing = same || near(drawings.filter(d => d.method === "minimax"), view.count || 4) || near(drawings, view.count || 4);
  if (drawing) [view.method, view.count] = [drawing.method, drawing.segments];
}

/** The round magnification at which the peak is about an eighth of the larger radius, and less than half of the smaller one. */
function fitting() {
  const { radii } = view.step.shape, { peak } = errorOf(view.step, view.drawing);
  const room = Math.min(.12 * Math.max(...radii), .45 * Math.min(...radii));
  const wanted = Math.min(Math.max(room / Math.max(peak, 1e-12 * room), 1), MOST_MAGNIFIED);
  const size = 10 ** Math.floor(Math.log10(wanted));
  return Math.min([5, 2, 1].map(x => x * size).find(x => x <= wanted * 1.001) || size, MOST_MAGNIFIED);
}

function writeFragment() {
  const { choice } = view;
  const words = new URLSearchParams({ shape: view.shape, ...(choice.quantity ? { value: view.step.value } : {}), method: view.method, n: view.count,
    ...(view.beside ? { beside: view.beside } : {}), magnify: view.magnify, show: [...view.show].join("."), by: view.by,
    sort: (view.down ? "-" : "") + view.sort, source: view.source, ...(view.theme ? { theme: view.theme } : {}) });
  history.replaceState(null, "", `#${words}`);
}

/** Takes from the fragment what it says and the page has. */
function readFragment() {
  const words = new URLSearchParams(location.hash.slice(1));
  const take = (name, known, set) => { const word = words.get(name); if (word !== null && known(word)) set(word); };
  take("shape", word => page.shapes.some(choice => choice.id === word && choice.steps.length), word => { view.shape = word; });
  const value = words.get("value");
  if (value !== null) view.at = Math.max(0, view.choice.steps.findIndex(step => step.value === Number(value)));
  const known = word => page.methods.some(method => method.id === word);
  take("method", known, word => { view.method = word; });
  take("beside", known, word => { view.beside = word; });
  take("n", word => view.choice.counts.includes(Number(word)), word => { view.count = Number(word); });
  take("magnify", word => Number(word) >= 1 && Number(word) <= MOST_MAGNIFIED, word => { view.magnify = Number(word); });
  take("show", () => true, word => { view.show = new Set(word.split(".").filter(Boolean)); });
  take("by", word => page.criteria.some(one => one.id === word), word => { view.by = word; });
  take("sort", () => true, word => { view.down = word.startsWith("-"); view.sort = word.replace(/^-/, ""); });
  take("source", word => page.sources.some(source => source.id === word), word => { view.source = word; });
  take("theme", word => ["light", "dark"].includes(word), word => { view.theme = word; });
  settle();
  return words.has("magnify");
}

/** What is copied by this name. */
function textOf(name) {
  const { drawing, step, joints } = view;
  if (name === "command") return commandFor(step, drawing);
  if (name === "link") return location.href;
  return FORMATS[name](drawing, step, joints);
}

async function copy(name) {
  view.copy = name;
  drawText();
  const text = byId("text").textContent;
  let done = true;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    getSelection().selectAllChildren(byId("text"));
    done = document.execCommand("copy");
  }
  byId("copied").textContent = done ? `${COPIES[name]}: ${text.length} characters copied.`
    : `${COPIES[name]} is selected below; your browser's own command copies it.`;
}

function drawText() {
  byId("text").textContent = textOf(view.copy);
  for (const button of byId("copies").children) button.setAttribute("aria-pressed", String(button.dataset.copy === view.copy));
}

/** A select's options, kept where they are the same, and what is chosen. */
function fill(select, options, value) {
  const wanted = options.map(([id, text, disabled]) => `${id}|${text}|${disabled || ""}`).join("\n");
  if (select.dataset.filled !== wanted) {
    select.replaceChildren(...options.map(([id, text, disabled]) => html("option", { value: id, disabled }, text)));
    select.dataset.filled = wanted;
  }
  select.value = value;
}

function drawChoices() {
  const { choice, step } = view;
  for (const input of document.querySelectorAll("input[name=shape]")) input.checked = input.value === view.shape;
  byId("stop").hidden = !choice.quantity;
  if (choice.quantity) {
    byId("quantity").textContent = choice.quantity;
    byId("value-said").textContent = plain(step.value);
    byId("value").max = choice.steps.length - 1;
    byId("value").value = view.at;
    byId("value").setAttribute("aria-valuetext", `${plain(step.value)}: ${step.title}`);
  }
  const drawn = new Set(step.drawings.map(d => d.method));
  const methods = page.methods.map(m => [m.id, m.id, !drawn.has(m.id)]);
  fill(byId("method"), methods, view.method);
  fill(byId("beside"), [["", "none"], ...methods], view.beside);
  fill(byId("count"), choice.counts.map(n => [n, n, !view.find(view.method, n)]), view.count);
  byId("magnify").value = Math.round(100 * Math.log10(view.magnify));
  byId("magnify").setAttribute("aria-valuetext", `${people(view.magnify, 3)} times`);
  byId("magnify-said").textContent = `${plain(view.magnify)} ×`;
  for (const box of document.querySelectorAll("input[name=show]")) box.checked = view.show.has(box.value);
  const about = page.methods.find(m => m.id === view.method);
  byId("about").replaceChildren(...[["criterion", "Criterion"], ["origin", "From"], ["advice", "When to use it"]]
    .flatMap(([key, name]) => [html("dt", {}, name), html("dd", {}, about[key])]));
}

function drawStatement() {
  const { step, drawing } = view, { outward, inward, peak, relative_peak } = errorOf(step, drawing);
  const joins = drawing.continuity ? ` Joints: ${drawing.continuity}.` : "";
  byId("statement").textContent = `${step.title}: ${counted(drawing.segments)} by ${drawing.method}, within ${bound(peak, 3)} of the true shape `
    + `(${bound(relative_peak, 3)} of the larger radius); at most ${bound(outward, 3)} outside, ${bound(inward, 3)} inside.${joins}`;
}

function drawCharts() {
  const { step, drawing, joints } = view;
  const other = view.beside && view.beside !== view.method ? view.find(view.beside, view.count) : null;
  const along = [[drawing, "chosen"], ...(other ? [[other, "beside"]] : [])].map(([d, kind]) => ({ kind, name: d.method, ...alongOf(d, step, joints) }));
  drawAlong(byId("chart-error"), "error-title", along.map(a => ({ kind: a.kind, parts: a.distance })), joints, "user units, + outside", true);
  ["1/unit", "1/unit²", "1/unit³"].forEach((unit, order) => drawAlong(byId(`chart-k${order}`), `k${order}-title`,
    along.map(a => ({ kind: a.kind, parts: a.curvature[order] })), joints, unit, false));
  const { title: what, label } = page.criteria[view.criterion];
  const names = other ? `${view.method} (solid) and ${view.beside} (dashed)` : view.method;
  byId("error-title").textContent = `Distance from the true shape, orange outside and blue inside: ${names}`;
  byId("counts-title").textContent = `${what[0].toUpperCase()}${what.slice(1)} by the number of segments: ${step.title}`;
  drawCounts(byId("chart-counts"), view, label, choose);
}

function drawTables() {
  const held = document.activeElement?.dataset ?? {};
  drawMethods(byId("methods"), view, choose, sortBy);
  const again = held.sort ? `[data-sort="${held.sort}"]` : held.method ? `[data-method="${held.method}"]` : null;
  if (again) byId("methods").querySelector(again)?.focus();
  const source = page.sources.find(one => one.id === view.source);
  byId("source-note").textContent = `${source.source}. ${source.note}`;
  const asked = row => page.shapes[0].steps[0].drawings.find(d => d.method === row.method && d.segments === row.segments);
  drawPrinted(byId("printed"), source, asked, row => {
    [view.shape, view.at] = ["asked", 0];
    choose(row.method, row.segments);
    byId("statement").scrollIntoView({ block: "center" });
    byId("statement").focus({ preventScroll: true });
  });
}

/** Draws everything anew. */
function draw() {
  settle();
  document.documentElement.dataset.theme = view.theme;
  drawChoices();
  byId("beyond").hidden = drawFigure(view, byId("figure")) || !view.show.has("deviation");
  drawStatement();
  drawCharts();
  drawTables();
  writeFragment();
  drawText();
}

function choose(method, count) {
  [view.method, view.count] = [method, count];
  draw();
}

function sortBy(column) {
  [view.down, view.sort] = [view.sort === column && !view.down, column];
  draw();
}

/** Lists what there is to choose, and listens. */
function prepare() {
  const on = (id, event, change) => byId(id).addEventListener(event, ({ target }) => { change(target.value, target); draw(); });
  for (const choice of page.shapes.filter(one => one.steps.some(step => step.drawings.length))) {
    const input = html("input", { type: "radio", name: "shape", value: choice.id });
    input.addEventListener("change", () => {
      view.shape = choice.id;
      view.at = choice.id === "asked" ? 0 : Math.floor((choice.steps.length - 1) / 2);
      if (choice.id === "arc") view.count = 1;
      settle();
      view.magnify = fitting();
      draw();
    });
    byId("shapes").append(html("label", {}, input, html("span", {}, choice.title)));
  }
  on("value", "input", value => { view.at = Number(value); });
  on("method", "change", value => { view.method = value; });
  on("beside", "change", value => { view.beside = value; });
  on("count", "change", value => { view.count = Number(value); });
  on("by", "change", value => { view.by = value; });
  on("source", "change", value => { view.source = value; });
  on("theme", "change", value => { view.theme = value; });
  on("magnify", "input", value => { view.magnify = Number((10 ** (value / 100)).toPrecision(3)); });
  byId("fit").addEventListener("click", () => { view.magnify = fitting(); draw(); });
  for (const box of document.querySelectorAll("input[name=show]")) {
    box.addEventListener("change", () => { view.show[box.checked ? "add" : "delete"](box.value); draw(); });
  }
  fill(byId("by"), page.criteria.map(({ id, title }) => [id, title]), view.by);
  fill(byId("source"), page.sources.map(source => [source.id, source.title]), view.source);
  for (const [name, title] of Object.entries(COPIES)) {
    const button = html("button", { type: "button", "data-copy": name }, `Copy ${name === "json" || name === "tikz" ? title : title.toLowerCase()}`.replace("postscript", "PostScript"));
    button.addEventListener("click", () => copy(name));
    byId("copies").append(button);
  }
  byId("made-by").textContent = page.command;
  byId("choices").addEventListener("submit", event => event.preventDefault());
}

function restore() {
  if (!readFragment()) view.magnify = fitting();
  byId("by").value = view.by;
  byId("source").value = view.source;
  byId("theme").value = view.theme;
  draw();
}

prepare();
byId("main").hidden = false;
restore();
addEventListener("hashchange", restore);
addEventListener("beforeprint", draw);
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; drawCharts(); } });
