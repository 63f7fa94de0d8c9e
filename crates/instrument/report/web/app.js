// What the page does: the scheme of its colours, the search in the findings, and folding. The page is whole without it.
(() => {
  "use strict";
  const $ = (id) => document.getElementById(id);
  const make = (tag, properties = {}, children = []) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };

  // Light and dark: as the system has it until somebody asks for the other one.
  const theme = $("theme");
  const isDark = () => {
    const set = document.documentElement.dataset.theme;
    return set ? set === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  };
  const label = () => { theme.textContent = isDark() ? "light" : "dark"; };
  theme.hidden = false;
  theme.onclick = () => {
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    label();
  };
  label();

  // A button beside each command.
  const copyButton = (text) => {
    const button = make("button", { type: "button", className: "copy", textContent: "copy" });
    button.setAttribute("aria-label", `copy: ${text}`);
    button.onclick = async () => {
      try {
        await navigator.clipboard.writeText(text);
        button.textContent = "copied";
      } catch {
        button.textContent = "select it by hand";
      }
      setTimeout(() => { button.textContent = "copy"; }, 1500);
    };
    return button;
  };
  const command = (text) => make("pre", {}, [copyButton(text), text]);
  for (const pre of document.querySelectorAll("pre")) pre.prepend(copyButton(pre.textContent));

  // What is folded is printed, and opened by a link to it.
  const all = () => [...document.querySelectorAll("details")];
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = all().filter((details) => !details.open);
    for (const details of folded) details.open = true;
  });
  addEventListener("afterprint", () => { for (const details of folded) details.open = false; });

  // Rows: columns of words in dictionaries and of numbers, compressed.
  const unpack = async () => JSON.parse(await predicamentText("rows"));
  const rowsOf = ({ rows, columns }) => {
    const all = Array.from({ length: rows }, (_, id) => ({ id }));
    for (const [name, column] of Object.entries(columns)) {
      if (column.words) all.forEach((row, at) => { row[name] = column.words[column.at[at]]; });
      else all.forEach((row, at) => { row[name] = column.numbers[at]; });
    }
    return all;
  };

  const number = (x) => (x === null ? NaN : typeof x === "number" ? x : x === "-inf" ? -Infinity : x === "inf" ? Infinity : NaN);
  const byNumber = (a, b) => {
    const [x, y] = [number(a), number(b)];
    if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) - Number.isNaN(y);
    return x < y ? -1 : x > y ? 1 : 0;
  };
  const short = (digits) => (cell) => {
    const x = cell.getValue();
    return x === null ? "" : typeof x === "number" ? (digits === 0 ? x.toExponential(1) : x.toFixed(digits)) : x.replace("-inf", "−∞");
  };
  // The permutations of so many things, in lexicographic order.
  const orders = (things) => (things.length === 0 ? [[]] : things.flatMap((first, at) => orders(things.toSpliced(at, 1)).map((rest) => [first, ...rest])));
  // Signs of one question about the vertices in all orders: a row for each backend, a cell for each order.
  const strip = ({ vertices, rows }) => {
    const all = orders(vertices).map((order) => order.join(" "));
    const names = { "-": "negative", 0: "zero", "+": "positive" };
    const truth = rows[0][1];
    const lines = rows.map(([name, signs]) => {
      const cells = [...signs].map((sign, at) => make("i", { className: `s${names[sign]}${sign === truth[at] ? "" : " differs"}`, title: `${name}: ${names[sign]} for ${all[at]}` }));
      const kinds = new Set(signs);
      const verdict = kinds.size === 1 ? `always ${names[signs[0]]}` : "contradicts itself";
      const bar = make("div", { className: "cells" }, cells);
      bar.setAttribute("role", "img");
      bar.setAttribute("aria-label", `${name}: ${verdict}`);
      return make("div", { className: "row" }, [make("span", { textContent: name }), bar, make("span", { textContent: verdict, className: kinds.size === 1 ? "" : "bad" })]);
    });
    const says = make("p", { className: "lead", textContent: `The question about ${vertices.join(" ")} in all ${all.length} orders, each sign turned back where the order is odd: who contradicts nothing has one sign. Framed where it is not the exact one.` });
    return make("div", { className: "strip" }, [says, ...lines]);
  };
  // Long tables have their first rows, and the others when somebody asks.
  const longTables = (rest) => {
    for (const says of document.querySelectorAll("p.more")) {
      const button = make("button", { type: "button", textContent: "show all" });
      button.onclick = () => {
        says.previousElementSibling.querySelector("tbody").insertAdjacentHTML("beforeend", rest[says.dataset.rows]);
        says.remove();
      };
      says.append(" ", button);
    }
  };
  const CHOICES = ["class", "backend", "suite", "task", "check"];

  const findings = async () => {
    const place = $("search");
    const { findings, details, sources, rest } = await unpack();
    const data = rowsOf(findings);
    predicamentSources(sources, data);
    longTables(rest);
    if (!place || data.length === 0) return;
    await predicamentLibraries;
    const columns = data.some((row) => row.run !== "1") ? ["run"] : [];
    const { Tabulator, ...modules } = TabulatorModules;
    Tabulator.registerModule(Object.values(modules));

    const chosen = {};
    const filters = make("div", { className: "filters" });
    const search = make("input", { type: "search", placeholder: "scene, query, id …" });
    filters.append(make("label", {}, ["search", search]));
    for (const name of CHOICES) {
      const select = make("select", { name });
      const count = new Map();
      for (const row of data) count.set(row[name], (count.get(row[name]) ?? 0) + 1);
      select.append(make("option", { value: "", textContent: "all" }));
      for (const [value, of] of [...count].sort()) {
        select.append(make("option", { value, textContent: `${value || "(none)"} (${of.toLocaleString("en")})` }));
      }
      chosen[name] = select;
      filters.append(make("label", {}, [name, select]));
    }
    const clear = make("button", { type: "button", textContent: "all findings" });
    const shown = make("output");
    filters.append(clear, shown);
    const table = make("div", { id: "findings-table" });
    const detail = make("div", { id: "finding" });
    detail.setAttribute("aria-live", "polite");
    place.append(filters, table, detail);
    place.hidden = false;
    // What a page without scripts shows in its place.
    for (let next = place.nextElementSibling; next; next = next.nextElementSibling) {
      if (next.matches(".scroll")) next.hidden = true;
    }

    const word = (field, width) => ({ title: field, field, width, sorter: "string" });
    const tabulator = new Tabulator(table, {
      data,
      height: Math.min(420, 60 + 26 * data.length),
      layout: "fitDataFill",
      renderVerticalBuffer: 400,
      placeholder: "No finding is like that.",
      selectableRows: 1,
      index: "id",
      columns: [
        ...columns.map((name) => word(name, 50)),
        word("class", 110), word("backend", 150), word("suite", 140), word("scene", 200), word("task", 110), word("check", 160),
        word("query", 220), word("got", 110), word("truth", 110),
        { title: "degeneracy", field: "degeneracy", hozAlign: "right", sorter: byNumber, formatter: short(1), width: 105 },
        { title: "distance / L", field: "distance", hozAlign: "right", sorter: byNumber, formatter: short(0), width: 105 },
        word("stage", 110), word("finding", 150),
      ],
    });
    const show = (row) => {
      const shownRow = (term, value) => (value === null || value === "" ? [] : [make("dt", { textContent: term }), make("dd", {}, [make("code", { textContent: value })])]);
      const terms = ["finding", "class", "backend", "suite", "scene", "task", "check", "query", "got", "truth", "stage", "degeneracy", "distance"];
      const from = row.line === null ? [] : shownRow("recorded in", `${row.folder}/findings.csv, line ${row.line}`);
      const list = make("dl", {}, [...terms.flatMap((term) => shownRow(term, row[term])), ...from]);
      const quoted = (text) => (/^[\w./:@%+=-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
      const asks = ["replay", "shrink"].map((verb) => command(`predicament ${verb} ${row.finding} --run ${quoted(row.folder)}`));
      const more = details[row.finding];
      const drawn = (more?.pictures ?? []).map(({ alt, svg }) => {
        const figure = make("figure", {}, [make("figcaption", { textContent: alt })]);
        // Pictures are made by the tool, as the rest of the page is.
        figure.insertAdjacentHTML("afterbegin", svg);
        return figure;
      });
      const told = more?.text ? [make("pre", { textContent: more.text })] : [];
      const strips = (more?.strips ?? []).map(strip);
      const turned = (more?.views ?? []).map(({ alt, drawing }) => make("figure", { className: "turned" }, [make("figcaption", { textContent: alt }), predicamentView(drawing)]));
      detail.replaceChildren(make("div", { className: "finding" }, [list, ...drawn, ...turned, ...strips, ...told, ...asks]));
    };
    tabulator.on("rowClick", (_, row) => show(row.getData()));
    tabulator.on("rowSelected", (row) => show(row.getData()));

    // The keyboard goes from row to row.
    table.setAttribute("aria-label", "findings");
    table.addEventListener("keydown", (event) => {
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const rows = tabulator.getRows("active");
      const [selected] = tabulator.getSelectedRows();
      const at = selected ? rows.indexOf(selected) + step : 0;
      const row = rows[Math.max(0, Math.min(rows.length - 1, at))];
      if (!row || row === selected) return;
      tabulator.deselectRow();
      row.select();
      tabulator.scrollToRow(row, "nearest", false);
    });

    const matches = () => {
      const text = search.value.trim().toLowerCase();
      const wanted = CHOICES.filter((name) => chosen[name].value !== "").map((name) => [name, chosen[name].value]);
      return (row) => wanted.every(([name, value]) => row[name] === value)
        && (text === "" || [row.scene, row.query, row.finding, row.check, row.got, row.truth].some((of) => of.toLowerCase().includes(text)));
    };
    const apply = () => {
      const is = matches();
      tabulator.setFilter(is);
      const count = data.reduce((sum, row) => sum + is(row), 0);
      shown.textContent = `${count.toLocaleString("en")} of ${data.length.toLocaleString("en")}`;
      detail.replaceChildren();
    };
    search.oninput = apply;
    for (const select of Object.values(chosen)) select.onchange = apply;
    const choose = (wanted) => {
      search.value = "";
      for (const name of CHOICES) chosen[name].value = wanted.get(name) ?? "";
      apply();
    };
    clear.onclick = () => choose(new URLSearchParams());
    const follow = () => {
      const [id, query] = location.hash.slice(1).split("?");
      if (id !== "findings" || query === undefined) return;
      choose(new URLSearchParams(query));
      const section = $("findings");
      section.querySelector("details").open = true;
      section.scrollIntoView();
    };
    await new Promise((resolve) => tabulator.on("tableBuilt", resolve));
    // What scrolls can be reached by the keyboard, and is a part of the grid.
    table.querySelector(".tabulator-tableholder").setAttribute("role", "rowgroup");
    table.querySelector(".tabulator-table").setAttribute("role", "presentation");
    table.removeAttribute("aria-owns");
    addEventListener("hashchange", follow);
    apply();
    follow();
    document.documentElement.dataset.ready = "findings";
  };

  const open = () => {
    const section = $(location.hash.slice(1).split("?")[0]);
    const details = section && section.querySelector("details");
    if (details) details.open = true;
  };
  addEventListener("hashchange", open);
  open();
  findings().catch((error) => {
    const place = $("search");
    place.hidden = false;
    place.textContent = `The search in the findings does not work in this browser (${error}); findings.csv has them all.`;
  });
})();
