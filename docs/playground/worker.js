// The worker of the page: reads, runs in slices so that a message can stop it, and answers.
"use strict";

const SLICE = 200000; // blocks
let engine = null;
let stopped = 0; // the number of the newest job that is to stop
let held = null; // {library, options, run}: what steps are asked of

const answer = (job, kind, told) => postMessage({ job, kind, ...told });
const turn = () => new Promise((done) => {
  const channel = new MessageChannel();
  channel.port1.onmessage = done;
  channel.port2.postMessage(0);
});

function forget() {
  if (held === null) return;
  engine.freeRun(held.run);
  engine.freeOptions(held.options);
  engine.freeLibrary(held.library);
  held = null;
}

async function run(job, asked) {
  forget();
  const library = engine.read(asked.files, asked.control, asked.changes);
  let options = 0;
  let machine = 0;
  try {
    options = engine.options(asked.options);
    machine = engine.machine(library, options);
    let blocks = 0;
    while (engine.runBlocks(machine, SLICE)) {
      blocks += SLICE;
      answer(job, "progress", { blocks });
      await turn();
      if (stopped >= job) {
        engine.interrupt(machine);
        break;
      }
    }
    held = { library, options, run: engine.soFar(machine) };
  } finally {
    if (machine !== 0) engine.freeMachine(machine);
    if (held === null) {
      if (options !== 0) engine.freeOptions(options);
      engine.freeLibrary(library);
    }
  }
  const of = held.run;
  answer(job, "ran", {
    summary: engine.summary(of), variables: engine.variables(of), messages: engine.messages(of), path: engine.path(of, 0.05),
    calls: engine.callsMade(of, 2000),
  });
  answer(job, "checked", { findings: engine.check(library) });
  if (!asked.second) return;
  await turn();
  if (stopped >= job) return;
  const second = engine.readFor(library, asked.second);
  try {
    answer(job, "compared", { comparison: engine.compare(library, second, options) });
  } finally {
    engine.freeLibrary(second);
  }
}

/** Return the state after `count` blocks: what comes next is in the steps, the rest a machine finds by running there. */
function stateAt(job, asked) {
  if (held === null) return;
  const options = engine.options({ ...asked.options, record: 0 });
  const machine = engine.machine(held.library, options);
  if (asked.count > 0) engine.runBlocks(machine, asked.count);
  const so = engine.soFar(machine);
  answer(job, "state", { count: asked.count, variables: engine.variables(so), calls: engine.calls(machine) });
  engine.freeRun(so);
  engine.freeMachine(machine);
  engine.freeOptions(options);
}

onmessage = async ({ data }) => {
  const { job, kind } = data;
  try {
    if (kind === "start") {
      const module = await cncsubModule({ wasmBinary: data.wasm });
      engine = engineOf(module);
      answer(job, "ready", { controls: engine.controls(), version: engine.version() });
    } else if (kind === "stop") {
      stopped = Math.max(stopped, data.of);
    } else if (kind === "run") {
      await run(job, data);
    } else if (kind === "steps" && held !== null) {
      answer(job, "steps", { first: data.first, rows: engine.steps(held.run, data.first, data.last) });
    } else if (kind === "state") {
      stateAt(job, data);
    }
  } catch (error) {
    answer(job, "refused", { message: String((error && error.message) || error) });
  }
};
