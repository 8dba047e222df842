"use strict";
// Inflates Plotly, draws the charts, and plays the frames. Colours of text and grid are those of the style sheet, so that charts
// follow the light or dark scheme.
(async () => {
  const byId = (id) => document.getElementById(id);
  let content = JSON.parse(byId("content").textContent);
  const drawn = new Map(); // element -> the ranges that show all

  async function loadPlotly() {
    const packed = Uint8Array.from(atob(byId("plotly").textContent.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const script = document.createElement("script");
    script.textContent = await new Response(stream).text();
    document.head.append(script);
  }

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const axes = (layout) => Object.keys(layout).filter((key) => /^[xy]axis\d*$/.test(key));

  function themed(layout) {
    const look = { "font.color": colour("--text"),
      "modebar.color": colour("--soft"), "hoverlabel.bgcolor": colour("--card"), "hoverlabel.font.color": colour("--text") };
    for (const axis of axes(layout)) {
      look[`${axis}.gridcolor`] = colour("--grid");
      look[`${axis}.linecolor`] = colour("--soft");
      look[`${axis}.zerolinecolor`] = colour("--line");
    }
    return look;
  }

  function prepared(layout) {
    const full = { xaxis: {}, yaxis: {}, ...layout };
    full.font = { family: "system-ui, DejaVu Sans, sans-serif", size: 12, color: colour("--text") };
    full.margin = { l: 62, r: 14, t: 34, b: 46, ...layout.margin };
    full.legend = { orientation: "h", y: 1.0, yanchor: "bottom", x: 0, ...layout.legend };
    full.hovermode = layout.hovermode ?? "x unified";
    full.hoverlabel = { bgcolor: colour("--card"), font: { color: colour("--text") } };
    full.autosize = true;
    full.modebar = { bgcolor: "rgba(0,0,0,0)", color: colour("--soft"), activecolor: colour("--text") };
    for (const axis of axes(full))
      full[axis] = { showline: true, ticks: "outside", automargin: true, exponentformat: "power", ...full[axis] };
    full.paper_bgcolor = "rgba(0,0,0,0)";
    full.plot_bgcolor = layout.plot_bgcolor ?? "rgba(0,0,0,0)";
    for (const axis of axes(full))
      Object.assign(full[axis], { gridcolor: colour("--grid"), linecolor: colour("--soft"), zerolinecolor: colour("--line") });
    return full;
  }

  // On a narrow page its buttons would hide the legend; drag, wheel and keys do what they do.
  const settings = { responsive: true, displaylogo: false, displayModeBar: innerWidth < 700 ? false : "hover", modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };

  async function draw(element, data, layout, more = {}) {
    await Plotly.react(element, data, prepared(layout), { ...settings, ...more });
    const full = element._fullLayout;
    const whole = Object.fromEntries(axes(full).map((axis) => [`${axis}.range`, [...full[axis].range]]));
    if (!drawn.has(element))
      element.addEventListener("keydown", (event) => zoomByKey(element, event));
    drawn.set(element, whole);
  }

  function zoomByKey(element, event) {
    if (event.ctrlKey || event.metaKey || event.altKey)
      return;
    const change = {};
    const step = { "+": [0.25, -0.25], "=": [0.25, -0.25], "-": [-0.5, 0.5], "ArrowLeft": [-0.2, -0.2], "ArrowRight": [0.2, 0.2] }[event.key];
    if (event.key === "0")
      Object.assign(change, structuredClone(drawn.get(element)));
    else if (step)
      for (const axis of axes(element._fullLayout).filter((key) => key.startsWith("x"))) {
        const [low, high] = element._fullLayout[axis].range;
        change[`${axis}.range`] = [low + step[0] * (high - low), high + step[1] * (high - low)];
      }
    else
      return;
    event.preventDefault();
    Plotly.relayout(element, change);
  }

  // The frames: an image under each pair of axes, and a colour bar.
  function preparePlayer() {
    let { times, bounds: [xmin, ymin, xmax, ymax], fields } = content.player;
    const panels = byId("panels");
    const scrub = byId("scrub");
    let frame = content.player.start, field = 0, timer = null, began = 0;

    const image = (panel) => ({
      source: panel.images[frame], xref: "x", yref: "y", x: xmin, y: ymax, sizex: xmax - xmin, sizey: ymax - ymin,
      sizing: "stretch", layer: "below",
    });
    function colourBar(panel, text) {
      const bar = document.createElement("div");
      const strip = document.createElement("div");
      const ticks = document.createElement("div");
      bar.className = "bar";
      strip.className = "strip";
      strip.style.background = `linear-gradient(to right, ${panel.scale.map((step) => step[1]).join(",")})`;
      ticks.className = "ticks";
      ticks.append(...[0, 0.25, 0.5, 0.75, 1].map((part) => {
        const tick = document.createElement("span");
        tick.textContent = String(Number((panel.low + part * (panel.high - panel.low)).toPrecision(3)));
        return tick;
      }));
      bar.setAttribute("role", "img");
      bar.setAttribute("aria-label", `Colours of ${text} from ${panel.low} to ${panel.high}`);
      bar.append(strip, ticks);
      return bar;
    }
    const told = () => `t = ${times[frame].toFixed(2)} s`;
    const words = (panel) => `${fields[field].label} of ${panel.title} at ${times[frame].toFixed(2)} s, from ${panel.low} to ${panel.high} ${fields[field].unit}`;

    function tell() {
      byId("now").textContent = told();
      scrub.value = frame;
      scrub.setAttribute("aria-valuetext", told());
      fields[field].panels.forEach((panel, i) => panels.children[i].lastChild.setAttribute("aria-label", words(panel)));
    }

    async function showField() {
      const { label, unit } = fields[field];
      panels.replaceChildren(...fields[field].panels.map((panel) => {
        const figure = document.createElement("figure");
        const caption = document.createElement("figcaption");
        caption.textContent = `${panel.title}: ${label} (${unit})`;
        const chart = document.createElement("div");
        chart.className = "chart frame";
        chart.tabIndex = 0;
        chart.setAttribute("role", "img");
        figure.append(caption, colourBar(panel, `${label} (${unit})`), chart);
        return figure;
      }));
      for (const [i, panel] of fields[field].panels.entries()) {
        const chart = panels.children[i].lastChild;
        const height = Math.min(0.9 * chart.clientWidth * (ymax - ymin) / (xmax - xmin), 0.75 * innerHeight) + 90;
        // Axes without a trace are not drawn.
        const scale = { type: "scatter", mode: "markers", x: [null], y: [null], showlegend: false, hoverinfo: "skip" };
        await draw(chart, [scale], {
          // Darker than the middle of a diverging scale in light, lighter than the page in dark: soil at rest is seen.
          plot_bgcolor: "rgba(128,136,144,0.35)", height, hovermode: false, dragmode: "zoom", images: [image(panel)],
          xaxis: { title: { text: "x (m)" }, range: [xmin, xmax], showgrid: false, zeroline: false, constrain: "domain" },
          yaxis: { title: { text: "y (m)" }, range: [ymin, ymax], showgrid: false, zeroline: false, scaleanchor: "x", constrain: "domain" },
        }, { scrollZoom: true });
      }
      tell();
    }

    function show(wanted) {
      frame = Math.max(0, Math.min(times.length - 1, wanted));
      fields[field].panels.forEach((panel, i) => Plotly.relayout(panels.children[i].lastChild, { "images[0].source": panel.images[frame] }));
      tell();
    }

    function pause() {
      cancelAnimationFrame(timer);
      timer = null;
      byId("play").textContent = "Play";
      byId("play").setAttribute("aria-pressed", "false");
    }

    function play() {
      if (frame === times.length - 1)
        show(0);
      byId("play").textContent = "Pause";
      byId("play").setAttribute("aria-pressed", "true");
      let before = performance.now();
      began = times[frame];
      const advance = (now) => {
        began += (now - before) / 1000 * Number(byId("speed").value);
        before = now;
        let next = frame;
        while (next < times.length - 1 && times[next + 1] <= began)
          ++next;
        if (next !== frame)
          show(next);
        if (frame === times.length - 1)
          pause();
        else
          timer = requestAnimationFrame(advance);
      };
      timer = requestAnimationFrame(advance);
    }

    const toggle = () => (timer === null ? play() : pause());
    byId("play").addEventListener("click", toggle);
    const jump = (wanted) => { pause(); show(wanted); };
    byId("back").addEventListener("click", () => jump(frame - 1));
    byId("on").addEventListener("click", () => jump(frame + 1));
    scrub.addEventListener("input", () => jump(Number(scrub.value)));
    byId("field").addEventListener("change", (event) => { field = Number(event.target.value); showField(); });
    byId("player").addEventListener("keydown", (event) => {
      if (event.defaultPrevented || event.target.closest("select"))
        return;
      const key = event.key;
      if (key === " " && event.target.tagName !== "BUTTON")
        toggle();
      else if ((key === "ArrowLeft" || key === "ArrowRight") && !event.target.closest(".chart"))
        jump(frame + (key === "ArrowRight" ? 1 : -1));
      else if (key === "Home" || key === "End")
        jump(key === "End" ? times.length - 1 : 0);
      else
        return;
      event.preventDefault();
    });
    // New frames of a run that goes on: who looks at the last one sees the new last one.
    function renew() {
      const last = frame === times.length - 1;
      ({ times, bounds: [xmin, ymin, xmax, ymax], fields } = content.player);
      scrub.max = times.length - 1;
      frame = last ? times.length - 1 : Math.min(frame, times.length - 1);
      return timer === null ? showField() : undefined;
    }
    return { showField, renew };
  }

  const colours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];

  function prepareRatios() {
    const reference = byId("reference");
    const names = [...new Set(content.ratios.flatMap((run) => Object.keys(run.amplitude.horizontal)))];
    reference.replaceChildren(...names.map((name) => new Option(name)));
    const show = () => {
      const data = [];
      for (const run of content.ratios) {
        const amplitudes = run.amplitude[byId("direction").value];
        const below = amplitudes[reference.value];
        if (!below)
          continue;
        const least = Math.max(...below) / 50;
        for (const [name, above] of Object.entries(amplitudes))
          if (name !== reference.value)
            data.push({ type: "scatter", mode: "lines", x: run.frequency, y: above.map((a, i) => (below[i] > least ? a / below[i] : null)),
              name: content.ratios.length > 1 ? `${name}, ${run.title}` : name,
              line: { width: 1.3, dash: run.dash, color: colours[names.indexOf(name) % colours.length] } });
      }
      return draw(byId("ratio"), data, { height: 400, 
        xaxis: { type: "log", title: { text: "frequency (Hz)" }, tickvals: [0.1, 0.2, 0.5, 1, 2, 5, 10, 20] },
        yaxis: { title: { text: `amplitude over that of ${reference.value} (1)` }, rangemode: "tozero" } });
    };
    reference.addEventListener("change", show);
    byId("direction").addEventListener("change", show);
    return show();
  }

  const relayoutAll = (change) => Promise.all([...drawn.keys()].filter((element) => element.isConnected)
    .map((element) => Plotly.relayout(element, { ...themed(element._fullLayout), ...change })));
  const restyle = () => relayoutAll({});

  function print(onPaper) {
    document.documentElement.classList.toggle("paper", onPaper);
    // A chart on A4 and on Letter is 660 pixels wide.
    return relayoutAll(onPaper ? { width: 660 } : { width: null, autosize: true });
  }

  const chartElements = () => [...document.querySelectorAll("[data-chart]")];

  async function drawCharts() {
    for (const element of chartElements()) {
      const { data, layout } = content.charts[element.dataset.chart];
      // A reader's zoom stays; a chart that showed all shows all again.
      const zoom = drawn.has(element) ? zoomed(element) : {};
      await draw(element, data, layout);
      if (Object.keys(zoom).length)
        await Plotly.relayout(element, zoom);
    }
  }

  /** The ranges that a reader has changed. */
  function zoomed(element) {
    const now = element._fullLayout, whole = drawn.get(element);
    return Object.fromEntries(axes(now).map((axis) => [`${axis}.range`, [...now[axis].range]])
      .filter(([name, range]) => range.some((end, i) => Math.abs(end - whole[name][i]) > 1e-9 * Math.abs(whole[name][1] - whole[name][0]))));
  }

  // A page that `tremolo watch` serves follows its run: it asks how far the run is, and fetches what is new.
  async function follow({ token, version, every_s }, player) {
    const ask = (what, more = {}) => fetch(`${what}?token=${token}`, { cache: "no-store", ...more });
    byId("abort").addEventListener("click", async () => {
      if (!confirm("Abort the run? What it has written stays readable."))
        return;
      byId("abort").disabled = true;
      byId("told").textContent = await (await ask("abort", { method: "POST" })).text();
    });
    for (;;) {
      await new Promise((done) => setTimeout(done, 1000 * every_s));
      try {
        const state = await (await ask("state")).json();
        byId("progress").value = state.share;
        if (!byId("abort").disabled)
          byId("told").textContent = state.words;
        if (state.ended)
          return location.reload(); // tables too are the run's last ones then
        if (state.version === version)
          continue;
        content = await (await ask("content")).json();
        version = state.version;
        if (chartElements().length !== Object.keys(content.charts).length)
          return location.reload(); // a section has begun
        await player?.renew();
        await drawCharts();
      } catch {
        byId("told").textContent = "tremolo watch has ended; this page shows what it saw last";
        return;
      }
    }
  }

  try {
    await loadPlotly();
    const player = content.player.fields.length ? preparePlayer() : null;
    await player?.showField();
    await drawCharts();
    if (content.ratios.length)
      await prepareRatios();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", restyle);
    addEventListener("beforeprint", () => print(true));
    addEventListener("afterprint", () => print(false));
    document.documentElement.dataset.ready = "yes";
    if (byId("following"))
      follow(JSON.parse(byId("following").textContent), player);
  } catch (error) {
    byId("trouble").hidden = false;
    byId("trouble").textContent = `The charts cannot be drawn: ${error.message}`;
    throw error;
  }
})();
