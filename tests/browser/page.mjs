// Drives the pages of `explore` and `compare -f html` in headless Chromium, as a reader would. Run by `make test-browser`:
//   node tests/browser/page.mjs PROGRAM FOLDER [PICTURES]
// FOLDER holds node_modules and takes the pages. With PICTURES, a folder, the pages are photographed in both themes at three widths.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [program, folder, pictures] = process.argv.slice(2).map(path => resolve(path));
const require = createRequire(join(folder, "package.json"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const chromium = process.env.CHROMIUM || "/usr/bin/chromium";

const curveto = words => execFileSync(program, words, { encoding: "utf8" });

/** Runs a command that the page states, by its words; `-o page.html` is left out. */
const run = command => curveto(command.split(" ").slice(1));

const PAGES = {
  circle: ["explore", "circle", "50"],
  ellipse: ["explore", "ellipse", "120", "50", "--rotation", "20", "--center", "-3,7"],
  arc: ["explore", "arc", "10", "--start", "30", "--end", "150"],
  compare: ["compare", "--by", "rms", "-f", "html"],
};

function write(name) {
  const file = join(folder, `${name}.html`);
  curveto([...PAGES[name], "-o", file]);
  assert.ok(statSync(file).size < 400_000, `${file} is too large`);
  return pathToFileURL(file).href;
}

/** A tab that notes whatever is said and asked for. */
async function open(browser, address, { width = 1280, height = 900 } = {}) {
  const tab = await browser.newPage();
  const said = [];
  tab.on("console", message => said.push(message.text()));
  tab.on("pageerror", error => said.push(String(error)));
  tab.on("request", request => {
    if (!/^(file|data):/.test(request.url())) said.push(`asks for ${request.url()}`);
  });
  await tab.setViewport({ width, height });
  await tab.goto(address, { waitUntil: "load" });
  return { tab, said };
}

const text = (tab, id) => tab.$eval(`#${id}`, element => element.textContent);
const hash = tab => tab.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
const column = (tab, number) =>
  tab.$$eval(`#methods tbody tr`, (rows, number) => rows.map(row => row.children[number].textContent), number);

/** Presses Tab until the element has the focus. */
async function tabTo(tab, selector) {
  for (let i = 0; i < 200; i++) {
    if (await tab.evaluate(selector => document.activeElement.matches(selector), selector)) return;
    await tab.keyboard.press("Tab");
  }
  assert.fail(`${selector} cannot be reached by the keyboard`);
}

const tests = {
  async "choosing a method, a count and a shape shows them"({ tab }) {
    await tab.select("#method", "apprich");
    await tab.select("#count", "8");
    assert.match(await text(tab, "statement"), /Circle of radius 50: 8 segments by apprich, within 0\.00468 of/);
    assert.equal(await tab.$$eval("#figure .joint", joints => joints.length), 8);
    assert.equal(await tab.$$eval("#figure .control", controls => controls.length), 16);
    await tab.click("input[value=ellipse]");
    await tab.$eval("#value", slider => { slider.value = 8; slider.dispatchEvent(new Event("input", { bubbles: true })); });
    assert.match(await text(tab, "statement"), /Ellipse with radii 50 and 5: 8 segments by apprich/);
    await tab.click("input[value=arc]");
    assert.match(await text(tab, "statement"), /Arc of radius 50 over \d+ degrees: 1 segment by apprich/);
    await tab.click("input[value=asked]");
    await tab.click("input[value=handles]");
    assert.equal(await tab.$$eval("#figure .control", controls => controls.length), 0);
  },

  async "every method and count that can be chosen is drawn without a fault"({ tab }) {
    const faults = await tab.evaluate(() => {
      const wrong = [];
      for (const choice of page.shapes) {
        choice.steps.forEach((step, at) => {
          for (const drawing of step.drawings) {
            Object.assign(view, { shape: choice.id, at, beside: "minimax" });
            choose(drawing.method, drawing.segments);
            const drawn = document.querySelector("#figure").innerHTML + document.querySelector(".charts").innerHTML;
            if (/NaN|Infinity|undefined/.test(drawn) || view.drawing !== drawing) wrong.push(`${step.title} ${drawing.method} ${drawing.segments}`);
          }
        });
      }
      return wrong;
    });
    assert.deepEqual(faults, []);
  },

  async "the drawn distance is that of the Béziers, to a thousandth of the peak or so"({ tab }) {
    const farthest = await tab.evaluate(() => {
      const frame = frameOf(view.step.shape);
      return Math.max(...view.step.drawings.flatMap(drawing => {
        const { segments } = readPath(drawing.path);
        const off = ([t, d], number) => Math.abs(Math.hypot(...pointAt(segments[number], t)) - 50 - d) / (50 * drawing.figures[0]);
        return distances(drawing, frame).flatMap((profile, number) => profile.map(place => off(place, number)));
      }));
    });
    assert.ok(farthest < .002, String(farthest));
  },

  async "the slider magnifies from 1 to 10000"({ tab }) {
    await tabTo(tab, "#magnify");
    await tab.keyboard.press("Home");
    assert.equal((await hash(tab)).magnify, "1");
    const farthest = () => tab.$eval("#figure .outward", path => {
      const numbers = path.getAttribute("d").match(/-?[\d.]+(e-\d+)?/g).map(Number);
      return Math.max(...numbers.map((x, i) => i % 2 ? 0 : Math.hypot(x, numbers[i + 1]) - 50));
    });
    // The peak outside is 0.0098 of a radius of 50.
    const once = await farthest();
    await tab.keyboard.press("End");
    assert.equal((await hash(tab)).magnify, "10000");
    const magnified = await farthest();
    assert.ok(Math.abs(once - .0098) < 1e-4 && Math.abs(magnified - 98) < 1, `${once}, ${magnified}`);
    assert.ok(await tab.$eval("#beyond", note => !note.hidden));
    await tab.click("#fit");
    assert.ok(await tab.$eval("#beyond", note => note.hidden));
  },

  async "the table sorts by every column, both ways"({ tab }) {
    const columns = await tab.$$eval("#methods thead th", heads => heads.length);
    for (let i = 0; i < columns; i++) {
      for (const direction of i === 0 ? ["descending", "ascending"] : ["ascending", "descending"]) {
        const heads = await tab.$$("#methods thead button");
        await heads[i].focus();
        await tab.keyboard.press("Enter");
        const sorts = await tab.$$eval("#methods thead th", heads => heads.map(head => head.getAttribute("aria-sort")));
        assert.equal(sorts[i], direction);
        assert.equal(sorts.filter(Boolean).length, 1);
        const cells = (await column(tab, i)).filter(cell => cell !== "–");
        const value = cell => i > 2 || i === 1 ? Number(cell.replace("−", "-")) : cell;
        for (let j = 1; j < cells.length; j++) {
          const [a, b] = [value(cells[j - 1]), value(cells[j])];
          assert.ok(direction === "ascending" ? a <= b : a >= b, `column ${i}, ${direction}: ${a} before ${b}`);
        }
        assert.ok(await tab.evaluate(i => document.activeElement.closest("th")?.cellIndex === i, i), "the focus is lost");
      }
    }
    await tab.click('[data-method="curvature"]');
    assert.equal((await hash(tab)).method, "curvature");
  },

  async "the table has the figures that compare prints"({ tab }) {
    const csv = curveto(["compare", "--by", "mean", "-f", "csv"]).trim().split("\n").map(line => line.split(","));
    await tab.select("#by", "mean");
    for (const [id, ...figures] of csv.slice(1)) {
      const cells = await tab.$eval(`[data-method="${id}"]`, button => [...button.closest("tr").children].slice(3).map(cell => cell.textContent));
      figures.slice(0, -1).forEach((figure, i) => {
        const shown = cells[i] === "–" ? "" : Number(cells[i].replace("−", "-"));
        if (figure === "") assert.equal(shown, "", `${id} ${i}`);
        else assert.ok(shown >= Number(figure) * (1 - 1e-12) && shown <= Number(figure) * 1.00011, `${id}: ${figure}, shown ${cells[i]}`);
      });
    }
  },

  async "what is copied is what the command prints"({ tab }, name) {
    for (const [method, count] of [["minimax", "4"], ["quadratic-minimax", "3"], ["minimax-g0", "2"]]) {
      await tab.select("#method", method);
      if (await tab.$eval(`#count option[value="${count}"]`, option => !!option, count).catch(() => false)) await tab.select("#count", count);
      await tab.click('[data-copy="command"]');
      const command = await text(tab, "text");
      assert.match(command, /^curveto (circle|ellipse|arc) /);
      const clip = () => tab.evaluate(() => navigator.clipboard.readText());
      assert.equal(await clip(), command, name);
      for (const format of ["path", "ps", "tikz", "canvas", "json"]) {
        await tab.click(`[data-copy="${format}"]`);
        const copied = await text(tab, "text");
        assert.equal(await clip(), copied);
        assert.match(await text(tab, "copied"), /characters copied/);
        const asked = await tab.evaluate(format => commandFor(view.step, view.drawing, format === "path" ? undefined : format), format);
        if (format === "json") assert.deepEqual(JSON.parse(copied), JSON.parse(run(asked)), asked);
        else assert.equal(copied, run(asked).trimEnd(), asked);
      }
    }
  },

  async "a link restores the view"({ tab, browser }) {
    await tab.select("#method", "midpoint");
    await tab.select("#beside", "area");
    await tab.select("#by", "area");
    await tab.select("#source", "chen");
    await tab.click("input[value=joints]");
    await tab.click("#methods thead th:nth-child(2) button");
    await tab.click('[data-copy="link"]');
    const link = await tab.evaluate(() => navigator.clipboard.readText());
    const other = await open(browser, link);
    assert.equal(await other.tab.evaluate(() => location.href), link);
    for (const id of ["statement", "methods", "printed", "figure", "chart-error", "magnify-said"]) {
      assert.equal(await other.tab.$eval(`#${id}`, e => e.innerHTML), await tab.$eval(`#${id}`, e => e.innerHTML), id);
    }
    assert.deepEqual(other.said, []);
    await other.tab.close();
    const damaged = await open(browser, `${link.split("#")[0]}#shape=cube&method=x&n=-1&magnify=1e9&by=beauty&sort=zz&theme=pink&show=&value=q`);
    assert.match(await text(damaged.tab, "statement"), /by minimax/);
    assert.deepEqual(damaged.said, []);
    await damaged.tab.close();
  },

  async "what the papers print stands beside what is true"({ tab }) {
    for (const [source, label, printed, truth] of [
      ["lancaster", "Peak lower than the normal one by", "24%", "2.556528%"],
      ["chen", "Table 2, π/4: Formulation III", "0.00010", "9.807513e−4"],
      ["apprich", "E, φ = 360°/4: 3φ⁶/4096", "0.0110022", "0.01559412"],
    ]) {
      await tab.select("#source", source);
      const rows = await tab.$$eval("#printed tbody tr", rows => rows.map(row => [...row.children].map(cell => cell.textContent)));
      const row = rows.find(cells => cells[0] === label);
      assert.deepEqual(row.slice(1, 3), [printed, truth]);
    }
    await tab.click("#printed tbody tr:nth-child(3) button");
    assert.equal((await hash(tab)).method, "apprich");
  },

  async "both themes are there, and the system's is taken"({ tab }) {
    const paper = () => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const colours = {};
    for (const theme of ["light", "dark"]) {
      await tab.select("#theme", theme);
      colours[theme] = await paper();
    }
    assert.notEqual(colours.light, colours.dark);
    await tab.select("#theme", "");
    for (const value of ["dark", "light"]) {
      await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value }]);
      assert.equal(await paper(), colours[value]);
    }
  },

  async "on paper there is the drawing in light colours, and nothing to press"({ tab }) {
    await tab.select("#theme", "dark");
    await tab.emulateMediaType("print");
    const seen = await tab.evaluate(() => {
      const shown = selector => [...document.querySelectorAll(selector)].some(element => element.checkVisibility());
      return [shown("form"), shown("#copies"), shown("#theme"), shown("#figure svg"), shown("#methods"), getComputedStyle(document.body).backgroundColor];
    });
    assert.deepEqual(seen, [false, false, false, true, true, "rgb(255, 255, 255)"]);
    assert.ok((await tab.pdf({ width: "210mm", height: "297mm" })).length > 10_000);
  },

  async "everything is within reach of the keyboard, in order"({ tab }) {
    for (const selector of ["#theme", "input[name=shape]", "#method", "#count", "#magnify", "input[name=show]", "#by", "#methods button", "#source", "#copies button", "#text"]) {
      await tabTo(tab, selector);
    }
  },
};

/** At every width and in both themes: nothing sticks out, and axe-core has nothing to say. */
async function judge(browser, address, name) {
  for (const width of [360, 1280, 2560]) {
    for (const theme of ["light", "dark"]) {
      const { tab, said } = await open(browser, `${address}#theme=${theme}`, { width, height: Math.max(740, width * .6) });
      const [inner, outer] = await tab.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      assert.ok(inner <= outer, `${name} at ${width} px is ${inner - outer} px too wide`);
      await tab.evaluate(axe);
      const { violations } = await tab.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] }));
      const found = violations.map(v => `${v.id}: ${v.help}: ${v.nodes.map(n => n.target).slice(0, 4).join(" ")}`);
      assert.deepEqual(found, [], `${name}, ${width} px, ${theme}`);
      assert.deepEqual(said, [], `${name}, ${width} px, ${theme}`);
      if (pictures) await tab.screenshot({ path: join(pictures, `${name}-${width}-${theme}.png`), fullPage: true });
      await tab.close();
    }
  }
}

const browser = await puppeteer.launch({ executablePath: chromium, headless: true, args: ["--no-sandbox", "--disable-gpu"] });
let failed = 0;
async function check(title, body) {
  try {
    await body();
    console.log(`ok   ${title}`);
  } catch (error) {
    failed += 1;
    console.log(`FAIL ${title}\n     ${String(error.message).replaceAll("\n", "\n     ")}`);
  }
}

const addresses = Object.fromEntries(Object.keys(PAGES).map(name => [name, write(name)]));
// Without an origin, since files have none.
const session = await browser.target().createCDPSession();
await session.send("Browser.grantPermissions", { permissions: ["clipboardReadWrite", "clipboardSanitizedWrite"] });
for (const [title, body] of Object.entries(tests)) {
  await check(title, async () => {
    for (const name of title.startsWith("what is copied") ? ["circle", "ellipse", "arc"] : ["circle"]) {
      const { tab, said } = await open(browser, addresses[name]);
      await tab.bringToFront();
      await body({ tab, browser }, name);
      assert.deepEqual(said, [], "the console is not silent");
      await tab.close();
    }
  });
}
for (const [name, address] of Object.entries(addresses)) {
  await check(`${name}: nothing sticks out, axe-core finds nothing, at three widths in both themes`, () => judge(browser, address, name));
}
await browser.close();
if (failed) {
  console.log(`${failed} failed`);
  process.exitCode = 1;
}
