// The types of the package. Lengths are in mm, times in s; a number that is absent is null.

/** Read the engine, which lies beside this file; `wasm` names another place, or holds its bytes. */
export function start(options?: { wasm?: string | URL | ArrayBuffer | ArrayBufferView }): Promise<Engine>;

/** The kinds of moves: `MOVE_KINDS[moves.kind[i]]`. */
export const MOVE_KINDS: readonly ["rapid", "feed", "cw", "ccw", "thread", "dwell"];

export type Text = string | Uint8Array;
/** One program, files by their names, or a list of them, whose order counts. */
export type Files = Text | Record<string, Text> | readonly { name: string; text: Text }[];
/** Changed rules and parameters: `{max_nesting: 3, "6050": 70}`, or lines `name=value`. */
export type Changes = string | Record<string, string | number | boolean>;
export type StopReason = "end" | "alarm" | "cycles" | "limit" | "waiting" | "interrupted";
export type Axis = "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W";

export interface Options {
  /** The program that runs; else the first one. */
  main?: string;
  /** The sequence number to begin at. */
  start?: number;
  /** The switches that are on, 1 to 10; true is switch 1. */
  blockSkip?: boolean | readonly number[];
  optionalStop?: boolean;
  /** How often a main program that starts over runs. */
  maxCycles?: number;
  maxBlocks?: number;
  maxSeconds?: number;
  record?: "nothing" | "calls" | "blocks" | "moves";
  machine?: "mill" | "lathe-a" | "lathe-b";
  /** Values by number; null is vacant. */
  variables?: Record<number, number | null>;
  /** Of the machine, such as #1000. */
  signals?: Record<number, number>;
  /** `{G54: {X: 100}}` */
  workOffsets?: Record<string, Partial<Record<Axis, number>>>;
  /** By H numbers. */
  lengthOffsets?: Record<number, number>;
  /** By D numbers. */
  radiusOffsets?: Record<number, number>;
  /** Where the tool stands at the start, work coordinates. */
  startPosition?: Partial<Record<Axis, number>>;
}

export interface ControlName {
  name: string;
  title: string;
}

/** A block: its program and sequence number, its file and line. */
export interface Place {
  program: string;
  file: string;
  n: number | null;
  /** From 1 on. */
  line: number;
}

/** An open call, and where it was made. */
export interface Call {
  at: Place;
  /** `"M98"`, `"G65"` */
  kind: string;
  called: string;
  repeat: number;
  repeats: number;
}

export interface Alarm {
  /** As on the screen; `""` where no source gives one. */
  number: string;
  /** The same on every control: `"program-not-found"`. */
  cause: string;
  text: string;
  /** What happened, where, the line with the word marked, the callers. */
  shown: string;
  cure: string;
  at: Place;
  /** From 1 on, in characters. */
  column: number;
  /** The word that the alarm names; `""` where it is of the whole block. */
  word: string;
  /** Innermost first. */
  stack: Call[];
}

export interface Finding {
  rule: string;
  severity: "error" | "warning" | "note";
  message: string;
  at: Place;
  column: number;
  hint: string;
}

/** A block that was executed. */
export interface Step {
  step: number;
  at: Place;
  text: string;
  /** Open calls. */
  depth: number;
  /** Its condition did not hold. */
  skipped: boolean;
}

export interface CallMade {
  kind: string;
  called: string;
  repeats: number;
  /** The call in which it was made; null: the main program. */
  parent: number | null;
  startN: number | null;
  callerStep: number;
  firstStep: number | null;
  /** null: it did not end. */
  lastStep: number | null;
}

export interface Variable {
  /** null: it has a name. */
  number: number | null;
  name: string;
  /** null: it is a text. */
  value: number | null;
  text: string;
}

/** A column for each thing that is known of a move. */
export interface Moves {
  count: number;
  /** Ends, work coordinates. */
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
  /** Ends of the tool, machine coordinates. */
  mx: Float64Array;
  my: Float64Array;
  mz: Float64Array;
  /** Centres of arcs, NaN elsewhere. */
  cx: Float64Array;
  cy: Float64Array;
  cz: Float64Array;
  feed: Float64Array;
  length: Float64Array;
  time: Float64Array;
  /** Places in `MOVE_KINDS`. */
  kind: Uint8Array;
  /** The steps that made the moves. */
  step: Float64Array;
}

/** The path of the tool as points, work coordinates. */
export interface Path {
  count: number;
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
  /** The move of each point. */
  move: Uint32Array;
  /** 1 where no line leads to the point. */
  begins: Uint8Array;
}

/** A rule or a parameter as two controls have it. */
export interface RuleApart {
  name: string;
  meaning: string;
  values: [string, string];
  examples: [string, string];
}

/** What `start` gives. Its objects stay until `free`, or until they are forgotten. */
export class Engine {
  private constructor();
  readonly version: string;
  readonly controls: ControlName[];
  /** Read programs as the memory of a control. Throws where there is no such control, rule or parameter. */
  load(files: Files, control: string, changes?: Changes): Library;
  /** Find where the same programs, read for two controls, part, and which rules make it. */
  compare(first: Library, second: Library, options?: Options): Comparison;
}

declare abstract class Held {
  /** Give the memory back now. What is used after it throws. */
  free(): void;
}

export class Library extends Held {
  private constructor();
  readonly programs: string[];
  /** Read the same texts for another control, or for one with changed rules and parameters. */
  for(control: string, changes?: Changes): Library;
  run(options?: Options): Run;
  machine(options?: Options): Machine;
  /** Look for what is wrong without running. */
  check(most?: number): Finding[];
}

export class Run extends Held {
  private constructor();
  readonly stop: StopReason;
  /** `"#1000"`, `"cycle start after M00"`; `""` where the run does not wait. */
  readonly waitingFor: string;
  readonly alarm: Alarm | null;
  readonly blocks: number;
  readonly stepCount: number;
  readonly callCount: number;
  readonly moveCount: number;
  readonly length: number;
  readonly time: number;
  readonly messages: string[];
  step(index: number): Step | null;
  /** The blocks from `first` on, before `last`. */
  steps(first?: number, last?: number): Step[];
  calls(most?: number): CallMade[];
  /** Those that have values. */
  variables(most?: number): Variable[];
  /** null: vacant. Throws a RangeError where the control has no such variable. */
  variable(number: number): number | null;
  moves(): Moves;
  /** Points that leave out what lies within `tolerance` mm. */
  path(tolerance?: number): Path;
}

export class Machine extends Held {
  private constructor();
  readonly stop: StopReason | "running";
  readonly alarm: Alarm | null;
  /** The block that is executed next. */
  readonly next: Place;
  /** Execute a block; false where the run has stopped. */
  step(): boolean;
  /** Run on for about so many blocks; return whether the run goes on after them. */
  run(blocks?: number): boolean;
  /** Run on until the block is the next one; false where the run stopped before. Throws where there is no such block. */
  runTo(program: string, n: number): boolean;
  /** Stop here: `stop` is `"interrupted"` until it goes on. */
  interrupt(): void;
  /** The open calls, innermost first. */
  stack(most?: number): Call[];
  /** Work coordinates; null where there is no such axis. */
  position(axis: Axis): number | null;
  variable(number: number): number | null;
  setVariable(number: number, value: number | null): void;
  /** What has happened so far. */
  soFar(): Run;
}

export class Comparison extends Held {
  private constructor();
  readonly same: boolean;
  /** A line for each control; `""` where they do the same. */
  readonly what: string;
  /** The step of each side at which they part. */
  readonly steps: [number, number];
  /** What makes it; none: it lies in the languages, or in tables that are no rules. */
  readonly rules: RuleApart[];
  run(side: 0 | 1): Run;
}
