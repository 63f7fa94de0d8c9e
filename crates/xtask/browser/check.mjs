// Opens a page of `predicament report` in Chromium and uses it: node check.mjs PAGE SCREENSHOTS [FINDINGS-AT-LEAST].
//
// Everything that is wrong is printed, and the exit code is 1 if anything is. Screenshots are for people to look at.

import { readFileSync, mkdirSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [path, folder, least = "1"] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const address = pathToFileURL(resolve(path)).href;
mkdirSync(folder, { recursive: true });

const wrong = [];
const check = (is, what) => { if (!is) wrong.push(what); };
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });

// A page that is ready: its search in the findings works.
const open = async (width, scheme, hash = "") => {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, offline: true });
  const page = await context.newPage();
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) wrong.push(`console, ${width}, ${scheme}: ${message.text()}`); });
  page.on("pageerror", (error) => wrong.push(`error, ${width}, ${scheme}: ${error}`));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) wrong.push(`request: ${request.url()}`); });
  const start = performance.now();
  await page.goto(address + hash);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "findings", null, { timeout: 30000 });
  return { page, context, milliseconds: performance.now() - start };
};
const counted = async (page) => {
  const [shown, all] = (await page.textContent(".filters output")).split(" of ").map((text) => Number(text.replaceAll(",", "")));
  return { shown, all };
};

// At each width, light and dark: nothing sticks out, and the first screen is looked at.
for (const width of [1400, 800, 400]) {
  for (const scheme of ["light", "dark"]) {
    const { page, context, milliseconds } = await open(width, scheme);
    const beyond = await page.evaluate(() => document.scrollingElement.scrollWidth - innerWidth);
    check(beyond <= 0, `${width}, ${scheme}: the page is ${beyond} pixels wider than the window`);
    await page.screenshot({ path: `${folder}/first-${width}-${scheme}.png` });
    await page.locator("#findings").scrollIntoViewIfNeeded();
    await page.evaluate(() => document.getElementById("findings").scrollIntoView());
    await page.screenshot({ path: `${folder}/findings-${width}-${scheme}.png` });
    if (width === 1400) {
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa"] }));
      for (const { id, help, nodes } of violations) {
        wrong.push(`accessibility, ${scheme}: ${id}: ${help}; ${nodes.length} times, first ${nodes[0].html.slice(0, 160)}`);
      }
      console.log(`${width}, ${scheme}: open and searchable after ${milliseconds.toFixed(0)} ms`);
    }
    await context.close();
  }
}

// What the page does.
{
  const { page, context } = await open(1400, "light");
  const { shown, all } = await counted(page);
  check(all >= Number(least) && shown === all, `${shown} of ${all} findings are shown at first, at least ${least} are there`);

  // A choice of one class shows as many as it says.
  const option = page.locator("select[name=class] option").nth(1);
  const [name, said] = (await option.textContent()).match(/^(.*) \(([\d,]+)\)$/).slice(1);
  await page.selectOption("select[name=class]", name);
  check((await counted(page)).shown === Number(said.replaceAll(",", "")), `class ${name} shows ${(await counted(page)).shown}, not ${said}`);
  const classes = await page.locator("#findings-table .tabulator-cell[tabulator-field=class]").allTextContents();
  check(classes.length > 0 && classes.every((text) => text === name), `rows of ${name} are of ${[...new Set(classes)]}`);
  await page.click("text=all findings");
  check((await counted(page)).shown === all, "all findings are shown again");

  // A search for an id finds it, and a row shows its command.
  const id = await page.locator("#findings-table .tabulator-cell[tabulator-field=finding]").first().textContent();
  await page.fill("input[type=search]", id);
  check((await counted(page)).shown === 1, `a search for ${id} shows ${(await counted(page)).shown}`);
  await page.locator("#findings-table .tabulator-row").first().click();
  const command = await page.locator("#finding pre").last().textContent();
  check(command.includes(`predicament replay ${id} --run `), `the command is ${command}`);
  await page.fill("input[type=search]", "there is nothing like this");
  check((await counted(page)).shown === 0, "nothing is shown where nothing is found");
  await page.click("text=all findings");

  // Some findings have pictures and their points.
  const told = await page.evaluate(async () => {
    const rows = document.querySelectorAll("#findings-table .tabulator-row");
    let found = 0;
    for (const row of [...rows].slice(0, 40)) {
      row.click();
      found += document.querySelectorAll("#finding figure svg").length > 0 && document.querySelectorAll("#finding pre").length > 1;
    }
    return found;
  });
  check(told > 0 || Number(least) > 1, "some of the first findings have pictures and points");

  // Sorted by a number both ways, what has none at the end or the start.
  const degeneracies = async () => (await page.locator("#findings-table .tabulator-cell[tabulator-field=degeneracy]").allTextContents())
    .filter((text) => text !== "").map((text) => (text === "−∞" ? -Infinity : Number(text)));
  const isSorted = (list, sign) => list.every((x, at) => at === 0 || list[at - 1] === x || sign * (x - list[at - 1]) >= 0);
  for (const sign of [1, -1]) {
    await page.click(".tabulator-col[tabulator-field=degeneracy]");
    await page.waitForTimeout(200);
    const list = await degeneracies();
    check(isSorted(list, sign), `degeneracies sorted ${sign > 0 ? "up" : "down"}: ${list.slice(0, 8)}`);
  }

  // A cell of the first table leads to its findings.
  const link = page.locator(".heat td a").first();
  if (await link.count() > 0) {
    const wanted = new URLSearchParams((await link.getAttribute("href")).split("?")[1]);
    await link.click();
    await page.waitForTimeout(200);
    check(await page.inputValue("select[name=backend]") === wanted.get("backend"), `the link to ${wanted} chooses its backend`);
    check((await counted(page)).shown > 0, `the link to ${wanted} shows findings`);
  }

  // The keyboard goes from finding to finding.
  await page.click("text=all findings");
  await page.focus("#findings-table .tabulator-tableholder");
  await page.keyboard.press("ArrowDown");
  const first = await page.textContent("#finding dd");
  await page.keyboard.press("ArrowDown");
  check(first !== await page.textContent("#finding dd"), "an arrow shows the next finding");

  // The keyboard reaches the button of the scheme, and it works.
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await ground();
  await page.focus("#theme");
  await page.keyboard.press("Enter");
  check(await ground() !== before, "the other scheme has another ground");
  await context.close();
}

// Printed: what is folded is there, and the ground is white.
{
  const { page, context } = await open(1400, "dark");
  const pdf = await page.pdf({ path: `${folder}/print.pdf`, format: "A4", printBackground: true });
  check(pdf.length > 10000, "a print has pages");
  await page.emulateMedia({ media: "print" });
  check(await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--ground").trim()) === "#fff", "the ground of a print is white");
  check(!await page.isVisible("#search"), "a print has no search");
  await page.setViewportSize({ width: 794, height: 1123 });
  await page.screenshot({ path: `${folder}/print.png` });
  await context.close();
}

// Without scripts the page says the same.
{
  const context = await browser.newContext({ javaScriptEnabled: false, viewport: { width: 1400, height: 900 } });
  const page = await context.newPage();
  await page.goto(address);
  check(await page.isVisible(".heat") && await page.isVisible("#findings"), "the page is there without scripts");
  await context.close();
}

await browser.close();
console.log(`${path}: ${(statSync(path).size / 1e6).toFixed(2)} MB; screenshots in ${folder}`);
for (const line of wrong) console.error(`WRONG ${line}`);
process.exit(wrong.length > 0 ? 1 : 0);
