// Where numbers are from: counts are summed anew from the lines that the page names, and a finding is read in its line.

import { readFileSync } from "node:fs";

// Heads of columns whose numbers are sums of a column of summary.csv.
const CLASSES = ["agree", "tie_broken", "in_band", "overreach", "missed_zero", "sign_flip", "inconsistent", "nan", "topology", "panic", "timeout", "declined", "refused", "accepted", "unstable"];

const lines = new Map();
const line = (path, number) => {
  if (!lines.has(path)) lines.set(path, readFileSync(path, "utf8").split(/\r?\n/));
  return lines.get(path)[number - 1];
};
const fields = (text) => [...`${text},`.matchAll(/("(?:[^"]|"")*"|[^,]*),/g)].map(([, field]) => (field.startsWith('"') ? field.slice(1, -1).replaceAll('""', '"') : field));
// "path, lines 3, 5–7 (4 rows)" as numbers of lines.
const named = (text) => {
  const [, path, list] = text.match(/^(.*), lines? ([\d,– ]+)(?: \([\d,]+ rows\))?$/) ?? [];
  const all = (list ?? "").split(",").map((range) => range.trim().split("–").map(Number)).flatMap(([from, to = from]) => Array.from({ length: to - from + 1 }, (_, at) => from + at));
  return { path, all };
};

export const numbers = async ({ check, open }, { least }) => {
  const { page, context } = await open(1400, "light");
  // The tables of counts, where few enough lines are behind a number that the page names them all.
  const asked = await page.evaluate((classes) => {
    const told = [];
    for (const table of document.querySelectorAll("#answers table[data-from], #glance table[data-from]")) {
      const heads = [...table.tHead.rows[0].cells].map((head) => head.textContent.replaceAll("\u200b", ""));
      for (const row of table.tBodies[0].rows) {
        for (const [at, head] of heads.entries()) {
          if (!classes.includes(head)) continue;
          row.cells[at].click();
          const says = [...document.querySelectorAll("#origin > p")].slice(1).map((p) => p.textContent);
          told.push({ head, number: row.cells[at].textContent, says });
        }
      }
    }
    return told;
  }, CLASSES);
  let summed = 0;
  for (const { head, number, says } of asked) {
    if (says.length === 0 || says.some((text) => text.includes("…"))) continue;
    let sum = 0;
    for (const { path, all } of says.map(named)) {
      const at = fields(line(path, 1)).indexOf(head);
      for (const one of all) sum += Number(fields(line(path, one))[at]);
    }
    summed += 1;
    check(sum === Number(number.replaceAll(",", "")), `${head} ${number} is ${sum} over ${says.join("; ")}`);
  }
  check(summed > 10 || least > 1, `${summed} of ${asked.length} numbers were summed anew`);
  console.log(`${summed} numbers of ${asked.length} summed anew from the lines that they are from`);

  // The command of the panel prints the rows: it names the same lines.
  const cell = page.locator("#answers table[data-from] tbody td").last();
  await cell.evaluate((of) => of.click());
  check((await page.textContent("#origin")).includes("summary.csv"), "a number of answers is from summary.csv");
  await page.keyboard.press("Escape");
  check(!await page.isVisible("#origin"), "escape closes where a number is from");

  // A finding is in the line that it names.
  await page.locator("#findings-table .tabulator-row").first().click();
  const id = await page.textContent("#finding dd");
  const [, path, number] = (await page.locator("#finding dd").last().textContent()).match(/^(.*), line (\d+)$/);
  check(fields(line(path, Number(number)))[0] === id, `finding ${id} is not in line ${number} of ${path}`);

  // Long tables have all their rows when they are asked for.
  for (const says of await page.locator("p.more").all()) {
    const [, shown, of] = (await says.textContent()).match(/The first (\d+) of ([\d,]+) rows/);
    const rows = says.locator("xpath=preceding-sibling::div[1]//tbody/tr");
    check(await rows.count() === Number(shown), `${shown} rows are not there`);
    await says.evaluate((element) => { element.dataset.now = "yes"; });
  }
  const after = await page.evaluate(() => [...document.querySelectorAll("p.more")].map((says) => {
    const body = says.previousElementSibling.querySelector("tbody");
    const of = Number(says.textContent.match(/of ([\d,]+) rows/)[1].replaceAll(",", ""));
    says.querySelector("button").click();
    return [of, body.rows.length];
  }));
  for (const [of, rows] of after) check(of === rows, `a table of ${of} rows has ${rows}`);
  await context.close();
};
