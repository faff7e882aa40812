"use strict";
const value = (row, column) => {
  const cell = row.cells[column];
  const number = Number(cell.dataset.v ?? (cell.textContent.trim() || "x"));
  return Number.isNaN(number) ? cell.textContent.trim() : number;
};
const compare = (a, b) => typeof a === "number" && typeof b === "number" ? a - b
  : String(a).localeCompare(String(b), "en", { numeric: true });
for (const button of document.querySelectorAll("th button")) {
  button.addEventListener("click", () => {
    const head = button.parentElement;
    const body = head.closest("table").tBodies[0];
    const down = head.getAttribute("aria-sort") === "ascending";
    for (const other of head.parentElement.children) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const rows = [...body.rows].sort((a, b) => compare(value(a, head.cellIndex), value(b, head.cellIndex)));
    body.append(...(down ? rows.reverse() : rows));
  });
}
const reveal = () => {
  const there = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!there) return;
  for (let at = there; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
  there.scrollIntoView({ block: "center" });
  for (const link of document.querySelectorAll("svg a"))
    link.classList.toggle("here", link.getAttribute("href") === location.hash);
};
addEventListener("hashchange", reveal);
reveal();
// A cursor in the code and in the drawing: pointing at one shows the place in the other.
const main = document.querySelector("#path > figure svg");
const cursor = main && main.appendChild(document.createElementNS(main.namespaceURI, "circle"));
if (cursor) {
  cursor.setAttribute("class", "cursor");
  cursor.setAttribute("r", "7");
  cursor.style.display = "none";
}
const point = (row) => {
  for (const other of document.querySelectorAll(".code tr.here")) other.classList.remove("here");
  if (row) row.classList.add("here");
  const [x, y] = row && row.dataset.at ? row.dataset.at.split(" ") : [];
  if (cursor) {
    cursor.style.display = x === undefined ? "none" : "";
    cursor.setAttribute("cx", x ?? 0);
    cursor.setAttribute("cy", y ?? 0);
  }
  for (const link of document.querySelectorAll("svg a"))
    link.classList.toggle("here", Boolean(row && row.id) && link.getAttribute("href") === `#${row.id}`);
};
for (const row of document.querySelectorAll(".code tr[data-at]"))
  row.addEventListener("pointerenter", () => point(row));
for (const link of document.querySelectorAll("svg a"))
  link.addEventListener("pointerenter", () => point(document.getElementById(link.getAttribute("href").slice(1))));
const marks = [...document.querySelectorAll(".code tr.mark")];
let place = -1;
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || !marks.length) return;
  if (event.key !== "n" && event.key !== "p") return;
  place = (place + (event.key === "n" ? 1 : -1) + marks.length) % marks.length;
  location.hash = marks[place].id;
  marks[place].focus();
});
