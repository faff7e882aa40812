// The page: what is asked of the worker, and what it answers. Texts of programs go into the page as text, never as HTML.
"use strict";

const $ = (id) => document.getElementById(id);
const TABS = { path: "Path", trace: "Blocks", calls: "Calls", variables: "Variables", findings: "Findings", messages: "Messages" };
const MOST_SHOWN = 1000000; // characters of a program in the field; a larger one is only run
const SHOWN_STEPS = 60;

let worker = null;
let wasm = null;
let job = 0;
let running = 0; // the job that runs
let waiting = null; // ends a worker that does not answer
let files = [{ name: "program.nc", text: "" }];
let whole = true; // the field holds the program
let asked = null;
let ran = null;
let compared = null;
let at = 0;

const made = (tag, text, name) => {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = visible(text);
  if (name) element.className = name;
  return element;
};
/** Show what would be invisible, or would turn the direction of what stands beside it. */
const visible = (text) => text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]/g,
  (one) => `\\u${one.charCodeAt(0).toString(16).padStart(4, "0")}`);
const say = (text) => { $("status").textContent = text; };
const post = (kind, told = {}) => worker.postMessage({ job: ++job, kind, ...told }) || job;

async function unpacked() {
  const bytes = new Uint8Array(PLAYGROUND.size); // of characters that hold seven bits each
  let [bits, held, to] = [0, 0, 0];
  for (let i = 0; to < bytes.length; ++i) {
    held = (held << 7) | (PLAYGROUND.wasm.charCodeAt(i) & 127);
    bits += 7;
    if (bits < 8) continue;
    bits -= 8;
    bytes[to++] = held >> bits;
    held &= (1 << bits) - 1;
  }
  return packed(bytes, new DecompressionStream("gzip"));
}

async function start() {
  wasm = wasm || await unpacked();
  worker = new Worker(URL.createObjectURL(new Blob([PLAYGROUND.worker], { type: "text/javascript" })));
  worker.onmessage = ({ data }) => (answers[data.kind] || (() => {}))(data);
  worker.onerror = (event) => { say(`The engine stopped: ${event.message}`); restart(); };
  post("start", { wasm });
}

function restart() {
  worker.terminate();
  running = 0;
  ran = null;
  start();
}

const answers = {
  ready({ controls, version }) {
    idle();
    say(`Engine ${version}, ${controls.length} controls`);
    document.body.dataset.ready = version;
    if ($("control").length === 0) {
      $("second").append(new Option("none", ""));
      for (const { name, title } of controls) {
        const option = new Option(name, name, false, name === "fanuc-0i-f");
        option.title = title;
        $("control").append(option);
        $("second").append(new Option(name, name));
      }
      fromLink();
    }
  },
  progress({ job: of, blocks }) { if (of === running) say(`${blocks.toLocaleString("en")} blocks`); },
  ran(told) {
    if (told.job !== running) return;
    ran = told;
    compared = null;
    at = told.summary.steps;
    showRun();
  },
  checked({ job: of, findings }) {
    if (of !== running) return;
    const list = made("ul");
    for (const one of findings) {
      const item = made("li");
      item.append(made("span", `${one.rule} ${one.severity}`, one.severity), ` ${visible(one.at.program)}, line ${one.at.line}: `, visible(one.message));
      if (one.hint) item.append(made("div", one.hint, "where"));
      list.append(item);
    }
    $("findings").replaceChildren(findings.length ? list : made("p", "check finds nothing."));
    $("tab-findings").textContent = `Findings (${findings.length})`;
    if (!asked.second) idle();
  },
  compared({ job: of, comparison }) {
    if (of !== running) return;
    compared = comparison;
    showComparison();
    idle();
    draw();
  },
  steps({ first, rows }) { if (ran) showSteps(first, rows); },
  state({ count, variables, calls }) {
    if (count !== at) return;
    showVariables(variables);
    const open = calls.map((one) => `${one.kind} ${one.called}${one.repeats > 1 ? `, pass ${one.repeat} of ${one.repeats}` : ""}`);
    $("where").textContent = `${at} of ${ran.summary.steps}${open.length ? `, in ${visible(open.join(" < "))}` : ""}`;
  },
  refused({ message }) {
    idle();
    $("alarm").hidden = false;
    $("alarm").textContent = visible(message);
    say("Refused");
  },
};

function idle() {
  running = 0;
  clearTimeout(waiting);
  $("stop").disabled = true;
  document.body.dataset.state = "idle";
}

// ---- asking ----

function run() {
  if (running) stop();
  if (whole) files[0].text = $("text").value;
  const options = { main: $("main").value.trim(), record: 3, max_blocks: Number($("most").value) || 10000000 };
  if ($("start").value.trim() !== "") options.start = Number($("start").value);
  if ($("skip").checked) options.block_skip = 1;
  asked = { files, control: $("control").value, changes: $("changes").value.trim(), options, second: $("second").value };
  document.body.dataset.state = "running";
  $("stop").disabled = false;
  $("alarm").hidden = $("difference").hidden = true;
  say("Running");
  post("run", asked);
  running = job;
  if (whole) writeLink();
}

/** Ask the worker to stop; end it where it does not answer, as it cannot while it reads or compares. */
function stop() {
  post("stop", { of: running });
  clearTimeout(waiting);
  waiting = setTimeout(() => { restart(); say("Stopped"); }, 1500);
}

// ---- showing ----

function showRun() {
  const { summary, messages, calls } = ran;
  const why = summary.stop === "waiting" ? `waiting for ${summary.waiting}` : summary.stop;
  say(`${why}: ${summary.blocks.toLocaleString("en")} blocks, ${summary.moves.toLocaleString("en")} moves, ${summary.length.toFixed(1)} mm, ${summary.time.toFixed(1)} s`);
  document.body.dataset.stop = summary.stop;
  const alarm = summary.alarm;
  $("alarm").hidden = alarm === null;
  if (alarm) {
    $("alarm").textContent = alarm.shown.split("\n").map(visible).join("\n") + (alarm.cure ? `\ncure: ${alarm.cure}` : "");
    mark(alarm);
  }
  $("at").max = String(summary.steps);
  $("tab-messages").textContent = `Messages (${messages.length})`;
  $("messages").replaceChildren(...messages.map((text) => made("pre", text)));
  $("calls").replaceChildren(callTree(calls));
  $("tab-calls").textContent = `Calls (${calls.length})`;
  clearTimeout(waiting);
  if (summary.stop === "interrupted") idle();
  goTo(summary.steps);
}

/** Select the word that an alarm names, where the field holds its file. */
function mark({ at: place, column }) {
  if (!whole || place.file !== files[0].name) return;
  const lines = $("text").value.split("\n");
  const begin = lines.slice(0, place.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
  const line = lines[place.line - 1] || "";
  $("text").setSelectionRange(begin + Math.max(0, column - 1), begin + line.length);
  const high = parseFloat(getComputedStyle($("text")).lineHeight);
  $("text").scrollTop = Math.max(0, (place.line - 4) * high);
}

function callTree(calls) {
  const root = made("ul");
  const inside = new Map([[-1, root]]);
  calls.forEach((one, i) => {
    const item = made("li", `${one.kind} ${one.called}${one.start < 0 ? "" : ` from N${one.start}`}${one.repeats === 1 ? "" : `, ${one.repeats} passes`}`);
    item.append(made("span", one.last < 0 ? " not ended" : ` ${one.last - one.first + 1} blocks`, "where"));
    const list = made("ul");
    item.append(list);
    item.tabIndex = 0;
    item.onclick = (event) => { event.stopPropagation(); goTo(one.caller + 1); };
    (inside.get(one.parent) || root).append(item);
    inside.set(i, list);
  });
  return calls.length ? root : made("p", "No calls.");
}

function showVariables(variables) {
  const table = made("table");
  for (const { number, name, text } of variables) {
    const row = made("tr");
    row.append(made("td", name || `#${number}`), made("td", text));
    table.append(row);
  }
  $("variables").replaceChildren(variables.length ? table : made("p", "No variable has a value."));
  $("tab-variables").textContent = `Variables (${variables.length})`;
}

function showSteps(first, rows) {
  const items = rows.map(({ step, at: place, text, depth, skipped }) => {
    const item = made("li", undefined, step === at ? "now" : "");
    item.append(made("span", `${" ".repeat(2 * depth)}${place.program}:${place.line}`, "where"), made("span", text + (skipped ? "   (condition not met)" : "")));
    item.onclick = () => goTo(step + 1);
    item.dataset.step = step;
    return item;
  });
  $("steps").replaceChildren(...items);
  const now = $("steps").querySelector(".now") || $("steps").lastElementChild;
  if (now && !$("trace").hidden) now.scrollIntoView({ block: "nearest" });
}

/** Show the state after so many blocks. */
function goTo(count) {
  if (ran === null) return;
  at = Math.max(0, Math.min(count, ran.summary.steps));
  $("at").value = String(at);
  $("where").textContent = `${at} of ${ran.summary.steps}`;
  const first = Math.max(0, at - SHOWN_STEPS / 2);
  post("steps", { first, last: first + SHOWN_STEPS });
  if (at === ran.summary.steps) showVariables(ran.variables);
  else post("state", { count: at, options: asked.options });
  draw();
}

function showComparison() {
  const box = $("difference");
  box.hidden = false;
  box.className = compared.what ? "" : "same";
  if (!compared.what) {
    box.replaceChildren(made("strong", `${asked.control} and ${asked.second} do the same.`));
    return;
  }
  const lines = [made("strong", "The two part:"), made("pre")];
  lines[1].textContent = compared.what.split("\n").map(visible).join("\n");
  for (const rule of compared.rules) {
    lines.push(made("div", `because of ${rule.name}, ${rule.meaning}`));
    const table = made("table");
    [asked.control, asked.second].forEach((name, side) => {
      const row = made("tr");
      row.append(made("th", name), made("td", rule.values[side]), made("td", rule.examples[side]));
      table.append(row);
    });
    lines.push(table);
  }
  if (compared.rules.length === 0) lines.push(made("div", "No single rule makes it: it lies in the languages, or in their tables."));
  const go = made("button", "Go there");
  go.onclick = () => goTo(compared.steps[0]);
  box.replaceChildren(...lines, go);
}

function draw() {
  if (ran === null) return;
  const style = getComputedStyle(document.documentElement);
  const colours = Object.fromEntries(["front", "back", "cut", "rapid", "other", "mark"].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  const paths = [{ path: ran.path, cut: colours.cut, rapid: colours.rapid, name: asked.control }];
  if (compared && compared.what) paths.push({ path: compared.path, cut: colours.other, rapid: colours.rapid, name: asked.second });
  const inSpace = $("view").value === "3d";
  $("canvas").hidden = inSpace;
  $("space").hidden = !inSpace;
  $("drawn").textContent = ran.path.x.length ? `${ran.path.x.length.toLocaleString("en")} points` : "No moves.";
  if (!inSpace) drawPlane($("canvas"), paths, $("view").value, at, colours);
  else drawSpace($("space"), paths, at, colours).catch((error) => say(error.message));
}

// ---- files, examples and links ----

function show(of) {
  files = of;
  whole = typeof files[0].text === "string" && files[0].text.length <= MOST_SHOWN;
  $("text").value = whole ? files[0].text : "";
  $("text").readOnly = !whole;
  $("text").placeholder = whole ? "" : `${files[0].name} is too long to be shown; it is run as it is.`;
  $("file").textContent = files.map((one) => one.name).join(", ");
}

async function take(list) {
  const taken = [];
  for (const one of list) {
    const bytes = new Uint8Array(await one.arrayBuffer());
    let text = bytes;
    if (bytes.length <= MOST_SHOWN && list.length === 1)
      try { text = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes); } catch { text = bytes; }
    taken.push({ name: one.name, text });
  }
  if (taken.length) { show(taken); run(); }
}

async function packed(text, how) {
  const stream = new Blob([text]).stream().pipeThrough(how);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
async function writeLink() {
  const told = { t: files[0].text, f: files[0].name, c: asked.control, s: asked.second, p: asked.changes, m: $("main").value, n: $("start").value, k: $("skip").checked, b: $("most").value };
  if (told.t.length > 200000 || files.length > 1) return "";
  const bytes = await packed(JSON.stringify(told), new CompressionStream("deflate-raw"));
  let words = "";
  for (const one of bytes) words += String.fromCharCode(one);
  history.replaceState(null, "", `#${btoa(words).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`);
  return location.href;
}
async function fromLink() {
  const words = location.hash.slice(1);
  if (words === "") { choose(0); return; }
  try {
    const bytes = Uint8Array.from(atob(words.replaceAll("-", "+").replaceAll("_", "/")), (one) => one.charCodeAt(0));
    const told = JSON.parse(new TextDecoder().decode(await packed(bytes, new DecompressionStream("deflate-raw"))));
    $("control").value = told.c; $("second").value = told.s; $("changes").value = told.p; $("main").value = told.m;
    $("start").value = told.n; $("skip").checked = told.k; $("most").value = told.b;
    $("more").open = Boolean(told.p || told.m || told.n || told.k);
    show([{ name: told.f, text: told.t }]);
    run();
  } catch {
    say("This link is broken");
  }
}
function choose(index) {
  const example = PLAYGROUND.examples[index];
  $("control").value = example.control;
  $("main").value = $("start").value = "";
  show([{ name: example.name, text: example.text }]);
  run();
}

// ---- keys ----

for (const [id, title] of Object.entries(TABS)) {
  const tab = made("button", title);
  tab.id = `tab-${id}`;
  tab.setAttribute("role", "tab");
  tab.setAttribute("aria-controls", id);
  tab.onclick = () => {
    for (const other of Object.keys(TABS)) {
      $(other).hidden = other !== id;
      $(`tab-${other}`).setAttribute("aria-selected", String(other === id));
    }
    if (id === "path") draw();
  };
  $("tabs").append(tab);
}
$("tab-path").setAttribute("aria-selected", "true");
PLAYGROUND.examples.forEach(({ name }, i) => $("example").append(new Option(name, String(i))));
$("example").onchange = () => choose(Number($("example").value));
$("run").onclick = run;
$("stop").onclick = stop;
$("control").onchange = $("second").onchange = run;
$("view").onchange = draw;
$("at").oninput = () => goTo(Number($("at").value));
$("first").onclick = () => goTo(0);
$("back").onclick = () => goTo(at - 1);
$("next").onclick = () => goTo(at + 1);
$("last").onclick = () => goTo(Infinity);
$("open").onclick = () => $("files").click();
$("files").onchange = () => take([...$("files").files]);
$("link").onclick = async () => {
  if (whole) files[0].text = $("text").value;
  const link = whole && asked ? await writeLink() : "";
  if (link === "") { say("This program is too long for a link"); return; }
  await navigator.clipboard.writeText(link).then(() => say("The link is copied"), () => say("The link is in the address bar"));
};
document.addEventListener("keydown", (event) => {
  if (event.key === "Enter" && event.ctrlKey) run();
  else if (event.key === "Escape" && running) stop();
  else if (event.altKey && event.key === "ArrowRight") goTo(at + 1);
  else if (event.altKey && event.key === "ArrowLeft") goTo(at - 1);
  else return;
  event.preventDefault();
});
document.addEventListener("dragover", (event) => event.preventDefault());
document.addEventListener("drop", (event) => { event.preventDefault(); take([...event.dataTransfer.files]); });
window.addEventListener("resize", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
start().catch((error) => say(`The engine does not start: ${error.message}`));
