// A program on two controls: node example.js
import { MOVE_KINDS, start } from "./cncsub.js";

const cncsub = await start();
const program = "O1\nN10 M98 P2 L0\nN20 G0 X5.\nN30 M30\nO2\nN40 G1 X1. F100.\nN50 M99\n";
const library = cncsub.load({ "job.nc": program }, "fanuc-0i-f");

const machine = library.machine();
while (machine.step()) console.log(`next: ${machine.next.program} N${machine.next.n}, X ${machine.position("X")}, ${machine.stack().length} calls`);
console.log(`${machine.stop}`);

const run = library.run({ workOffsets: { G54: { X: 100 } } });
const moves = run.moves();
for (let i = 0; i < moves.count; ++i) console.log(`${MOVE_KINDS[moves.kind[i]]} to X ${moves.x[i]}, machine ${moves.mx[i]}`);

const broken = cncsub.load("O1\nN10 G1 X1.\nN20 M30\n", "fanuc-0i-f");
console.log(broken.run().alarm?.shown);
for (const finding of broken.check()) console.log(`${finding.rule} line ${finding.at.line}: ${finding.message}`);

const compared = cncsub.compare(library, library.for("mitsubishi-m700"));
console.log(compared.what);
for (const rule of compared.rules) console.log(`because of ${rule.name}: ${rule.values.join(" and ")}`);
for (const one of [machine, run, broken, compared, library]) one.free();
