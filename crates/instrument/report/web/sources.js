// Where the numbers of tables are from: the lines of a CSV file, looked up when a reader points at a number.
const predicamentSources = (sources, findings) => {
  "use strict";
  const make = (tag, properties = {}, children = []) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  // The words of a cell without its small second line, and those of the line; names are broken after underscores by spaces of no width.
  const plain = (nodes) => [...nodes].map((node) => node.textContent).join("").replaceAll("\u200b", "").trim();
  const word = (cell) => {
    const text = plain([...cell.childNodes].filter((node) => node.nodeName !== "SMALL"));
    return text === "—" ? "" : text;
  };
  const small = (cell) => plain(cell.querySelectorAll("small"));

  // The rows of a file: parts of one run each, with the places of the words of their columns.
  const parts = (file) => {
    if (file !== "findings.csv") return sources[file] ?? [];
    const runs = new Map();
    findings.forEach((row) => {
      if (!runs.has(row.run)) runs.set(row.run, { run: Number(row.run), path: `${row.folder}/${file}`, rows: [] });
      runs.get(row.run).rows.push(row);
    });
    return [...runs.values()];
  };
  const linesOf = (part, wanted) => {
    if (part.rows) return part.rows.filter((row) => wanted.every(([column, of]) => row[column] === of)).map((row) => row.line).filter((line) => line !== null);
    const places = wanted.map(([column, of]) => [part.columns[column]?.at ?? [], part.columns[column]?.words.indexOf(of) ?? -1]);
    const lines = [];
    let line = 0;
    part.steps.forEach((step, at) => {
      line += step;
      if (places.every(([column, place]) => column[at] === place)) lines.push(line);
    });
    return lines;
  };

  // The file, the words that were asked for, and the lines in each part.
  const find = (cell) => {
    const table = cell.closest("table[data-from]");
    if (!table || !cell.closest("tbody")) return null;
    const origin = JSON.parse(cell.parentNode.dataset.from ?? table.dataset.from).filter(([start]) => start <= cell.cellIndex).at(-1)?.[1];
    if (!origin) return null;
    const heads = [...table.tHead.rows[0].cells].map((head) => plain(head.childNodes));
    const cells = cell.parentNode.cells;
    const wanted = Object.entries(origin.only ?? {});
    const add = (pairs, of) => {
      for (const [head, column] of Object.entries(pairs ?? {})) {
        const at = heads.indexOf(head);
        if (at >= 0) wanted.push([column, of(cells[at])]);
      }
    };
    add(origin.keys, word);
    add(origin.under, small);
    if (origin.across) {
      const head = heads[cell.cellIndex];
      const of = origin.named ? origin.named[head] : head;
      if (of !== undefined) wanted.push([origin.across, of]);
    }
    const run = heads.includes("run") ? Number(word(cells[heads.indexOf("run")])) : 0;
    const found = parts(origin.file)
      .filter((part) => part.run === 0 || run === 0 || part.run === run)
      .map((part) => ({ path: part.path, lines: linesOf(part, wanted) }))
      .filter(({ lines }) => lines.length > 0);
    return { file: origin.file, wanted, found };
  };
  const ranges = (lines) => {
    const all = [];
    for (const line of [...lines].sort((a, b) => a - b)) {
      const last = all.at(-1);
      if (last && line === last[1] + 1) last[1] = line;
      else all.push([line, line]);
    }
    return all;
  };
  const told = ({ lines }, many) => {
    const all = ranges(lines);
    const names = all.slice(0, many).map(([from, to]) => (from === to ? `${from}` : `${from}–${to}`));
    if (all.length > many) names.push("…");
    return `${lines.length === 1 ? "line" : "lines"} ${names.join(", ")}${lines.length > 1 ? ` (${lines.length.toLocaleString("en")} rows)` : ""}`;
  };

  // Pointed at, a number says in short what it is from.
  document.addEventListener("mouseover", (event) => {
    const cell = event.target.closest?.("td");
    if (!cell || cell.dataset.asked) return;
    const from = find(cell);
    if (!from) return;
    cell.dataset.asked = "yes";
    const says = from.found.map((part) => `${part.path}, ${told(part, 4)}`);
    if (says.length > 0) cell.title = [cell.title, ...says].filter((text) => text).join("\n");
  });

  // Clicked, in full, with the command that prints the rows.
  const box = make("aside", { id: "origin", hidden: true });
  box.setAttribute("aria-label", "where a number is from");
  box.setAttribute("aria-live", "polite");
  document.body.append(box);
  let marked = null;
  const close = () => {
    box.hidden = true;
    marked?.classList.remove("asked");
    marked = null;
  };
  const quoted = (text) => (/^[\w./:@%+=-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  document.addEventListener("click", (event) => {
    const cell = event.target.closest?.("td");
    if (!cell || event.target.closest("a, button")) return;
    const from = find(cell);
    close();
    if (!from) return;
    marked = cell;
    cell.classList.add("asked");
    const button = make("button", { type: "button", textContent: "close" });
    button.onclick = close;
    const where = from.wanted.map(([column, of]) => `${column} = ${of === "" ? "(empty)" : of}`).join(", ");
    const lines = from.found.flatMap((part) => {
      const all = ranges(part.lines);
      const command = `sed -n '${["1p", ...all.map(([a, b]) => (a === b ? `${a}p` : `${a},${b}p`))].join(";")}' ${quoted(part.path)}`;
      return [make("p", { textContent: `${part.path}, ${told(part, 40)}` }), ...(all.length <= 60 ? [make("pre", { textContent: command })] : [])];
    });
    if (lines.length === 0) lines.push(make("p", { textContent: `No row of ${from.file} is like that.` }));
    box.replaceChildren(button, make("p", {}, [make("b", { textContent: word(cell) || "this cell" }), ` is from ${from.file}${where ? ` where ${where}` : ""}:`]), ...lines);
    box.hidden = false;
  });
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") close(); });
};
