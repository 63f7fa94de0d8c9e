// Chromium with a page of the tool: what is opened, what went wrong, and the rows that the page has compressed.

import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { inflateRawSync } from "node:zlib";
import { chromium } from "playwright-core";

// The view in space is drawn in software: a test machine has no graphics.
const ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

export const browse = async (path) => {
  const address = pathToFileURL(resolve(path)).href;
  const chrome = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ARGUMENTS });
  const wrong = [];
  const check = (is, what) => { if (!is) wrong.push(what); };
  // A page that is ready: its search in the findings works.
  const open = async (width, scheme, settings = {}) => {
    const context = await chrome.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, offline: true, ...settings });
    const page = await context.newPage();
    page.on("console", (message) => { if (["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver Message/.test(message.text())) wrong.push(`console, ${width}, ${scheme}: ${message.text()}`); });
    page.on("pageerror", (error) => wrong.push(`error, ${width}, ${scheme}: ${error}`));
    page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) wrong.push(`request: ${request.url()}`); });
    const start = performance.now();
    await page.goto(address);
    if (settings.javaScriptEnabled !== false) await page.waitForFunction(() => document.documentElement.dataset.ready === "findings", null, { timeout: 30000 });
    return { page, context, milliseconds: performance.now() - start };
  };
  const packed = () => JSON.parse(unpack(readFileSync(path, "utf8")));
  return { address, path, wrong, check, open, packed, close: () => chrome.close() };
};

const ROWS = /(<script type="application\/octet-stream" id="rows">)([^<]*)/;
export const unpack = (html) => inflateRawSync(Buffer.from(html.match(ROWS)[2].trim(), "base64")).toString("utf8");
export const repack = (html, bytes) => html.replace(ROWS, (_, head) => head + bytes.toString("base64"));
