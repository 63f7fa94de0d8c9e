// How a page looks: at three widths, light and dark, printed, and without scripts.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
// What is open at first; everything else folds.
const UNFOLDED = ["findings", "speed"];

export const looks = async ({ check, wrong, open }, { folder }) => {
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
        const opened = await page.evaluate(() => [...document.querySelectorAll("main details[open]")].map((details) => details.parentElement.id));
        check(opened.every((id) => UNFOLDED.includes(id)), `${opened} are open at first`);
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

  // Printed: what is folded is there, and the ground is white.
  {
    const { page, context } = await open(1400, "dark");
    const pdf = await page.pdf({ path: `${folder}/print.pdf`, format: "A4", printBackground: true });
    const pages = pdf.toString("latin1").match(/\/Type \/Page\b/g)?.length ?? 0;
    check(pages > 0, "a print has pages");
    console.log(`printed: ${pages} pages`);
    await page.emulateMedia({ media: "print" });
    check(await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--ground").trim()) === "#fff", "the ground of a print is white");
    check(!await page.isVisible("#search"), "a print has no search");
    await page.setViewportSize({ width: 794, height: 1123 });
    await page.screenshot({ path: `${folder}/print.png` });
    await context.close();
  }

  // Without scripts the page says the same.
  {
    const { page, context } = await open(1400, "light", { javaScriptEnabled: false });
    check(await page.isVisible(".heat") && await page.isVisible("#findings"), "the page is there without scripts");
    await context.close();
  }
};
