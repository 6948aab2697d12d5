"use strict";
(async () => {
  const figures = JSON.parse(document.getElementById("figures").textContent);
  const common = {
    font: { family: "Liberation Sans, Arial, Helvetica, sans-serif", size: 12, color: "#1b1f24" },
    margin: { l: 70, r: 20, t: 12, b: 52 }, paper_bgcolor: "#fff", plot_bgcolor: "#fff", hovermode: "closest",
    legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 },
  };
  const config = { displayModeBar: false, responsive: true, showLink: false };
  const draw = (figure) => {
    const layout = { ...common, ...figure.layout };
    for (const name of Object.keys(layout).filter((key) => /^[xy]axis/.test(key)))
      layout[name] = { automargin: true, gridcolor: "#dfe3e8", zerolinecolor: "#8a939d", ...layout[name] };
    return Plotly.newPlot(`figure-${figure.name}`, figure.traces, layout, config);
  };
  const folded = (figure) => document.getElementById(`figure-${figure.name}`).closest("details:not([open])");
  for (const figure of figures) if (!folded(figure)) await draw(figure);
  for (const details of document.querySelectorAll("details"))
    details.addEventListener("toggle", () => figures
      .filter((figure) => details.contains(document.getElementById(`figure-${figure.name}`)))
      .forEach(draw), { once: true });

  for (const table of document.querySelectorAll("table.sortable"))
    table.querySelectorAll("thead button").forEach((button, column) => button.addEventListener("click", () => {
      const head = button.parentElement, rising = head.getAttribute("aria-sort") !== "ascending";
      table.querySelectorAll("thead th").forEach((cell) => cell.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", rising ? "ascending" : "descending");
      const key = (row) => row.cells[column].textContent.trim();
      const size = (row) => key(row) === "" ? NaN : Number(key(row).replaceAll(",", ""));
      const order = (a, b) => {
        const one = size(a), other = size(b);
        const sign = isNaN(one) || isNaN(other) ? key(a).localeCompare(key(b)) : one - other;
        return rising ? sign : -sign;
      };
      const body = table.tBodies[0];
      [...body.rows].sort(order).forEach((row) => body.append(row));
    }));

  const download = document.getElementById("download");
  if (download) {
    const { name, text } = JSON.parse(download.textContent), button = document.createElement("button");
    button.type = "button"; button.className = "save"; button.textContent = `Save the table as ${name}`;
    button.addEventListener("click", () => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" })); link.download = name; link.click();
    });
    document.querySelector("header").append(button);
  }
  const paper = { width: 330 };  // half of an A4 page
  const fit = (size) => document.querySelectorAll(".js-plotly-plot").forEach((plot) => Plotly.relayout(plot,
    size ? { ...size, height: plot.classList.contains("tall") ? 340 : 250 } : { width: null, height: null, autosize: true }));
  window.addEventListener("beforeprint", () => fit(paper));
  window.addEventListener("afterprint", () => fit());
  document.body.dataset.ready = "1";
})();
