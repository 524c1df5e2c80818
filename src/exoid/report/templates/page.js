"use strict";

const PRINTED = { width: 490, flat: 0.7, low: 345, tall: 490 }; // pixels on A4, low figures flattened
const SHRUNK = 0.7; // of that size it is printed at: two columns of A4, letters of 6 pt
const BUTTONS = 30; // pixels above a figure that are free for its buttons
const touch = matchMedia("(pointer: coarse)").matches;
const STEP = 0.1; // of what is seen, that an arrow key moves by
const config = {
  displaylogo: false,
  responsive: true,
  displayModeBar: touch ? true : "hover",
  modeBarButtons: [["zoomIn2d", "zoomOut2d", "resetScale2d"], ["toImage"]],
};
const plots = Array.from(document.querySelectorAll(".plot"));

async function unpack(text) {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let at = 0; at < letters.length; at++) bytes[at] = letters.charCodeAt(at);
  const unzipped = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(unzipped).text();
}

async function load() {
  const script = document.createElement("script");
  script.textContent = await unpack(document.getElementById("library").textContent);
  document.head.append(script);
}

function draw(plot) {
  const figure = JSON.parse(plot.parentElement.querySelector("script").textContent);
  const { layout } = figure;
  // A finger on a figure scrolls the page; the figure's buttons zoom.
  if (touch) layout.dragmode = false;
  layout.margin = { ...layout.template.layout.margin, ...layout.margin };
  layout.margin.t += BUTTONS;
  layout.height += BUTTONS;
  layout.legend = { ...layout.legend, y: 1 - BUTTONS / layout.height };
  plot.style.height = `${layout.height}px`;
  return Plotly.newPlot(plot, figure.data, layout, config);
}

function times(plot) {
  return Object.keys(plot.layout).filter((name) => /^xaxis\d*$/.test(name));
}

// A zoom of one figure is one of all that are linked with it.
function link(plot) {
  plot.on("plotly_relayout", (change) => {
    const zoomed = Object.keys(change).some((key) => /^xaxis\.(range|autorange)/.test(key));
    if (!plot.dataset.linked || !zoomed || plot.dataset.following) return;
    const all = change["xaxis.autorange"];
    const range = plot.layout.xaxis.range.slice();
    for (const other of plots) {
      if (other === plot || other.dataset.linked !== plot.dataset.linked || !other.layout) continue;
      other.dataset.following = "yes";
      Plotly.relayout(other, all ? { "xaxis.autorange": true } : { "xaxis.range": range }).then(
        () => delete other.dataset.following,
      );
    }
  });
}

function zoomByKeys(plot) {
  plot.addEventListener("keydown", (event) => {
    if (!plot.layout || event.ctrlKey || event.metaKey || event.altKey) return;
    const [low, high] = plot.layout.xaxis.range;
    const span = high - low;
    const moves = {
      "+": [low + span / 4, high - span / 4],
      "-": [low - span / 2, high + span / 2],
      ArrowLeft: [low - STEP * span, high - STEP * span],
      ArrowRight: [low + STEP * span, high + STEP * span],
    };
    if (event.key === "0") Plotly.relayout(plot, { "xaxis.autorange": true });
    else if (moves[event.key]) Plotly.relayout(plot, { "xaxis.range": moves[event.key] });
    else return;
    event.preventDefault();
  });
}

function scale(plot, size, height) {
  plot.style.height = `${size * height}px`;
  plot.firstElementChild.style.transform = size === 1 ? "" : `scale(${size})`;
}

function fitToPaper() {
  for (const details of document.querySelectorAll("details")) details.open = true;
  for (const plot of plots) {
    if (!plot.layout) continue;
    const { height: all, margin } = plot.layout;
    plot.dataset.height = all;
    const shown = all - BUTTONS;
    const height = shown <= PRINTED.low ? PRINTED.flat * shown : Math.min(shown, PRINTED.tall);
    const top = { "margin.t": margin.t - BUTTONS, "legend.y": 1 };
    Plotly.relayout(plot, { width: PRINTED.width, height, ...top });
    scale(plot, SHRUNK, height);
  }
}

function fitToScreen() {
  for (const plot of plots) {
    if (!plot.layout) continue;
    const height = Number(plot.dataset.height);
    scale(plot, 1, height);
    const top = { "margin.t": plot.layout.margin.t + BUTTONS, "legend.y": 1 - BUTTONS / height };
    Plotly.relayout(plot, { width: null, height, autosize: true, ...top });
  }
}

// Figures are drawn one after another, so that the text can be read and scrolled meanwhile.
async function drawAll() {
  await load();
  for (const plot of plots) {
    await draw(plot);
    // The alternative text says what a screen reader would only spell out.
    for (const image of plot.querySelectorAll(".main-svg")) image.setAttribute("aria-hidden", "true");
    link(plot);
    zoomByKeys(plot);
    await new Promise((resume) => setTimeout(resume));
  }
}

addEventListener("beforeprint", fitToPaper);
addEventListener("afterprint", fitToScreen);
drawAll().then(
  () => document.documentElement.classList.add("drawn"),
  (fault) => {
    const note = document.createElement("p");
    note.className = "note";
    note.textContent = `The figures could not be drawn: ${fault.message}. All numbers are in the tables.`;
    document.querySelector("main").prepend(note);
  },
);
