// Screenshots beside references: the whole page at a quarter of its size, where a letter is a grey spot, so that another version of a font
// passes and another layout or colour does not.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import pixelmatch from "pixelmatch";
import { PNG } from "pngjs";

// Another colour: farther apart than this in YIQ, from 0 to 1.
const APART = 0.12;
// So many of the pixels may differ, and so much of the height.
const DIFFERENT = 0.02;
const TALLER = 0.03;

const KINDS = [1400, 800, 400].flatMap((width) => ["light", "dark"].map((scheme) => ({ name: `${width}-${scheme}`, width, scheme }))).concat([{ name: "print", width: 794, scheme: "light", media: "print" }]);

export const pictures = async ({ check, open }, { folder, references, accept }) => {
  if (accept) mkdirSync(references, { recursive: true });
  for (const { name, width, scheme, media } of KINDS) {
    const { page, context } = await open(width, scheme, { deviceScaleFactor: 0.25 });
    if (media) await page.emulateMedia({ media });
    await page.evaluate(() => document.fonts.ready);
    const bytes = await page.screenshot({ fullPage: true, animations: "disabled" });
    await context.close();
    writeFileSync(`${folder}/${name}.png`, bytes);
    const reference = `${references}/${name}.png`;
    if (accept) {
      writeFileSync(reference, bytes);
      continue;
    }
    check(existsSync(reference), `there is no ${reference}: --accept makes it`);
    if (!existsSync(reference)) continue;
    const [now, was] = [PNG.sync.read(bytes), PNG.sync.read(readFileSync(reference))];
    check(now.width === was.width, `${name}: ${now.width} pixels wide, not ${was.width}`);
    const taller = Math.abs(now.height - was.height) / was.height;
    check(taller <= TALLER, `${name}: ${now.height} pixels tall, not ${was.height}`);
    if (now.width !== was.width) continue;
    const height = Math.min(now.height, was.height);
    const cut = ({ data, width: wide }) => data.subarray(0, wide * height * 4);
    const different = pixelmatch(cut(now), cut(was), null, now.width, height, { threshold: APART }) / (now.width * height);
    check(different <= DIFFERENT, `${name}: ${(100 * different).toFixed(1)} % of the pixels differ from ${reference}`);
    console.log(`${name}: ${(100 * different).toFixed(2)} % of the pixels differ`);
  }
};
