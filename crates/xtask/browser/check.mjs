// Opens a page of `predicament report` in Chromium and uses it: node check.mjs PAGE SCREENSHOTS [--least N] [--references FOLDER [--accept]].
//
// Everything that is wrong is printed, and the exit code is 1 if anything is. Screenshots are for people to look at; with references they
// are compared with those, and --accept makes them the references.

import { mkdirSync, statSync } from "node:fs";
import { parseArgs } from "node:util";
import { browse } from "./browse.mjs";
import { looks } from "./looks.mjs";
import { numbers } from "./numbers.mjs";
import { pictures } from "./pictures.mjs";
import { uses } from "./uses.mjs";
import { views } from "./views.mjs";

const options = { least: { type: "string", default: "1" }, references: { type: "string" }, accept: { type: "boolean" } };
const { values, positionals: [path, folder] } = parseArgs({ options, allowPositionals: true });
mkdirSync(folder, { recursive: true });
const browser = await browse(path);
const settings = { folder, least: Number(values.least), ...values };
if (values.references) await pictures(browser, settings);
else for (const part of [looks, uses, numbers, views]) await part(browser, settings);
await browser.close();
console.log(`${path}: ${(statSync(path).size / 1e6).toFixed(2)} MB; screenshots in ${folder}`);
for (const line of browser.wrong) console.error(`WRONG ${line}`);
process.exit(browser.wrong.length > 0 ? 1 : 0);
