
// People: a point that is chosen opens whose it is.
const known = JSON.parse(document.getElementById("people-data").textContent);
const dialog = document.getElementById("person");
const finder = document.getElementById("find");

function fill(row, cells, kind, heads) {
  cells.forEach((words, at) => {
    const cell = document.createElement(at === 0 && heads ? "th" : kind);
    cell.textContent = words;
    if (heads && at > 0) cell.dataset.head = heads[at];
    row.append(cell);
  });
  return row;
}

function open(who) {
  if (!Object.hasOwn(known.people, who)) return;
  const { facts, rows } = known.people[who];
  dialog.querySelector("h2").textContent = who;
  dialog.querySelector("dl").replaceChildren(
    ...facts.map((fact) => {
      const line = document.createElement("div");
      fact.forEach((words, at) => {
        const part = document.createElement(at ? "dd" : "dt");
        part.textContent = words;
        line.append(part);
      });
      return line;
    }),
  );
  const used = known.heads.map((_, at) => at < 1 || rows.some((row) => row[at]));
  const kept = (cells) => cells.filter((_, at) => used[at]);
  const heads = kept(known.heads);
  const table = dialog.querySelector("table");
  table.tHead.replaceChildren(fill(document.createElement("tr"), heads, "th"));
  table.tBodies[0].replaceChildren(
    ...rows.map((row) => fill(document.createElement("tr"), kept(row), "td", heads)),
  );
  dialog.showModal();
  dialog.scrollTop = 0;
}

function openByPoints() {
  for (const plot of plots) {
    if (!plot.on) continue;
    plot.on("plotly_click", ({ points }) => {
      if (typeof points[0].customdata === "string") open(points[0].customdata);
    });
  }
}

if (finder) {
  document.getElementById("ids").replaceChildren(
    ...Object.keys(known.people).map((who) => {
      const option = document.createElement("option");
      option.value = who;
      return option;
    }),
  );
  finder.addEventListener("change", () => open(finder.value));
}
dialog.addEventListener("click", (event) => {
  if (event.target === dialog) dialog.close();
});
new MutationObserver((_, seen) => {
  if (!document.documentElement.classList.contains("drawn")) return;
  seen.disconnect();
  openByPoints();
}).observe(document.documentElement, { attributes: true });
