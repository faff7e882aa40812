// The page: what is asked of the worker, and what it answers. Texts of programs go into the page as text, never as HTML.
"use strict";

const $ = (id) => document.getElementById(id);
const TABS = { path: "Path", trace: "Blocks", calls: "Calls", variables: "Variables", findings: "Findings", messages: "Messages" };
const SHOWN_STEPS = 60;

let worker = null;
let wasm = null;
let job = 0;
let running = 0; // the job that runs
let shown = 0; // the job whose results are shown
let waiting = null; // ends a worker that does not answer
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
/** Show what would be invisible, or would turn the direction of what stands beside it; lines and tabs stay. */
const visible = (text) => text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]/g,
  (one) => `\\u${one.charCodeAt(0).toString(16).padStart(4, "0")}`);
const counted = (count, one) => `${count.toLocaleString("en")} ${one}${count === 1 ? "" : "s"}`;
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

/** Begin with a new engine, which knows nothing of what was run. */
function restart() {
  worker.terminate();
  clear();
  idle();
  begin();
}

/** Show no results: those that are there belong to no program that the engine still has. */
function clear() {
  [ran, compared, at, shown] = [null, null, 0, 0];
  $("alarm").hidden = $("difference").hidden = true;
  for (const id of ["steps", "calls", "variables", "findings", "messages"]) $(id).replaceChildren();
  for (const [id, title] of Object.entries(TABS)) $(`tab-${id}`).textContent = title;
  $("at").max = $("at").value = "0";
  $("where").textContent = $("drawn").textContent = "";
  delete document.body.dataset.stop;
  draw();
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
    [ran, compared, at, shown] = [told, null, told.summary.steps, told.job];
    showRun();
    performance.mark("answered");
  },
  checked({ job: of, findings }) {
    if (of !== shown) return;
    showFindings(findings);
    if (!asked.second) idle();
    else if (of === running) compares();
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
  refused({ job: of, message }) {
    if (of !== running && of < shown) return;
    clear();
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

/** Return the whole number in a field, `otherwise` where it is empty. */
function wholeOf(id, otherwise) {
  const text = $(id).value.trim();
  if (text === "") return otherwise;
  if (/^\d{1,15}$/.test(text)) return Number(text);
  throw new Error(`${$(id).parentElement.textContent.trim()}: ${text} is no whole number`);
}

function options() {
  const of = { maxBlocks: wholeOf("most", 10000000), start: wholeOf("start", undefined) };
  if ($("main").value.trim() !== "") of.main = $("main").value.trim();
  if ($("skip").checked) of.blockSkip = true;
  return of;
}

function run() {
  if (running) stop();
  keep();
  try {
    asked = { files, control: $("control").value, changes: $("changes").value.trim(), options: options(), second: $("second").value };
  } catch (error) {
    answers.refused({ job, message: error.message });
    return;
  }
  document.body.dataset.state = "running";
  $("stop").disabled = false;
  $("alarm").hidden = $("difference").hidden = true;
  say("Running");
  post("run", asked);
  running = job;
  if (linkable()) writeLink();
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
  say(`${why}: ${counted(summary.blocks, "block")}, ${counted(summary.moves, "move")}, ${summary.length.toFixed(1)} mm, ${summary.time.toFixed(1)} s`);
  document.body.dataset.stop = summary.stop;
  const alarm = summary.alarm;
  $("alarm").hidden = alarm === null;
  if (alarm) {
    $("alarm").textContent = visible(alarm.shown) + (alarm.cure ? `\ncure: ${alarm.cure}` : "");
    mark(alarm.at, alarm.column, alarm.word);
  }
  $("at").max = String(summary.steps);
  $("tab-messages").textContent = `Messages (${messages.length})`;
  $("messages").replaceChildren(...messages.map((text) => made("pre", text)));
  $("calls").replaceChildren(callTree(calls));
  $("tab-calls").textContent = `Calls (${calls.length})`;
  clearTimeout(waiting);
  if (summary.stop === "interrupted") idle();
  $("programs").replaceChildren(...ran.programs.map((name) => new Option(name)));
  goTo(summary.steps);
}

function showFindings(findings) {
  const list = made("ul");
  for (const one of findings) {
    const item = made("li");
    const go = made("button", `${one.at.program}, line ${one.at.line}`, "link");
    go.onclick = () => { mark(one.at, one.column, ""); $("text").focus(); };
    item.append(made("span", `${one.rule} ${one.severity}`, one.severity), " ", go, ` ${visible(one.message)}`);
    if (one.hint) item.append(made("div", one.hint, "where"));
    list.append(item);
  }
  $("findings").replaceChildren(findings.length ? list : made("p", "check finds nothing."));
  $("tab-findings").textContent = `Findings (${findings.length})`;
}

function callTree(calls) {
  const root = made("ul");
  const inside = new Map([[null, root]]);
  calls.forEach((one, i) => {
    const item = made("li", `${one.kind} ${one.called}${one.startN === null ? "" : ` from N${one.startN}`}${one.repeats === 1 ? "" : `, ${one.repeats} passes`}`);
    const go = made("button", item.textContent, "link");
    item.replaceChildren(go);
    item.append(made("span", one.lastStep === null ? " not ended" : ` ${counted(one.lastStep - one.firstStep + 1, "block")}`, "where"));
    const list = made("ul");
    item.append(list);
    go.onclick = () => goTo(one.callerStep + 1);
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

function compares() {
  $("difference").hidden = false;
  $("difference").className = "same";
  $("difference").replaceChildren(made("span", `Running on ${asked.second}, and looking for the rules that make a difference`));
}

function showComparison() {
  const box = $("difference");
  box.className = compared.what ? "" : "same";
  if (!compared.what) {
    box.replaceChildren(made("strong", `${asked.control} and ${asked.second} do the same.`));
    return;
  }
  const lines = [made("strong", "The two part:"), made("pre", compared.what)];
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
  if (ran === null) {
    drawPlane($("canvas"), [], "xy", {});
    return;
  }
  const style = getComputedStyle(document.documentElement);
  const colours = Object.fromEntries(["front", "back", "cut", "rapid", "other", "mark"].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  const paths = [{ path: ran.path, until: at, cut: colours.cut, rapid: colours.rapid, name: asked.control }];
  // After the last block the other control may still go on.
  const until = at === ran.summary.steps ? Infinity : at;
  if (compared && compared.what) paths.push({ path: compared.path, until, cut: colours.other, rapid: colours.rapid, name: asked.second });
  const inSpace = $("view").value === "3d";
  $("canvas").hidden = inSpace;
  $("space").hidden = !inSpace;
  $("drawn").textContent = ran.path.x.length ? counted(ran.path.x.length, "point") : "No moves.";
  if (!inSpace) drawPlane($("canvas"), paths, $("view").value, colours);
  else drawSpace($("space"), paths, colours).catch((error) => say(error.message));
}

// ---- keys ----

function openTab(id) {
  for (const other of Object.keys(TABS)) {
    $(other).hidden = other !== id;
    $(`tab-${other}`).setAttribute("aria-selected", String(other === id));
    $(`tab-${other}`).tabIndex = other === id ? 0 : -1;
  }
  if (id === "path") draw();
}

for (const [id, title] of Object.entries(TABS)) {
  const tab = made("button", title);
  tab.id = `tab-${id}`;
  tab.setAttribute("role", "tab");
  tab.setAttribute("aria-controls", id);
  $(id).setAttribute("aria-labelledby", tab.id);
  tab.onclick = () => openTab(id);
  tab.onkeydown = (event) => {
    const names = Object.keys(TABS);
    const way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (way === undefined || event.altKey) return;
    const next = names[(names.indexOf(id) + way + names.length) % names.length];
    openTab(next);
    $(`tab-${next}`).focus();
    event.preventDefault();
  };
  $("tabs").append(tab);
}
openTab("path");
$("run").onclick = run;
$("stop").onclick = stop;
$("control").onchange = $("second").onchange = run;
$("view").onchange = draw;
$("at").oninput = () => goTo(Number($("at").value));
const STEPS = { first: () => 0, back: () => at - 1, next: () => at + 1, last: () => Infinity };
for (const [id, to] of Object.entries(STEPS)) $(id).onclick = () => goTo(to());
const KEYS = { Home: "first", ArrowLeft: "back", ArrowRight: "next", End: "last" };
document.addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) run();
  else if (event.key === "Escape" && running) stop();
  else if (event.altKey && KEYS[event.key]) $(KEYS[event.key]).click();
  else return;
  event.preventDefault();
});
window.addEventListener("resize", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
const begin = () => start().catch((error) => say(`The engine does not start: ${error.message}`));
document.addEventListener("DOMContentLoaded", begin); // when the other scripts are there
