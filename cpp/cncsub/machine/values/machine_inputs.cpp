#include "cncsub/machine/values/machine_inputs.hpp"

#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/values/decode.hpp"
#include "cncsub/motion/state/state.hpp"

namespace cncsub {

namespace {

std::optional<Fault> profile_block(Run& run, Address a, Profile& found) {
  const Block& block = run.code->blocks[a];
  switch (block.op) {
    case Op::Words:
    case Op::Linear:
    case Op::Arc:
      break;
    case Op::Call:
    case Op::MacroCall:
    case Op::ModalCall:
    case Op::Return:
    case Op::Select:
      return Fault{
          .cause = Cause::ProfileCall,
          .at = a,
          .detail = "a call inside the blocks of the profile",
          .word = {.addresses = bit('M'), .groups = bit(Group::OneShot) | bit(Group::Macro)}};
    default:
      return Fault{Cause::ProfileMacro, a, 1, "a macro statement inside the blocks of the profile"};
  }
  NcWords words;
  if (!decode(run, block, a, words)) return Fault{Cause::ProfileMacro, a, 1, {}};  // it has alarmed
  if (words.codes == &run.codes) words.codes = &found.computed.emplace_back(run.codes);
  found.blocks.push_back(words);
  return std::nullopt;
}

std::optional<Fault> profile_blocks(Run& run, const ProfileNumbers& numbers, Profile& found) {
  const auto& [ns, nf] = numbers;
  const Program& program = run.program();
  if (run.in_mdi()) return Fault{Cause::ProfileInMdi, run.state.pc, 1, {}};
  const auto missing = [&](char word, std::int64_t n) {
    return Fault{.cause = Cause::PqNotFound,
                 .at = run.state.pc,
                 .detail = run.code->no_block(n, program),
                 .word = {.addresses = bit(word)}};
  };
  Address first = run.code->next_of(program, ns, run.state.pc);
  if (first == kNowhere) first = run.code->first_of(program, ns);
  if (first == kNowhere) return missing('P', ns);
  const Address last = run.code->first_from(program, nf, first);
  if (last == kNowhere) return missing('Q', nf);
  const auto passed = [&](Address a) {
    return (run.code->blocks[a].skip & run.options.skips & ~Block::kPartEnd) != 0;
  };
  Address next = run.state.pc + 1;
  while (next < first && passed(next)) ++next;
  found.right_behind = first == next;
  found.behind = last + 1;
  for (Address a = first; a <= last; ++a) {
    if (!passed(a))
      if (auto wrong = profile_block(run, a, found)) return wrong;
    run.watch.in_block = found.blocks.size() * (sizeof(NcWords) + sizeof(Piece));
    if (a % kLongText == 0 && breaks_off(run)) return missing('Q', nf);
  }
  if (found.blocks.size() > kLongText) look_soon(run);
  return std::nullopt;
}

}  // namespace

MachineInputs machine_inputs(Run& run) {
  MachineInputs inputs;
  inputs.skips = {&run.options.inputs.skips, &run.state.external_reads.skips, {}};
  inputs.workpiece = run.options.inputs.workpiece.get();
  run.watch.in_block = 0;
  inputs.interrupted = [](void* of) { return breaks_off(*static_cast<Run*>(of)); };
  inputs.run = &run;
  return inputs;
}

std::optional<Fault> read_profile(Run& run, const ProfileNumbers& numbers, Profile& found) {
  const BlockCodes own = run.codes;  // of the block that names the profile, which goes on
  auto wrong = profile_blocks(run, numbers, found);
  run.codes = own;
  return wrong;
}

}  // namespace cncsub
