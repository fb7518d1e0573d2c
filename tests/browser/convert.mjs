// Draws the cases of `convert` in headless Chromium before and after, and holds the pixels against each other. `make test-browser`:
//   node tests/browser/convert.mjs PROGRAM FOLDER
// FOLDER holds node_modules and takes the page, convert.html, with both pictures of every case. Chromium knows styles, markers through
// `<use>`, animations and `attr()`, of which resvg, the judge of `make test`, knows a part.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [program, folder] = process.argv.slice(2).map(path => resolve(path));
const puppeteer = createRequire(join(folder, "package.json"))("puppeteer-core");
const chromium = process.env.CHROMIUM || "/usr/bin/chromium";

/** Pixels of the window, pixels of the device in each, and how many of those are taken together: Chromium smooths the edges of circles
 *  and of paths by different rules, which their mean does not show. */
const [SIZE, SCALE, BLOCK] = [200, 4, 8];
/** The largest difference of a channel of a block. */
const MOST = 16;
/** What is asked of `convert`. */
const WAYS = [[], ["-n", "8"], ["-t", "0.001"]];

const ROOT = resolve(import.meta.dirname, "../../fixtures");
const cases = ["documents", "fuzz/documents"].flatMap(name =>
  readdirSync(join(ROOT, name))
    .filter(file => file.endsWith(".svg") && !file.endsWith(".out.svg"))
    .map(file => join(ROOT, name, file)),
);

function convert(file, words) {
  const done = spawnSync(program, ["convert", "-q", file, ...words, "-o", "-"]);
  assert.equal(done.status, 0, `${file}: ${done.stderr}`);
  return done.stdout;
}

/** Chromium measures the length of curves to half a unit, so that dashes stand elsewhere on an ellipse and on its Béziers. */
const undashed = bytes => String(bytes).replaceAll(/ stroke-dasharray="[^"]*"/g, "");

/** The picture of a document once its animations have ended. */
async function picture(tab, bytes) {
  const file = join(folder, "case.svg");
  writeFileSync(file, bytes);
  await tab.goto(pathToFileURL(file).href, { waitUntil: "load" });
  await tab.evaluate(async () => {
    document.documentElement.pauseAnimations?.();
    document.documentElement.setCurrentTime?.(100);
    for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame);
  });
  return `data:image/png;base64,${await tab.screenshot({ encoding: "base64" })}`;
}

/** The largest difference of a channel, and how many channels of the first are not that of its first pixel. */
const difference = (tab, a, b) =>
  tab.evaluate(async (block, ...pictures) => {
    const [a, b] = await Promise.all(pictures.map(async source => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
      const [columns, rows] = [width, height].map(size => Math.floor(size / block));
      const means = new Float64Array(4 * columns * rows);
      for (let y = 0; y < rows * block; y++) {
        for (let x = 0; x < columns * block; x++) {
          const [to, from] = [columns * Math.floor(y / block) + Math.floor(x / block), y * width + x];
          for (let k = 0; k < 4; k++) means[4 * to + k] += data[4 * from + k] / block ** 2;
        }
      }
      return means;
    }));
    let [most, drawn] = [a.length === b.length ? 0 : 255, 0];
    for (let i = 0; i < a.length; i++) {
      most = Math.max(most, Math.round(Math.abs(a[i] - b[i])));
      drawn += a[i] !== a[i % 4];
    }
    return { most, drawn };
  }, BLOCK, a, b);

const browser = await puppeteer.launch({ executablePath: chromium, headless: true, args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"] });
// The tab in front is the one that draws.
const [judge, drawing] = [await browser.newPage(), await browser.newPage()];
await drawing.setViewport({ width: SIZE, height: SIZE, deviceScaleFactor: SCALE });
let [rows, failed, changed] = ["", 0, 0];
const shown = async (title, before, after, holds) => {
  const [a, b] = [await picture(drawing, before), await picture(drawing, after)];
  const found = await difference(judge, a, b);
  const ok = holds(found);
  failed += !ok;
  rows += `<tr><td>${ok ? "" : "FAIL "}${title}: ${found.most}</td><td><img src="${a}"></td><td><img src="${b}"></td></tr>\n`;
  if (!ok) console.log(`FAIL ${title}: ${JSON.stringify(found)}`);
};
for (const file of cases) {
  const before = readFileSync(file);
  for (const words of WAYS) {
    const after = convert(file, words);
    const title = `${file.slice(ROOT.length + 1)} ${words.join(" ")}`;
    changed += !after.equals(before);
    // Every case draws something, so that there is something to hold; an arc between ends that are one in single precision does not.
    const drawn = file.endsWith("near-full-f32.svg") ? 0 : 1;
    await shown(title, undashed(before), undashed(after), found => found.most <= MOST && found.drawn >= drawn);
  }
}
// That the judge sees a difference where there is one.
const circle = r => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100"><circle cx="50" cy="50" r="${r}"/></svg>`;
await shown("a circle that is larger by an eighth of a block", circle(40), circle(40.4), found => found.most > MOST);
await browser.close();
writeFileSync(join(folder, "convert.html"), `<!DOCTYPE html><title>convert, before and after</title><table>\n${rows}</table>\n`);
assert.ok(changed > 10, "hardly anything was converted");
console.log(`${failed ? "FAIL" : "ok  "} ${cases.length} documents in ${WAYS.length} ways, ${changed} of them changed: ${folder}/convert.html`);
process.exitCode = failed ? 1 : 0;
