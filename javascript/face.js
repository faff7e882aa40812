// The C face of the engine (cncsub.h) as objects of JavaScript. What a control does with a program is nowhere here.

const SIZES = { text: 4, i32: 4, i64: 8, f64: 8 };
const up = (at, to) => Math.ceil(at / to) * to;

/** Lay a struct out as C does on a machine with pointers of four bytes. */
function structOf(fields) {
  const placed = [];
  let size = 0;
  let alignment = 4;
  for (const [name, kind] of Object.entries(fields)) {
    const wide = kind.size ?? SIZES[kind];
    const to = kind.alignment ?? wide;
    size = up(size, to);
    placed.push({ name, kind, at: size });
    size += wide;
    alignment = Math.max(alignment, to);
  }
  return { fields: placed, size: up(size, alignment), alignment };
}

const PLACE = structOf({ program: "text", file: "text", n: "i64", line: "i32" });
const STRUCTS = {
  place: PLACE,
  alarm: structOf({ number: "text", cause: "text", text: "text", shown: "text", cure: "text", at: PLACE, column: "i32" }),
  call: structOf({ at: PLACE, kind: "text", called: "text", repeat: "i64", repeats: "i64" }),
  finding: structOf({ rule: "text", severity: "text", message: "text", at: PLACE, column: "i32" }),
  step: structOf({ at: PLACE, text: "text", depth: "i32", skipped: "i32" }),
  call_made: structOf({ kind: "text", called: "text", parent: "i64", start_n: "i64", repeats: "i64", caller_step: "i64",
    first_step: "i64", last_step: "i64" }),
  variable: structOf({ number: "i64", name: "text", value: "f64", text: "text" }),
  rule: structOf({ name: "text", meaning: "text", value0: "text", value1: "text", example0: "text", example1: "text" }),
};
const NUMBERS = ["x", "y", "z", "mx", "my", "mz", "cx", "cy", "cz", "feed", "length", "time"]; // cncsub_columns begins so
const MOVE_KINDS = Object.freeze(["rapid", "feed", "cw", "ccw", "thread", "dwell"]);
const RECORDS = ["nothing", "calls", "blocks", "moves"];
const NUMBER_OPTIONS = { start: "start", maxBlocks: "max_blocks", maxCycles: "max_cycles", maxSeconds: "max_seconds" };
const MOST = Number.MAX_SAFE_INTEGER;

const absent = (whole) => (whole < 0 ? null : whole);

/** The memory of the engine. Its views are replaced when it grows: they are always asked of the module. */
class Memory {
  #decoder = new TextDecoder();
  #encoder = new TextEncoder();

  constructor(module) {
    this.module = module;
    this.room = module._malloc(Math.max(...Object.values(STRUCTS).map((one) => one.size), 4 * (NUMBERS.length + 2)));
  }

  text(at) {
    if (at === 0) return "";
    const heap = this.module.HEAPU8;
    return this.#decoder.decode(heap.subarray(at, heap.indexOf(0, at)));
  }

  i32(at) { return this.module.HEAP32[at >> 2]; }
  f64(at) { return this.module.HEAPF64[at >> 3]; }
  i64(at) { return this.i32(at + 4) * 4294967296 + (this.i32(at) >>> 0); }

  struct(kind, at = this.room) {
    const made = {};
    for (const { name, kind: of, at: offset } of kind.fields)
      made[name] = of.fields ? this.struct(of, at + offset) : of === "text" ? this.text(this.i32(at + offset)) : this[of](at + offset);
    if (kind === PLACE) made.n = absent(made.n);
    return made;
  }

  take(size) {
    const at = this.module._malloc(size);
    if (at === 0) throw new Error("there is no memory left");
    return at;
  }

  /** Put a text, or bytes, with a zero behind it into the memory. */
  put(value) {
    const bytes = typeof value === "string" ? this.#encoder.encode(value) : value;
    const at = this.take(bytes.length + 1);
    this.module.HEAPU8.set(bytes, at);
    this.module.HEAPU8[at + bytes.length] = 0;
    return { at, size: bytes.length };
  }

  /** Call the function with the places of texts, which hold until it returns. A text of C ends at its first zero. */
  withTexts(texts, use) {
    const placed = [];
    try {
      for (const one of texts) placed.push(this.put(String(one).replace(/\0[^]*$/, "")));
      return use(...placed.map((one) => one.at));
    } finally {
      for (const one of placed) this.module._free(one.at);
    }
  }

  refuse() { throw new Error(this.text(this.module._cncsub_error())); }
  made(handle) { return handle || this.refuse(); }

  /** Read structs by their index until there is none, or `most` of them. */
  listed(kind, most, next) {
    const rows = [];
    while (rows.length < most && next(rows.length, this.room)) rows.push(this.struct(kind));
    return rows;
  }

  /** Read texts by their index until there is none, or `most` of them. */
  texts(most, next) {
    const all = [];
    for (let at; all.length < most && (at = next(all.length)) !== 0; ) all.push(this.text(at));
    return all;
  }
}

const forgotten = new FinalizationRegistry((free) => free());

/** A handle of the C face. One that is forgotten is freed some time after; `free` does it now. */
class Held {
  #handle;
  #free;

  constructor(memory, handle, free) {
    this._memory = memory;
    this._module = memory.module;
    this.#handle = handle;
    this.#free = () => free(handle);
    forgotten.register(this, this.#free, this);
  }

  get _handle() {
    if (this.#handle === 0) throw new Error(`this ${this.constructor.name} was freed`);
    return this.#handle;
  }

  free() {
    if (this.#handle === 0) return;
    this.#handle = 0;
    forgotten.unregister(this);
    this.#free();
  }
}
if (Symbol.dispose) Held.prototype[Symbol.dispose] = Held.prototype.free;

function wholeNumber(value, name) {
  if (!Number.isSafeInteger(value)) throw new TypeError(`${name} must be a whole number, not ${value}`);
  return BigInt(value);
}

function axisCode(axis) {
  const letter = String(axis).toUpperCase();
  if (!/^[A-Z]$/.test(letter)) throw new TypeError(`an axis is one letter, not ${axis}`);
  return letter.charCodeAt(0);
}

/** Return changed rules and parameters as the lines that the engine reads. */
function linesOf(changes) {
  if (typeof changes === "string") return changes;
  return Object.entries(changes).map(([name, value]) => {
    if (/[=\n]/.test(name) || /\n/.test(String(value))) throw new TypeError(`${name} is no rule or parameter with one value`);
    return `${name}=${value}`;
  }).join("\n");
}

/** Return files as [{name, text}]: of one text, of {name: text}, or of such a list. */
function filesOf(files) {
  if (typeof files === "string" || ArrayBuffer.isView(files)) files = [{ name: "program.nc", text: files }];
  else if (!Array.isArray(files)) files = Object.entries(files).map(([name, text]) => ({ name, text }));
  for (const { name, text } of files) {
    if (typeof name !== "string") throw new TypeError("each file has a name");
    if (typeof text !== "string" && !(text instanceof Uint8Array)) throw new TypeError(`the text of ${name} must be a string or a Uint8Array`);
  }
  return files;
}

class Engine {
  #memory;

  /** `module`: what Emscripten's loader gives. `start` makes one. */
  constructor(module) { this.#memory = new Memory(module); }

  get version() { return this.#memory.text(this.#memory.module._cncsub_version()); }

  get controls() {
    const { module } = this.#memory;
    const names = this.#memory.texts(Infinity, (i) => module._cncsub_control(i));
    return names.map((name, i) => ({ name, title: this.#memory.text(module._cncsub_control_title(i)) }));
  }

  load(files, control, changes = "") {
    const memory = this.#memory;
    const { module } = memory;
    const given = filesOf(files);
    const count = given.length;
    const placed = [];
    const lists = memory.take(12 * count + 4);
    let library;
    try {
      for (const { name, text } of given) placed.push(memory.put(name), memory.put(text));
      placed.forEach(({ at }, i) => { module.HEAP32[(lists >> 2) + (i % 2) * count + (i >> 1)] = at; });
      given.forEach((_, i) => { module.HEAP32[(lists >> 2) + 2 * count + i] = placed[2 * i + 1].size; });
      library = new Library(memory, memory.made(memory.withTexts([control], (name) =>
        module._cncsub_library_new(name, count, lists, lists + 4 * count, lists + 8 * count))));
    } finally {
      for (const { at } of placed) module._free(at);
      module._free(lists);
    }
    const lines = linesOf(changes);
    if (lines.trim() === "") return library;
    try {
      return library.for(control, lines);
    } finally {
      library.free();
    }
  }

  compare(first, second, options = {}) {
    const { module } = this.#memory;
    return withOptions(this.#memory, options, (given) =>
      new Comparison(this.#memory, this.#memory.made(module._cncsub_compare(first._handle, second._handle, given))));
  }
}

function setNumber(memory, options, name, value) {
  if (typeof value !== "number") throw new TypeError(`${name} must be a number, not ${value}`);
  if (!memory.withTexts([name], (at) => memory.module._cncsub_options_number(options, at, value))) memory.refuse();
}

function setText(memory, options, name, value) {
  if (!memory.withTexts([name, value], (at, text) => memory.module._cncsub_options_text(options, at, text))) memory.refuse();
}

/** Hand over {number: value}. */
function setEach(values, name, set) {
  for (const [number, value] of Object.entries(values)) {
    const of = Number(wholeNumber(Number(number), name));
    if (of !== (of | 0)) throw new TypeError(`there is no ${number}`);
    set(of, value);
  }
}

const OPTIONS = {
  main: (memory, to, value) => setText(memory, to, "main", value),
  machine: (memory, to, value) => setText(memory, to, "machine", value),
  optionalStop: (memory, to, value) => setNumber(memory, to, "optional_stop", value ? 1 : 0),
  blockSkip(memory, to, value) {
    for (const number of value === true ? [1] : value || []) setNumber(memory, to, "block_skip", number);
  },
  record(memory, to, value) {
    if (!RECORDS.includes(value)) throw new TypeError(`record is one of ${RECORDS.join(", ")}, not ${value}`);
    setNumber(memory, to, "record", RECORDS.indexOf(value));
  },
  variables: ({ module }, to, value) => setEach(value, "a variable", (of, now) => module._cncsub_options_variable(to, of, now ?? NaN)),
  signals: ({ module }, to, value) => setEach(value, "a signal", (of, now) => module._cncsub_options_signal(to, of, now)),
  lengthOffsets: ({ module }, to, value) => setEach(value, "an offset", (of, now) => module._cncsub_options_length_offset(to, of, now)),
  radiusOffsets: ({ module }, to, value) => setEach(value, "an offset", (of, now) => module._cncsub_options_radius_offset(to, of, now)),
  startPosition({ module }, to, value) {
    for (const [axis, now] of Object.entries(value)) module._cncsub_options_start_position(to, axisCode(axis), now);
  },
  workOffsets(memory, to, value) {
    for (const [system, axes] of Object.entries(value))
      for (const [axis, now] of Object.entries(axes))
        memory.withTexts([system], (at) => memory.module._cncsub_options_work_offset(to, at, axisCode(axis), now));
  },
};
for (const [name, option] of Object.entries(NUMBER_OPTIONS)) OPTIONS[name] = (memory, to, value) => setNumber(memory, to, option, value);

/** Call the function with options as the engine takes them. An option that is undefined is not given. */
function withOptions(memory, given, use) {
  const options = memory.made(memory.module._cncsub_options_new());
  try {
    for (const [name, value] of Object.entries(given)) {
      if (!Object.hasOwn(OPTIONS, name)) throw new TypeError(`there is no option ${name}; there are ${Object.keys(OPTIONS).sort().join(", ")}`);
      if (value !== undefined) OPTIONS[name](memory, options, value);
    }
    return use(options);
  } finally {
    memory.module._cncsub_options_free(options);
  }
}

class Library extends Held {
  constructor(memory, handle) { super(memory, handle, memory.module._cncsub_library_free); }

  get programs() { return this._memory.texts(Infinity, (i) => this._module._cncsub_library_program(this._handle, i)); }

  for(control, changes = "") {
    return new Library(this._memory, this._memory.made(this._memory.withTexts([control, linesOf(changes)], (name, lines) =>
      this._module._cncsub_library_for(this._handle, name, lines))));
  }

  run(options = {}) {
    return withOptions(this._memory, options, (given) =>
      new Run(this._memory, this._memory.made(this._module._cncsub_library_run(this._handle, given))));
  }

  machine(options = {}) {
    return withOptions(this._memory, options, (given) =>
      new Machine(this._memory, this._memory.made(this._module._cncsub_library_machine(this._handle, given))));
  }

  check(most = Infinity) {
    this._module._cncsub_library_check(this._handle);
    const found = this._memory.listed(STRUCTS.finding, most, (i, to) => this._module._cncsub_library_finding(this._handle, i, to));
    found.forEach((one, i) => { one.hint = this._memory.text(this._module._cncsub_library_hint(this._handle, i)); });
    return found;
  }
}

class Run extends Held {
  constructor(memory, handle) { super(memory, handle, memory.module._cncsub_run_free); }

  get stop() { return this._memory.text(this._module._cncsub_run_stop(this._handle)); }
  get waitingFor() { return this._memory.text(this._module._cncsub_run_waiting_for(this._handle)); }
  get blocks() { return Number(this._module._cncsub_run_blocks(this._handle)); }
  get stepCount() { return this._module._cncsub_run_steps(this._handle); }
  get callCount() { return this._module._cncsub_run_calls(this._handle); }
  get moveCount() { return this._module._cncsub_run_moves(this._handle); }
  get length() { return this._module._cncsub_run_length(this._handle); }
  get time() { return this._module._cncsub_run_time(this._handle); }
  get messages() { return this._memory.texts(Infinity, (i) => this._module._cncsub_run_message(this._handle, i)); }

  get alarm() {
    if (!this._module._cncsub_run_alarm(this._handle, this._memory.room)) return null;
    const alarm = this._memory.struct(STRUCTS.alarm);
    alarm.word = this._memory.text(this._module._cncsub_run_alarm_word(this._handle));
    alarm.stack = this._memory.listed(STRUCTS.call, Infinity, (i, to) => this._module._cncsub_run_alarm_call(this._handle, i, to));
    return alarm;
  }

  step(index) { return this.steps(index, index + 1)[0] ?? null; }

  steps(first = 0, last = Infinity) {
    if (first < 0) return [];
    return this._memory.listed(STRUCTS.step, last - first, (i, to) => this._module._cncsub_run_step(this._handle, first + i, to))
      .map((one, i) => ({ step: first + i, ...one, skipped: one.skipped !== 0 }));
  }

  calls(most = Infinity) {
    return this._memory.listed(STRUCTS.call_made, most, (i, to) => this._module._cncsub_run_call(this._handle, i, to)).map((one) => ({
      kind: one.kind, called: one.called, repeats: one.repeats, parent: absent(one.parent), startN: absent(one.start_n),
      callerStep: one.caller_step, firstStep: absent(one.first_step), lastStep: absent(one.last_step),
    }));
  }

  variables(most = Infinity) {
    this._module._cncsub_run_variables(this._handle);
    return this._memory.listed(STRUCTS.variable, most, (i, to) => this._module._cncsub_run_variable_at(this._handle, i, to))
      .map((one) => ({ number: absent(one.number), name: one.name, value: Number.isNaN(one.value) ? null : one.value, text: one.text }));
  }

  variable(number) { return variableOf(this, (of) => this._module._cncsub_run_variable(this._handle, of), number); }

  moves() {
    const { room } = this._memory;
    const count = this.moveCount;
    const at = this._memory.take(up(count * (8 * NUMBERS.length + 12), 8) + 8);
    const start = up(at, 8);
    const placeOf = (column) => start + 8 * count * column;
    const stepAt = placeOf(NUMBERS.length);
    const kindAt = placeOf(NUMBERS.length + 1);
    NUMBERS.forEach((_, i) => { this._module.HEAP32[(room >> 2) + i] = placeOf(i); });
    this._module.HEAP32[(room >> 2) + NUMBERS.length] = kindAt;
    this._module.HEAP32[(room >> 2) + NUMBERS.length + 1] = stepAt;
    try {
      if (!this._module._cncsub_run_write_moves(this._handle, room)) this._memory.refuse();
      const heap = this._module.HEAPF64;
      const moves = { count };
      NUMBERS.forEach((name, i) => { moves[name] = heap.slice(placeOf(i) >> 3, (placeOf(i) >> 3) + count); });
      moves.kind = Uint8Array.from(this._module.HEAP32.subarray(kindAt >> 2, (kindAt >> 2) + count));
      moves.step = Float64Array.from({ length: count }, (_, i) => this._memory.i64(stepAt + 8 * i));
      return moves;
    } finally {
      this._module._free(at);
    }
  }

  path(tolerance = 0.05) {
    const count = this._module._cncsub_run_path(this._handle, tolerance);
    const at = this._memory.take(29 * count + 8);
    const start = up(at, 8);
    const [x, y, z, move, begins] = [0, 8, 16, 24, 28].map((column) => start + column * count);
    try {
      if (!this._module._cncsub_run_write_path(this._handle, x, y, z, move, begins)) this._memory.refuse();
      const column = (from) => this._module.HEAPF64.slice(from >> 3, (from >> 3) + count);
      return { count, x: column(x), y: column(y), z: column(z), move: this._module.HEAPU32.slice(move >> 2, (move >> 2) + count),
        begins: this._module.HEAPU8.slice(begins, begins + count) };
    } finally {
      this._module._free(at);
    }
  }
}

/** Return the value of a variable, null where it is vacant. Throws where the control has none of this number. */
function variableOf(of, read, number) {
  const value = read(wholeNumber(number, "a variable"));
  if (!Number.isNaN(value)) return value;
  const why = of._memory.text(of._module._cncsub_error());
  if (why !== "") throw new RangeError(why);
  return null;
}

class Machine extends Held {
  constructor(memory, handle) { super(memory, handle, memory.module._cncsub_machine_free); }

  get stop() { return this._memory.text(this._module._cncsub_machine_stop(this._handle)); }
  step() { return this._module._cncsub_machine_step(this._handle) !== 0; }
  run(blocks = MOST) { return this._module._cncsub_machine_run(this._handle, wholeNumber(Math.min(blocks, MOST), "blocks")) !== 0; }

  runTo(program, n) {
    const number = wholeNumber(n, "n");
    if (this._memory.withTexts([program], (at) => this._module._cncsub_machine_run_to(this._handle, at, number))) return true;
    return this.stop === "running" ? this._memory.refuse() : false;
  }

  interrupt() {
    this._module._cncsub_machine_interrupt(this._handle);
    this._module._cncsub_machine_run(this._handle, 1n);
  }

  get next() {
    this._module._cncsub_machine_next(this._handle, this._memory.room);
    return this._memory.struct(PLACE);
  }

  stack(most = Infinity) {
    return this._memory.listed(STRUCTS.call, most, (i, to) => this._module._cncsub_machine_call(this._handle, i, to));
  }

  get alarm() {
    const run = this.soFar();
    try {
      return run.alarm;
    } finally {
      run.free();
    }
  }

  position(axis) {
    const value = this._module._cncsub_machine_position(this._handle, axisCode(axis));
    return Number.isNaN(value) ? null : value;
  }

  variable(number) { return variableOf(this, (of) => this._module._cncsub_machine_variable(this._handle, of), number); }

  setVariable(number, value) {
    if (!this._module._cncsub_machine_set_variable(this._handle, wholeNumber(number, "a variable"), value ?? NaN)) this._memory.refuse();
  }

  soFar() { return new Run(this._memory, this._memory.made(this._module._cncsub_machine_so_far(this._handle))); }
}

class Comparison extends Held {
  constructor(memory, handle) { super(memory, handle, memory.module._cncsub_comparison_free); }

  get what() { return this._memory.text(this._module._cncsub_comparison_what(this._handle)); }
  get same() { return this.what === ""; }
  get steps() { return [0, 1].map((side) => Number(this._module._cncsub_comparison_step(this._handle, side))); }

  get rules() {
    return this._memory.listed(STRUCTS.rule, Infinity, (i, to) => this._module._cncsub_comparison_rule(this._handle, i, to)).map((one) => ({
      name: one.name, meaning: one.meaning, values: [one.value0, one.value1], examples: [one.example0, one.example1],
    }));
  }

  run(side) { return new Run(this._memory, this._memory.made(this._module._cncsub_comparison_run(this._handle, side))); }
}
