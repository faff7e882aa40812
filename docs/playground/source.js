// The programs on the page: files that were opened or dropped, examples, and the link that carries one program.
"use strict";

const MOST_SHOWN = 1000000; // characters of a file in the field; a larger one is only run
const MOST_LINKED = 200000; // characters of a program in a link
let files = [{ name: "program.nc", text: "" }];
let inField = 0; // the file in the field

const isText = (file) => typeof file.text === "string" && file.text.length <= MOST_SHOWN;
const linkable = () => files.length === 1 && isText(files[0]) && files[0].text.length <= MOST_LINKED;

/** Take over what was typed. */
function keep() {
  if (isText(files[inField])) files[inField].text = $("text").value;
}

/** Show files, the first one in the field. `example`: which one of the examples it is. */
function show(of, example = "") {
  files = of;
  $("example").value = example;
  $("file").replaceChildren(...files.map(({ name }, i) => new Option(visible(name), String(i))));
  showFile(0);
}

function showFile(index) {
  inField = index;
  const file = files[inField];
  const there = isText(file);
  $("file").value = String(inField);
  $("text").value = there ? file.text : "";
  $("text").readOnly = !there;
  const why = typeof file.text === "string" || file.text.length > MOST_SHOWN ? "is too long to be shown" : "is no UTF-8 text that could be shown";
  $("text").placeholder = there ? "" : `${visible(file.name)} ${why}; it is run as it is.`;
}

/** Select a word of a file, or the rest of the line where none is named. A column counts characters. */
function mark(place, column, word) {
  const index = files.findIndex((file) => file.name === place.file);
  if (index < 0 || !isText(files[index])) return;
  if (index !== inField) {
    keep();
    showFile(index);
  }
  const lines = $("text").value.split("\n");
  const begin = lines.slice(0, place.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
  const line = lines[place.line - 1] || "";
  const from = Array.from(line).slice(0, Math.max(0, column - 1)).join("").length;
  const length = word && line.startsWith(word, from) ? word.length : line.length - from;
  $("text").setSelectionRange(begin + from, begin + from + length);
  // A selection is seen in a field that has the focus; it is not taken from who chooses among controls by the keyboard.
  const free = [document.body, $("run")].includes(document.activeElement) && matchMedia("(pointer: fine)").matches;
  if (free) $("text").focus({ preventScroll: true });
  const high = parseFloat(getComputedStyle($("text")).lineHeight);
  $("text").scrollTop = Math.max(0, (place.line - 4) * high);
}

/** Return the bytes of a file as a text where they are one that the field can show. */
function textOf(bytes) {
  if (bytes.length > MOST_SHOWN) return bytes;
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return bytes;
  }
}

async function take(list) {
  const taken = [];
  for (const one of list) {
    try {
      taken.push({ name: one.name, text: textOf(new Uint8Array(await one.arrayBuffer())) });
    } catch {
      say(`${visible(one.name)} cannot be read: is it a folder?`);
      return;
    }
  }
  if (taken.length === 0) return;
  show(taken);
  $("main").value = $("start").value = ""; // those of other programs
  run();
}

/** Pack or unpack bytes; what comes out is at most so long. */
async function packed(bytes, how, most = Infinity) {
  const parts = [];
  let size = 0;
  const reader = new Blob([bytes]).stream().pipeThrough(how).getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    size += part.value.length;
    if (size > most) throw new Error("too long");
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

const FIELDS = { c: "control", s: "second", p: "changes", m: "main", n: "start", b: "most" };

async function writeLink() {
  const told = { t: files[0].text, f: files[0].name, k: $("skip").checked };
  for (const [key, id] of Object.entries(FIELDS)) told[key] = $(id).value;
  const bytes = await packed(JSON.stringify(told), new CompressionStream("deflate-raw"));
  let words = "";
  for (const one of bytes) words += String.fromCharCode(one);
  history.replaceState(null, "", `#${btoa(words).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`);
  return location.href;
}

async function fromLink() {
  const words = location.hash.slice(1);
  if (words === "") {
    choose(0);
    return;
  }
  let told;
  try {
    const bytes = Uint8Array.from(atob(words.replaceAll("-", "+").replaceAll("_", "/")), (one) => one.charCodeAt(0));
    told = JSON.parse(new TextDecoder().decode(await packed(bytes, new DecompressionStream("deflate-raw"), 8 * MOST_LINKED)));
    if (typeof told.t !== "string" || typeof told.f !== "string") throw new Error("no program");
  } catch {
    say("This link is broken: it carries no program");
    return;
  }
  const names = [...$("control").options].map((one) => one.value);
  for (const [key, id] of Object.entries(FIELDS)) $(id).value = typeof told[key] === "string" ? told[key] : "";
  $("skip").checked = told.k === true;
  $("more").open = Boolean(told.p || told.m || told.n || told.k);
  show([{ name: told.f, text: told.t }]);
  const missing = [told.c, told.s].filter((name) => name && !names.includes(name));
  if (missing.length === 0 && told.c) run();
  else say(`This link names a control that this engine has not: ${visible(String(missing[0] ?? "none"))}`);
}

function choose(index) {
  const example = PLAYGROUND.examples[index];
  $("control").value = example.control;
  $("main").value = $("start").value = "";
  show([{ name: example.name, text: example.text }], String(index));
  run();
}

$("example").append(new Option("none", ""));
PLAYGROUND.examples.forEach(({ name }, i) => $("example").append(new Option(name, String(i))));
$("example").onchange = () => { if ($("example").value !== "") choose(Number($("example").value)); };
$("file").onchange = () => {
  const to = Number($("file").value);
  keep();
  showFile(to);
};
$("open").onclick = () => $("files").click();
$("files").onchange = () => {
  const list = [...$("files").files];
  $("files").value = ""; // the same files may be opened again
  take(list);
};
$("link").onclick = async () => {
  keep();
  if (!linkable()) {
    say(files.length > 1 ? "A link carries one file; these are several" : "This program is too long for a link, or no text");
    return;
  }
  await writeLink();
  await navigator.clipboard.writeText(location.href).then(() => say("The link is copied"), () => say("The link is in the address bar"));
};
window.addEventListener("hashchange", fromLink);
const hasFiles = (event) => event.dataTransfer !== null && event.dataTransfer.types.includes("Files");
document.addEventListener("dragover", (event) => { if (hasFiles(event)) event.preventDefault(); });
document.addEventListener("drop", (event) => {
  if (!hasFiles(event)) return;
  event.preventDefault();
  take([...event.dataTransfer.files]);
});
