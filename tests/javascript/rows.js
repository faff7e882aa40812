// Runs the rows of the self-test (tools/selftest_rows.py) through the package: node rows.js PACKAGE ROWS
//
// What the face has no word for is left out, and counted by its reason. The last line tells the counts; each row that
// comes out otherwise is named before it.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";

const [folder, rows] = process.argv.slice(2);
const { start, MOVE_KINDS } = await import(pathToFileURL(resolve(folder, "cncsub.js")));
const cncsub = await start();

const MEANT = { "\\\\": "\\", "\\t": "\t", "\\n": "\n", "\\r": "\r" };
const plain = (field) => field.replace(/\\[\\tnr]/g, (one) => MEANT[one]);
const number = (field) => (field === "vacant" ? NaN : Number(field));
const near = (a, b) => a === b || (Number.isNaN(a) && Number.isNaN(b)) || Math.abs(a - b) <= 1e-7 * Math.max(1, Math.abs(a), Math.abs(b));

const NAMELESS = "<text>"; // a text without a name, which Python's messages call so

class LeftOut extends Error {}

const NO_WORD = new Set(["rapid", "limits", "stroke_area", "reference", "tools", "clock_ms", "date",
  "time", "operator", "write", "answer", "skip"]);

const GIVEN = {
  control(row, name) { row.control = name; },
  parameter(row, name, value) { row.changes.push([name, value]); },
  rule(row, name, kind, value) {
    if (value.includes("\n")) throw new LeftOut("a rule of several lines");
    row.changes.push([name, kind === "yes" ? String(value === "1") : value]);
  },
  file(row, name, stem, external, text) {
    if (external === "1") throw new LeftOut("a file on a device");
    row.files.push({ name: name === NAMELESS ? "" : name, text });
  },
  device() { throw new LeftOut("a device"); },
  typed() { throw new LeftOut("MDI"); },
  main(row, index) { row.main = Number(index); },
  mdi(row, on) { if (on === "1") throw new LeftOut("MDI"); },
  optional_stop(row, on) { row.options.optionalStop = on === "1"; },
  start(row, of, at) {
    if (at === undefined) row.options.start = Number(of);
    else (row.options.startPosition ??= {})[of] = Number(at);
  },
  max_cycles(row, count) { row.options.maxCycles = Number(count); },
  max_blocks(row, count) { row.options.maxBlocks = Number(count); },
  trace() {},
  increment(row, size) { if (Number(size) !== 0.001) throw new LeftOut("an increment of its own"); },
  given(row, of, value) { (row.options.variables ??= {})[of] = value === "vacant" ? null : Number(value); },
  skip_switch(row, of) { (row.options.blockSkip ??= []).push(Number(of)); },
  machine(row, kind) { row.options.machine = kind; },
  signal(row, of, value) { (row.options.signals ??= {})[of] = Number(value); },
  work_offsets(row, system, axis, value) { ((row.options.workOffsets ??= {})[system] ??= {})[axis] = Number(value); },
  radius_offsets(row, of, value) { (row.options.radiusOffsets ??= {})[of] = Number(value); },
  length_offsets(row, of, value) { (row.options.lengthOffsets ??= {})[of] = Number(value); },
};

/** What is compared, by the keys of the rows; the others tell what the face does not. */
const FOUND = {
  *stop({ run }) { yield [run.stop]; },
  *alarm({ alarm }) {
    if (alarm) yield [alarm.cause, alarm.number, alarm.at.program, alarm.at.n ?? -1, alarm.at.line, alarm.column, alarm.word];
  },
  *message({ alarm }) { if (alarm) yield [alarm.shown]; },
  *steps({ run }) { yield [run.stepCount]; },
  *step({ run }) { for (const { at } of run.steps(0, 300)) yield [at.program, at.line, at.n ?? -1]; },
  *messages({ run }) { for (const text of run.messages) yield [text]; },
  *call({ run }) { for (const one of run.calls()) yield [one.kind, one.called, undefined, one.callerStep]; },
  *moves({ run }) { yield [run.moveCount, run.length, run.time]; },
  *move({ run }) {
    const of = run.moves();
    for (let i = 0; i < Math.min(of.count, 300); ++i)
      yield [MOVE_KINDS[of.kind[i]], of.x[i], of.y[i], of.z[i], of.mx[i], of.my[i], of.mz[i], of.feed[i], of.time[i]];
  },
  *variable({ run }, expected) { for (const [of] of expected) yield [Number(of), run.variable(Number(of)) ?? NaN]; },
};

const same = (expected, found) => found.every((value, i) =>
  value === undefined || (typeof value === "number" ? near(number(expected[i]), value) : expected[i] === value));

/** Return the first difference of a row, or nothing. Where two programs have one name, the one that runs is not named. */
function difference(row) {
  const library = cncsub.load(row.files, row.control, row.changes.map((one) => one.join("=")).join("\n"));
  try {
    const main = library.programs[row.main];
    if (main === undefined) throw new LeftOut("a program that is not listed");
    return differenceOf(library, row, main) && differenceOf(library, row, undefined);
  } finally {
    library.free();
  }
}

function differenceOf(library, row, main) {
  const run = library.run({ ...row.options, main });
  try {
    const seen = { run, alarm: run.alarm };
    for (const [key, tell] of Object.entries(FOUND)) {
      let expected = row.outcome.get(key) ?? [];
      if (key === "variable") expected = expected.filter(([of]) => Number(of) > 33); // locals are of the level that stopped
      const found = [...tell(seen, expected)];
      if (expected.length !== found.length) return `${key}: expected ${expected.length}, got ${found.length}`;
      const wrong = expected.findIndex((line, i) => !same(line, found[i]));
      if (wrong >= 0) return `${key}: expected ${expected[wrong].join(" ")}\n      got      ${found[wrong].join(" ")}`;
    }
    return "";
  } finally {
    run.free();
  }
}

const count = { rows: 0, passed: 0, failed: 0, left_out: {} };
let row = null;
let reason = "";

function end() {
  ++count.rows;
  try {
    if (reason) throw new LeftOut(reason);
    const wrong = difference(row);
    if (wrong) console.log(`${row.name}\n  ${wrong}`);
    ++count[wrong ? "failed" : "passed"];
  } catch (error) {
    if (error instanceof LeftOut) {
      count.left_out[error.message] = (count.left_out[error.message] ?? 0) + 1;
    } else {
      ++count.failed;
      console.log(`${row.name}\n  ${error.stack}`);
    }
  }
}

for (const line of readFileSync(rows, "utf8").split("\n")) {
  const [key, ...fields] = line.split("\t").map(plain);
  if (key === "row") {
    [row, reason] = [{ name: fields[0], changes: [], files: [], options: {}, outcome: new Map() }, ""];
  } else if (key === "end") {
    end();
  } else if (row !== null && (Object.hasOwn(FOUND, key) || ["m_codes", "t_codes", "position", "modal"].includes(key))) {
    if (!row.outcome.has(key)) row.outcome.set(key, []);
    row.outcome.get(key).push(key === "message" ? fields.map((one) => one.replaceAll(NAMELESS, "")) : fields);
  } else if (row !== null && key !== "" && !reason) {
    try {
      if (NO_WORD.has(key)) throw new LeftOut(`an option ${key}`);
      GIVEN[key](row, ...fields);
    } catch (error) {
      if (!(error instanceof LeftOut)) throw error;
      reason = error.message;
    }
  }
}
console.log(JSON.stringify(count));
