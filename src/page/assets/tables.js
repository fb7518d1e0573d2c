// The table of methods, which sorts by any column, and what the papers print.

/** The columns of the table of methods: name, key to sort by, text. */
function columnsOf(view) {
  const joining = id => view.find(id, view.count)?.continuity ?? null;
  return [
    { id: "method", title: "Method", key: method => method.id, text: method => method.id },
    { id: "order", title: "Order", key: method => method.order, text: method => method.order ?? "–" },
    { id: "joints", title: "Joints", key: method => joining(method.id), text: method => joining(method.id) ?? "–" },
    ...view.choice.counts.map(n => {
      const value = method => view.find(method.id, n)?.figures[view.criterion] ?? null;
      return { id: `n${n}`, title: `n = ${n}`, count: n, key: value, text: method => bound(value(method), 5) };
    }),
  ];
}

/** Orders by a key; what has none comes last, whichever the direction. */
function sorted(methods, column, down) {
  const order = (a, b) => typeof a === "string" ? a.localeCompare(b, "en") : a - b;
  return [...methods].sort((a, b) => {
    const [x, y] = [column.key(a), column.key(b)];
    if (x === null || y === null) return (x === null) - (y === null);
    return (down ? -1 : 1) * order(x, y);
  });
}

function drawMethods(table, view, choose, sortBy) {
  const columns = columnsOf(view);
  const by = columns.find(column => column.id === view.sort) || columns[0];
  const heads = columns.map(column => {
    const button = html("button", { type: "button", "data-sort": column.id }, column.title, html("span", { "aria-hidden": "true" },
      column === by ? (view.down ? " ▼" : " ▲") : ""));
    button.addEventListener("click", () => sortBy(column.id));
    return html("th", { scope: "col", "aria-sort": column === by ? (view.down ? "descending" : "ascending") : null }, button);
  });
  const rows = sorted(view.page.methods, by, view.down).map(method => {
    const chosen = method.id === view.method;
    const button = html("button", { type: "button", "data-method": method.id, "aria-pressed": String(chosen) }, method.id);
    button.addEventListener("click", () => choose(method.id, view.count));
    const cells = columns.slice(1).map(column => {
      const drawn = column.count && view.find(method.id, column.count);
      const here = chosen && column.count === view.count;
      const cell = html("td", { class: `${drawn ? "pick" : ""}${here ? " here" : ""}` || null, "aria-current": here ? "true" : null },
        String(column.text(method)));
      if (drawn) cell.addEventListener("click", () => choose(method.id, column.count));
      return cell;
    });
    return html("tr", { class: chosen ? "chosen" : null }, html("th", { scope: "row" }, button), ...cells);
  });
  table.replaceChildren(html("thead", {}, html("tr", {}, ...heads)), html("tbody", {}, ...rows));
}

/** Whether a printed figure is the true one, to the digits that it has. */
function agrees(row) {
  const digits = row.printed.replace(/e.*$/, "").replace(/^-?[0.]*/, "").replace(".", "").length;
  return Math.abs(row.printed_value - row.true) <= .500001 * 10 ** (Math.floor(Math.log10(Math.abs(row.printed_value))) + 1 - digits);
}

function drawPrinted(table, source, available, show) {
  const heads = ["What", "Printed", "True", "Printed − true, of the true", ""].map((title, i) =>
    title ? html("th", { scope: "col" }, title) : html("td", {}));
  const rows = source.rows.map(row => {
    const difference = 100 * (row.printed_value - row.true) / row.true;
    const right = agrees(row);
    const button = html("button", { type: "button", "aria-label": `Show ${row.method} with ${row.segments} segments` }, "Show");
    button.disabled = !available(row);
    button.addEventListener("click", () => show(row));
    const far = right ? "agrees" : `${difference > 0 ? "+" : "−"}${people(Math.abs(difference), 3)} %`;
    return html("tr", { title: row.command },
      html("th", { scope: "row" }, row.label),
      html("td", {}, row.printed + row.unit),
      html("td", {}, people(row.true, 7) + row.unit),
      html("td", { class: right ? null : "printed-wrong" }, far),
      html("td", {}, button));
  });
  table.replaceChildren(html("thead", {}, html("tr", {}, ...heads)), html("tbody", {}, ...rows));
}
