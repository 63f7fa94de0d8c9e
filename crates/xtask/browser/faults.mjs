// Plants faults into a page, one at a time, and looks whether the check that is for it finds it: node faults.mjs PAGE FOLDER REFERENCES SMALL-PAGE.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { deflateRawSync } from "node:zlib";
import { browse, repack, unpack } from "./browse.mjs";
import { looks } from "./looks.mjs";
import { numbers } from "./numbers.mjs";
import { pictures } from "./pictures.mjs";
import { uses } from "./uses.mjs";
import { views } from "./views.mjs";

const [path, folder, references, small] = process.argv.slice(2);
const html = readFileSync(path, "utf8");
const replaced = (from, to) => (page) => {
  if (!page.includes(from)) throw new Error(`there is no ${from} to replace`);
  return page.replace(from, () => to);
};
const body = (more) => replaced("<main>", `<main>${more}`);
const rows = (change) => (page) => {
  const all = JSON.parse(unpack(page));
  change(all);
  return repack(page, deflateRawSync(Buffer.from(JSON.stringify(all))));
};
const count = (page) => {
  const [at, end] = ['<section id="answers">', "</section>"].reduce((found, text) => [...found, page.indexOf(text, found[0] ?? 0)], []);
  const section = page.slice(at, end);
  return page.slice(0, at) + section.replaceAll(/(<td class="n notable">)(\d+)</g, (_, cell, n) => `${cell}${Number(n) + 1}<`) + page.slice(end);
};

const FAULTS = [
  ["an error in the console", looks, body('<script>console.error("planted")</script>'), /console.*planted/, small],
  ["something from the network", looks, body('<img alt="" src="http://example.invalid/x.png">'), /request: http/, small],
  ["something wider than the window", looks, body('<div style="width:3000px">wide</div>'), /pixels wider/, small],
  ["a picture without words", looks, body('<img src="data:image/gif;base64,R0lGODlhAQABAAAAACw=">'), /accessibility.*image-alt/, small],
  ["words that are too pale", looks, body('<p style="color:#eee;background:#fff">pale</p>'), /accessibility.*color-contrast/, small],
  ["sections that do not fold", looks, (page) => page.replaceAll(/<details>/g, "<details open>"), /open at first/, small],
  ["a dark print", looks, replaced("--ground: #fff; --ink: #000", "--ground: #111; --ink: #eee"), /ground of a print/, small],
  ["a page that is made by scripts alone", looks, body('<style>.heat { display: none; }</style>'), /without scripts/, small],
  ["a choice that chooses nothing", uses, replaced("row[name] === value)", "row[name] !== undefined)"), /class .* shows/],
  ["numbers in the wrong order", uses, replaced("return x < y ? -1 : x > y ? 1 : 0;", "return String(x) < String(y) ? -1 : 1;"), /sorted/],
  ["a scheme that stays", uses, replaced('isDark() ? "light" : "dark";\n    label', 'isDark() ? "dark" : "light";\n    label'), /other scheme/],
  ["a link that leads elsewhere", uses, replaced('chosen[name].value = wanted.get(name) ?? "";', 'chosen[name].value = "";'), /chooses its backend/],
  ["a keyboard that does nothing", uses, replaced("ArrowDown: 1, ArrowUp: -1", "PageDown: 1, PageUp: -1"), /an arrow shows/],
  ["a count that is one more", numbers, count, /is \d+ over/],
  ["lines that are one off", numbers, rows(({ sources }) => { sources["summary.csv"][0].steps[0] += 1; }), /is (\d+|NaN) over/],
  ["a finding in another line", numbers, rows(({ findings }) => { findings.columns.line.numbers = findings.columns.line.numbers.map((line) => line + 1); }), /is not in line/],
  ["rows that got lost", numbers, rows(({ rest }) => { rest[0] = rest[0].replace(/<tr>.*?<\/tr>/s, ""); }), /a table of \d+ rows has/],
  ["a view that does not turn", views, replaced("ArrowLeft: [-0.12, 0]", "ArrowLeft: [0, 0]"), /does not turn/],
  ["a strip that contradicts nothing", views, replaced("const kinds = new Set(signs);", "const kinds = new Set(signs[0]);"), /in the strip of/],
  ["a plot that is a picture only", views, replaced("if (!isIntersecting) continue;", "continue;"), /does not answer to the pointer/],
  ["larger letters", pictures, body("<style>body { font-size: 21px; }</style>"), /tall, not|pixels differ/, small],
  ["other colours", pictures, body("<style>:root { --ground: #cde !important; --cell-good: #f00 !important; }</style>"), /pixels differ/, small],
];

mkdirSync(folder, { recursive: true });
let missed = 0;
for (const [name, part, plant, expected, other] of FAULTS) {
  const planted = `${folder}/planted.html`;
  writeFileSync(planted, plant(other ? readFileSync(other, "utf8") : html));
  const browser = await browse(planted);
  try {
    await part(browser, { folder, least: 1, references });
  } catch (error) {
    browser.wrong.push(String(error));
  }
  await browser.close();
  const found = browser.wrong.find((line) => expected.test(line));
  if (!found) missed += 1;
  console.log(`${found ? "caught" : "MISSED"}  ${name}${found ? `: ${found.slice(0, 140)}` : `; wrong was ${JSON.stringify(browser.wrong).slice(0, 300)}`}`);
}
console.log(`${FAULTS.length - missed} of ${FAULTS.length} faults caught`);
process.exit(missed > 0 ? 1 : 0);
