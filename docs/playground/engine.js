// The C face of the engine (cncsub.h) as plain objects. It runs in a worker; nothing here knows what a program means.
// Structs are laid out as on every 32-bit machine: pointers and int32 have 4 bytes, int64 and double have 8.
"use strict";

function engineOf(module) {
  // The views of the memory are replaced when it grows: they are always asked of the module.
  const decoder = new TextDecoder();
  const encoder = new TextEncoder();

  const text = (at) => {
    if (at === 0) return "";
    const heap = module.HEAPU8;
    let end = at;
    while (heap[end] !== 0) ++end;
    return decoder.decode(heap.subarray(at, end));
  };
  const i32 = (at) => module.HEAP32[at >> 2];
  const f64 = (at) => module.HEAPF64[at >> 3];
  const i64 = (at) => module.HEAP32[(at >> 2) + 1] * 4294967296 + (module.HEAP32[at >> 2] >>> 0);
  const number = (value) => BigInt(value);

  /** Put bytes with a zero behind them into the memory of the engine. */
  const put = (value) => {
    const bytes = typeof value === "string" ? encoder.encode(value) : value;
    const at = module._malloc(bytes.length + 1);
    if (at === 0) throw new Error("there is no memory left");
    module.HEAPU8.set(bytes, at);
    module.HEAPU8[at + bytes.length] = 0;
    return { at, size: bytes.length };
  };
  const withTexts = (texts, use) => {
    const placed = texts.map(put);
    try {
      return use(...placed.map((one) => one.at));
    } finally {
      for (const one of placed) module._free(one.at);
    }
  };
  const room = module._malloc(128); // of one struct
  const refuse = () => {
    throw new Error(text(module._cncsub_error()));
  };
  const made = (handle) => handle || refuse();

  const place = (at) => ({ program: text(i32(at)), file: text(i32(at + 4)), n: i64(at + 8), line: i32(at + 16) });
  const openCall = (at) => ({
    at: place(at), kind: text(i32(at + 24)), called: text(i32(at + 28)), repeat: i64(at + 32), repeats: i64(at + 40),
  });
  /** Read structs by their index until there is none, or `most` of them. */
  const listed = (next, read, most = Infinity) => {
    const rows = [];
    while (rows.length < most && next(rows.length, room)) rows.push(read(room));
    return rows;
  };

  /** Read texts by their index until there is none, or `most` of them. */
  const texts = (next, most = Infinity) => {
    const all = [];
    for (let at; all.length < most && (at = next(all.length)) !== 0; ) all.push(text(at));
    return all;
  };

  const alarmOf = (run) => {
    if (!module._cncsub_run_alarm(run, room)) return null;
    const [numberText, cause, said, shown, cure] = [0, 4, 8, 12, 16].map((offset) => text(i32(room + offset)));
    const alarm = { number: numberText, cause, text: said, shown, cure, at: place(room + 24), column: i32(room + 48) };
    alarm.calls = listed((i, to) => module._cncsub_run_alarm_call(run, i, to), openCall, 1000);
    return alarm;
  };

  return {
    version: () => text(module._cncsub_version()),
    controls: () => texts((i) => module._cncsub_control(i)).map((name, i) => ({ name, title: text(module._cncsub_control_title(i)) })),

    /** Read files, [{name, text: string or bytes}], for a control with changed rules and parameters. */
    read(files, control, changes) {
      const placed = files.flatMap((file) => [put(file.name), put(file.text)]);
      const lists = module._malloc(12 * files.length + 4) >> 2;
      files.forEach((_, i) => {
        module.HEAP32[lists + i] = placed[2 * i].at;
        module.HEAP32[lists + files.length + i] = placed[2 * i + 1].at;
        module.HEAP32[lists + 2 * files.length + i] = placed[2 * i + 1].size;
      });
      const at = lists << 2;
      const step = 4 * files.length;
      try {
        const plain = made(withTexts([control], (name) =>
          module._cncsub_library_new(name, files.length, at, at + step, at + 2 * step)));
        if (!changes) return plain;
        try {
          return this.readFor(plain, control, changes);
        } finally {
          module._cncsub_library_free(plain);
        }
      } finally {
        for (const one of placed) module._free(one.at);
        module._free(at);
      }
    },
    readFor: (library, control, changes) =>
      made(withTexts([control, changes || ""], (name, lines) => module._cncsub_library_for(library, name, lines))),
    freeLibrary: (library) => module._cncsub_library_free(library),
    check(library) {
      module._cncsub_library_check(library);
      const found = listed((i, to) => module._cncsub_library_finding(library, i, to), (at) => ({
        rule: text(i32(at)), severity: text(i32(at + 4)), message: text(i32(at + 8)), at: place(at + 16), column: i32(at + 40),
      }), 2000);
      found.forEach((finding, i) => { finding.hint = text(module._cncsub_library_hint(library, i)); });
      return found;
    },

    /** Make options of {main, start, block_skip, optional_stop, max_blocks, record}. */
    options(of) {
      const options = made(module._cncsub_options_new());
      for (const [name, value] of Object.entries(of)) {
        if (value === "" || value === null || value === undefined) continue;
        const set = typeof value === "number"
          ? withTexts([name], (at) => module._cncsub_options_number(options, at, value))
          : withTexts([name, value], (at, to) => module._cncsub_options_text(options, at, to));
        if (!set) refuse();
      }
      return options;
    },
    freeOptions: (options) => module._cncsub_options_free(options),

    machine: (library, options) => made(module._cncsub_library_machine(library, options)),
    freeMachine: (machine) => module._cncsub_machine_free(machine),
    runBlocks: (machine, blocks) => module._cncsub_machine_run(machine, number(blocks)) !== 0,
    interrupt(machine) {
      module._cncsub_machine_interrupt(machine);
      module._cncsub_machine_step(machine);
    },
    soFar: (machine) => made(module._cncsub_machine_so_far(machine)),
    freeRun: (run) => module._cncsub_run_free(run),
    calls: (machine) => listed((i, to) => module._cncsub_machine_call(machine, i, to), openCall, 1000),

    summary: (run) => ({
      stop: text(module._cncsub_run_stop(run)), waiting: text(module._cncsub_run_waiting_for(run)),
      alarm: alarmOf(run), blocks: Number(module._cncsub_run_blocks(run)), moves: module._cncsub_run_moves(run),
      steps: module._cncsub_run_steps(run), length: module._cncsub_run_length(run), time: module._cncsub_run_time(run),
    }),
    messages: (run) => texts((i) => module._cncsub_run_message(run, i), 1000),
    steps(run, first, last) {
      const rows = [];
      for (let i = first; i < last && module._cncsub_run_step(run, i, room); ++i)
        rows.push({ step: i, at: place(room), text: text(i32(room + 24)), depth: i32(room + 28), skipped: i32(room + 32) !== 0 });
      return rows;
    },
    callsMade: (run, most) => listed((i, to) => module._cncsub_run_call(run, i, to), (at) => ({
      kind: text(i32(at)), called: text(i32(at + 4)), parent: i64(at + 8), start: i64(at + 16), repeats: i64(at + 24),
      caller: i64(at + 32), first: i64(at + 40), last: i64(at + 48),
    }), most),
    variables(run) {
      module._cncsub_run_variables(run);
      return listed((i, to) => module._cncsub_run_variable_at(run, i, to), (at) => ({
        number: i64(at), name: text(i32(at + 8)), value: f64(at + 16), text: text(i32(at + 24)),
      }), 5000);
    },
    /** Return the path as typed arrays: points, the steps and the kinds of their moves. */
    path(run, tolerance) {
      const count = module._cncsub_run_path(run, tolerance);
      const moves = module._cncsub_run_moves(run);
      const at = module._malloc(29 * count + 12 * moves + 160);
      if (at === 0) throw new Error("there is no memory left for the path");
      const start = (at + 7) & ~7;
      const [x, y, z] = [0, 1, 2].map((i) => start + 8 * count * i);
      const stepAt = start + 24 * count;
      const move = stepAt + 8 * moves;
      const kindAt = move + 4 * count;
      const begins = kindAt + 4 * moves;
      module._cncsub_run_write_path(run, x, y, z, move, begins);
      module.HEAP32.fill(0, room >> 2, (room >> 2) + 14);
      module.HEAP32[(room >> 2) + 12] = kindAt;
      module.HEAP32[(room >> 2) + 13] = stepAt;
      module._cncsub_run_write_moves(run, room);
      const f = (from) => module.HEAPF64.slice(from >> 3, (from >> 3) + count);
      const path = { x: f(x), y: f(y), z: f(z), begins: module.HEAPU8.slice(begins, begins + count),
        step: new Float64Array(count), kind: new Uint8Array(count) };
      for (let i = 0; i < count; ++i) {
        const row = module.HEAPU32[(move >> 2) + i];
        path.step[i] = i64(stepAt + 8 * row);
        path.kind[i] = i32(kindAt + 4 * row);
      }
      module._free(at);
      return path;
    },

    compare(first, second, options) {
      const compared = made(module._cncsub_compare(first, second, options));
      const rules = listed((i, to) => module._cncsub_comparison_rule(compared, i, to), (at) => ({
        name: text(i32(at)), meaning: text(i32(at + 4)), values: [text(i32(at + 8)), text(i32(at + 12))],
        examples: [text(i32(at + 16)), text(i32(at + 20))],
      }), 500);
      const found = { what: text(module._cncsub_comparison_what(compared)), rules,
        steps: [0, 1].map((side) => Number(module._cncsub_comparison_step(compared, side))) };
      const run = made(module._cncsub_comparison_run(compared, 1));
      found.second = this.summary(run);
      found.path = this.path(run, 0.05);
      module._cncsub_run_free(run);
      module._cncsub_comparison_free(compared);
      return found;
    },
  };
}
