// What a TypeScript programmer writes over the package: it has to compile, and each line below @ts-expect-error must not.
import { MOVE_KINDS, start, type Alarm, type Engine, type Files, type Options } from "cncsub";

const files: Files = { "job.nc": "O1\nM30\n", "sub.nc": new Uint8Array([79, 50]) };
const options: Options = { maxBlocks: 1000, blockSkip: [1, 2], workOffsets: { G54: { X: 1 } }, startPosition: { Z: 5 }, variables: { 100: null } };

export async function first(wasm: ArrayBuffer): Promise<string> {
  const engine: Engine = await start({ wasm });
  const library = engine.load(files, "fanuc-0i-f", { max_nesting: 3, "6050": 70 });
  const run = library.run(options);
  const alarm: Alarm | null = run.alarm;
  const x: Float64Array = run.moves().x;
  const kind: "rapid" | "feed" | "cw" | "ccw" | "thread" | "dwell" = MOVE_KINDS[0];
  const machine = library.machine();
  while (machine.step()) if (machine.next.n === 10) machine.setVariable(100, null);
  const value: number | null = machine.variable(100);
  const compared = engine.compare(library, library.for("mitsubishi-m700"));
  const [one, other]: [number, number] = compared.steps;
  // @ts-expect-error a control has a name
  engine.load(files);
  // @ts-expect-error there is no such option
  library.run({ max_blocks: 3 });
  // @ts-expect-error an alarm may be missing
  run.alarm.number;
  // @ts-expect-error an engine is made by start
  new (engine.constructor as typeof Engine)();
  for (const held of [machine, run, compared, library]) held.free();
  return `${alarm?.number} ${x.length} ${kind} ${value} ${one + other}`;
}
