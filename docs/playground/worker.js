// The worker of the page: reads, runs in slices so that a message can stop it, and answers.
"use strict";

const SLICE = 200000; // blocks
let engine = null;
let stopped = 0; // the number of the newest job that is to stop
let held = null; // {library, run}: what steps are asked of

const answer = (job, kind, told) => postMessage({ job, kind, ...told });
const turn = () => new Promise((done) => {
  const channel = new MessageChannel();
  channel.port1.onmessage = done;
  channel.port2.postMessage(0);
});

function forget() {
  if (held === null) return;
  held.run.free();
  held.library.free();
  held = null;
}

/** Return the path as the page draws it: points, and the steps and kinds of their moves. */
function pathOf(run) {
  const { x, y, z, move, begins, count } = run.path(0.05);
  const moves = run.moves();
  const step = new Float64Array(count);
  const kind = new Uint8Array(count);
  for (let i = 0; i < count; ++i) [step[i], kind[i]] = [moves.step[move[i]], moves.kind[move[i]]];
  return { x, y, z, begins, step, kind };
}

const summaryOf = (run) => ({
  stop: run.stop, waiting: run.waitingFor, alarm: run.alarm, blocks: run.blocks, moves: run.moveCount, steps: run.stepCount,
  length: run.length, time: run.time,
});

async function run(job, asked) {
  forget();
  const library = engine.load(asked.files, asked.control, asked.changes);
  try {
    const machine = library.machine(asked.options);
    let blocks = 0;
    while (machine.run(SLICE)) {
      blocks += SLICE;
      answer(job, "progress", { blocks });
      await turn();
      if (stopped >= job) {
        machine.interrupt();
        break;
      }
    }
    held = { library, run: machine.soFar() };
    machine.free();
  } finally {
    if (held === null) library.free();
  }
  const of = held.run;
  answer(job, "ran", {
    summary: summaryOf(of), variables: of.variables(5000), messages: of.messages.slice(0, 1000), path: pathOf(of),
    calls: of.calls(2000), programs: library.programs.slice(0, 2000),
  });
  answer(job, "checked", { findings: library.check(2000) });
  if (!asked.second) return;
  await turn();
  if (stopped >= job) return;
  const second = library.for(asked.second);
  const compared = engine.compare(library, second, asked.options);
  const { what, rules, steps } = compared;
  answer(job, "compared", { comparison: { what, rules, steps, path: pathOf(compared.run(1)) } });
  compared.free();
  second.free();
}

/** Tell the state after `count` blocks: what comes next is in the steps, the rest a machine finds by running there. */
function tellState(job, asked) {
  if (held === null) return;
  const machine = held.library.machine({ ...asked.options, record: "nothing" });
  if (asked.count > 0) machine.run(asked.count);
  const so = machine.soFar();
  answer(job, "state", { count: asked.count, variables: so.variables(5000), calls: machine.stack(1000) });
  so.free();
  machine.free();
}

onmessage = async ({ data }) => {
  const { job, kind } = data;
  try {
    if (kind === "start") {
      engine = new Engine(await cncsubModule({ wasmBinary: data.wasm }));
      answer(job, "ready", { controls: engine.controls, version: engine.version });
    } else if (kind === "stop") {
      stopped = Math.max(stopped, data.of);
    } else if (kind === "run") {
      await run(job, data);
    } else if (kind === "steps" && held !== null) {
      answer(job, "steps", { first: data.first, rows: held.run.steps(data.first, data.last) });
    } else if (kind === "state") {
      tellState(job, data);
    }
  } catch (error) {
    answer(job, "refused", { message: String((error && error.message) || error) });
  }
};
