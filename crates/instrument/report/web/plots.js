// Plots that answer to the pointer: each picture with numbers in its metadata gets one, when it comes into sight. Pictures are what is printed.
(() => {
  "use strict";
  const number = (x) => (x === null || x === undefined ? "—" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e6 ? String(Number(x.toPrecision(4))) : x.toExponential(2));
  const tick = (x) => {
    if (!(x > 0)) return "";
    const power = Math.log10(x);
    return Math.abs(power - Math.round(power)) > 1e-9 ? "" : x >= 1e-3 && x < 1e6 ? String(Number(x.toPrecision(1))) : `1e${Math.round(power)}`;
  };
  const colourOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const made = [];

  // Lines over all places that any of them has.
  const aligned = ({ curves }) => {
    const places = [...new Set(curves.flatMap(({ points }) => points.map(([x]) => x)))].sort((a, b) => a - b);
    const at = new Map(places.map((x, place) => [x, place]));
    const lines = curves.map(({ points }) => {
      const line = new Array(places.length).fill(null);
      for (const [x, y] of points) line[at.get(x)] = y;
      return line;
    });
    return [places, ...lines];
  };
  const decades = (values) => {
    const logs = values.filter((x) => x !== null && x > 0).map(Math.log10);
    const [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
    return [10 ** low, 10 ** Math.max(high, low + 1)];
  };
  const make = async (block, data) => {
    await predicamentLibraries;
    const { uPlot } = UPlotModule;
    const place = document.createElement("div");
    place.className = "live";
    block.after(place);
    const values = aligned(data);
    const axis = (label, extra) => ({
      label, labelSize: 22, font: "11px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif",
      stroke: () => colourOf("--ink"), grid: { stroke: () => colourOf("--line"), width: 1 }, ticks: { stroke: () => colourOf("--line"), width: 1 },
      values: (_, splits) => splits.map(tick), ...extra,
    });
    const plot = new uPlot({
      width: Math.max(260, place.clientWidth), height: 360,
      scales: {
        x: data.linear ? { time: false } : { time: false, distr: 3, range: (_, low, high) => (low === null || high === null || low === values[0][0] && high === values[0].at(-1) ? decades(values[0]) : [low, high]) },
        y: { distr: 3, range: (_, low, high) => (low === null ? [0.1, 1] : decades([low, high])) },
      },
      series: [
        { label: data.x, value: (_, x) => number(x) },
        ...data.curves.map(({ name, band, colour }) => ({
          label: name, stroke: colour, width: 1.5, fill: band ? `${colour}26` : undefined, spanGaps: true, points: { show: true, size: 5 }, value: (_, y) => number(y),
        })),
      ],
      axes: [axis(data.x, data.linear ? { values: (_, splits) => splits } : {}), axis(data.y, { size: 64 })],
      cursor: { focus: { prox: 24 } },
      focus: { alpha: 0.25 },
      legend: { live: true },
    }, values, place);
    const canvas = place.querySelector("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", block.getAttribute("aria-label"));
    new ResizeObserver(() => { if (place.clientWidth > 0) plot.setSize({ width: Math.max(260, place.clientWidth), height: 360 }); }).observe(place);
    block.classList.add("printed");
    made.push(plot);
  };
  const sight = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      sight.unobserve(target);
      make(target, JSON.parse(target.querySelector("metadata").textContent));
    }
  }, { rootMargin: "200px" });
  for (const block of document.querySelectorAll(".plot")) if (block.querySelector("metadata")) sight.observe(block);
  // Another scheme has other colours.
  new MutationObserver(() => { for (const plot of made) plot.redraw(false); }).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { for (const plot of made) plot.redraw(false); });
})();
