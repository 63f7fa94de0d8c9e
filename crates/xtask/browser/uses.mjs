// What a page does: search, choice, order, links, the keyboard, and the other scheme.

const counted = async (page) => {
  const [shown, all] = (await page.textContent(".filters output")).split(" of ").map((text) => Number(text.replaceAll(",", "")));
  return { shown, all };
};

export const uses = async ({ check, open }, { least }) => {
  const { page, context } = await open(1400, "light");
  const { shown, all } = await counted(page);
  check(all >= least && shown === all, `${shown} of ${all} findings are shown at first, at least ${least} are there`);

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
  for (const [verb, place] of [["shrink", -1], ["replay", -2]]) {
    const command = await page.locator("#finding pre").nth(place).textContent();
    check(command.includes(`predicament ${verb} ${id} --run `), `the command to ${verb} is ${command}`);
  }
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
  check(told > 0 || least > 1, "some of the first findings have pictures and points");

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

  // A cell of the first table leads to its findings. Where findings were left out of the page, as in a shortened one, it is a cell of one that has some.
  const link = await page.evaluateHandle(() => {
    const has = (name, value) => [...document.querySelector(`select[name=${name}]`).options].some((option) => option.value === value);
    return [...document.querySelectorAll(".heat td a")].find((link) => {
      const wanted = new URLSearchParams(link.getAttribute("href").split("?")[1]);
      return has("backend", wanted.get("backend")) && has("suite", wanted.get("suite"));
    });
  });
  if (link.asElement() !== null) {
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
  const shownId = () => page.evaluate(() => document.querySelector("#finding dd")?.textContent ?? "");
  const first = await shownId();
  await page.keyboard.press("ArrowDown");
  check(first !== await shownId(), "an arrow shows the next finding");

  // The keyboard reaches the button of the scheme, and it works.
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await ground();
  await page.focus("#theme");
  await page.keyboard.press("Enter");
  check(await ground() !== before, "the other scheme has another ground");
  await context.close();
};
