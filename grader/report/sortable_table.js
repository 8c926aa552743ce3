// Tables whose columns can be sorted: the names of columns become buttons. Rows are sorted by the
// data-value of their cells, as numbers where they are numbers. Without scripts the order stays.
"use strict";

const collator = new Intl.Collator(undefined, { numeric: true });

// Cells without a value come last in either order.
function compareCells(a, b, sign) {
  const [x, y] = [a.dataset.value, b.dataset.value];
  if (x === "" || y === "") return Number(x === "") - Number(y === "");
  return sign * (a.classList.contains("number") ? Number(x) - Number(y) : collator.compare(x, y));
}

function sortBy(table, heading, column) {
  const order = heading.getAttribute("aria-sort");
  const numeric = heading.classList.contains("number");
  // The first click shows the best first, or the beginning of the alphabet.
  const ascending = order === "none" ? !numeric : order === "descending";
  for (const other of table.tHead.querySelectorAll("th")) other.setAttribute("aria-sort", "none");
  heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
  const rows = [...table.tBodies[0].rows];
  rows.sort((a, b) => compareCells(a.cells[column], b.cells[column], ascending ? 1 : -1));
  table.tBodies[0].append(...rows);
}

for (const table of document.querySelectorAll("table.sortable"))
  table.tHead.querySelectorAll("th").forEach((heading) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...heading.childNodes);
    heading.append(button);
    heading.setAttribute("aria-sort", "none");
    button.addEventListener("click", () => sortBy(table, heading, heading.cellIndex));
  });
