// What is drawn: findings in space turn, strips of signs say who contradicts itself, plots answer to the pointer.

export const views = async ({ check, open, packed }, { folder, least }) => {
  const { details } = packed();
  const ids = (is) => Object.keys(details).filter((id) => is(details[id]));
  const { page, context } = await open(1400, "light");
  const show = async (id) => {
    await page.fill("input[type=search]", id);
    await page.locator("#findings-table .tabulator-row").first().click();
  };

  const turning = ids(({ views }) => views.length > 0);
  check(turning.length > 0 || least > 1, "some findings are in space");
  if (turning.length > 0) {
    await show(turning[0]);
    const canvas = page.locator("#finding .turned canvas").first();
    await canvas.scrollIntoViewIfNeeded();
    await canvas.focus();
    const from = () => canvas.getAttribute("data-turned");
    await page.waitForFunction(() => document.querySelector("#finding .turned canvas").dataset.turned);
    for (const key of ["ArrowLeft", "ArrowUp", "+"]) {
      const before = await from();
      await page.keyboard.press(key);
      await page.waitForTimeout(200);
      check(await from() !== before, `${key} does not turn the view of ${turning[0]}`);
    }
    const box = await canvas.boundingBox();
    const before = await from();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(300);
    check(await from() !== before, `the pointer does not turn the view of ${turning[0]}`);
    const colours = await canvas.evaluate((of) => {
      const copy = Object.assign(document.createElement("canvas"), { width: of.width, height: of.height }).getContext("2d");
      copy.drawImage(of, 0, 0);
      return new Set(new Uint32Array(copy.getImageData(0, 0, of.width, of.height).data.buffer)).size;
    });
    check(colours > 1 || (await canvas.getAttribute("data-turned")) === null, `the view of ${turning[0]} is empty`);
    await page.screenshot({ path: `${folder}/view.png` });
  }

  const striped = ids(({ strips }) => strips.length > 0);
  check(striped.length > 0 || least > 1, "some findings have strips");
  for (const id of striped.slice(0, 5)) {
    await show(id);
    const [{ rows }] = details[id].strips;
    const told = await page.locator("#finding .strip").first().locator(".row").evaluateAll((of) => of.map((row) => [row.firstChild.textContent, row.querySelectorAll("i").length, row.lastChild.textContent]));
    for (const [at, [name, signs]] of rows.entries()) {
      const wanted = new Set(signs).size > 1;
      check(told[at][0] === name && told[at][1] === signs.length, `the strip of ${id} has ${told[at]} in place of ${name} and ${signs.length} signs`);
      check((told[at][2] === "contradicts itself") === wanted, `${name} in the strip of ${id}: ${told[at][2]}`);
    }
  }
  if (striped.length > 0) await page.screenshot({ path: `${folder}/strip.png` });
  await page.fill("input[type=search]", "");

  // Plots with numbers become live when they are in sight.
  const plots = await page.evaluate(() => [...document.querySelectorAll(".plot")].filter((plot) => plot.querySelector("metadata")).map((plot) => plot.closest("section").id));
  if (plots.length > 0) {
    await page.evaluate((id) => { for (const details of document.getElementById(id).querySelectorAll("details")) details.open = true; }, plots[0]);
    await page.evaluate((id) => [...document.getElementById(id).querySelectorAll(".plot")].find((plot) => plot.querySelector("metadata")).scrollIntoView(), plots[0]);
    await page.waitForTimeout(500);
    const live = page.locator(`#${plots[0]} .live canvas`);
    check(await live.count() > 0, `a plot of ${plots[0]} does not answer to the pointer`);
    if (await live.count() > 0) {
      const box = await live.first().boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.waitForTimeout(200);
      const values = await page.locator(`#${plots[0]} .live .u-value`).allTextContents();
      check(values.some((text) => /\d/.test(text)), `a plot of ${plots[0]} shows no number under the pointer`);
      await page.screenshot({ path: `${folder}/plot.png` });
    }
  }
  console.log(`${turning.length} findings in space, ${striped.length} strips, ${plots.length} plots`);
  await context.close();
};
