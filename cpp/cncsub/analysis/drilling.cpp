// Finds canned cycles that drill nothing, and counts that the control does not take.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// Return whether a code begins a cycle that goes down to Z.
bool drills(const GCode& code) {
  return code.group == Group::Cycle && code.meaning != Meaning::CycleOff &&
         code.meaning != Meaning::None && code.meaning != Meaning::Unknown &&
         code.meaning != Meaning::Uncomputed && !is_neutral(code.meaning);
}

/// The effect of a block on the words of a cycle.
struct CycleUse {
  bool begins = false, forgets = false, turns = false;
  Meaning meaning = Meaning::None;
  int code = -1;
};

CycleUse use_of(const Checker& c, const Block& block) {
  CycleUse use;
  if (block.op == Op::Arc || (block.op == Op::Linear && (block.flags & Block::kNoG) == 0))
    use.forgets = true;
  each_g(c.code, block, [&](int g) {
    const GCode code = c.g_codes.find(g);
    if (drills(code)) {
      use.begins = true;
      use.meaning = code.meaning;
      use.code = g;
    }
    use.turns = use.turns || code.meaning == Meaning::PlaneZX || code.meaning == Meaning::PlaneYZ;
    use.forgets = use.forgets || code.group == Group::Motion || code.meaning == Meaning::CycleOff ||
                  code.meaning == Meaning::Reference;
  });
  if (use.begins) use.forgets = false;
  return use;
}

/// Return whether the repeat count of a block is written as 0: it drills nothing on purpose.
bool repeats_never(const Checker& c, const Block& block, const Program& program) {
  const Letters& letters = c.code.control->motion.cycle_repeats.value;
  const std::vector<WrittenWord> words = c.code.words_of(block, program);
  return std::any_of(words.begin(), words.end(), [&](const WrittenWord& word) {
    return word.address.size() == 1 && letters.has(word.address[0]) && word.known &&
           word.value == 0;
  });
}

class DrillCheck {
 public:
  DrillCheck(Checker& c, const ProgramFlow& flow)
      : c_(c), flow_(flow), program_(c.program(flow.program())) {}
  void depths();
  void counts(Address at, const Block& block);
  void follow(const Block& block);

 private:
  static constexpr std::uint8_t kNone = 1, kGiven = 2;  // whether a cycle has its Z

  std::vector<std::uint8_t> states() const;
  std::uint8_t behind(Address at, std::uint8_t state) const;
  bool drills_without_depth(Address at) const;

  Checker& c_;
  const ProgramFlow& flow_;
  const Program& program_;
  CycleUse series_;  // the cycle in force, as far as the blocks above tell
};

std::uint8_t DrillCheck::behind(Address at, std::uint8_t state) const {
  const Block& block = c_.code.blocks[at];
  if (!is_words(block.op)) return block.op >= Op::Set ? state : kGiven;  // a call may drill
  const CycleUse use = use_of(c_, block);
  if (use.forgets) state = kNone;
  return (block.mask & bit('Z')) != 0 && !use.forgets ? kGiven : state;
}

/// Return by block whether a cycle has its Z before it: on no path, on some, on all.
std::vector<std::uint8_t> DrillCheck::states() const {
  std::vector<std::uint8_t> before(flow_.size(), 0);
  std::vector<Address> waiting;
  const auto reach = [&](Address at, std::uint8_t state) {
    std::uint8_t& own = before[at - flow_.first()];
    if ((own | state) == own) return;
    own = static_cast<std::uint8_t>(own | state);
    waiting.push_back(at);
  };
  reach(flow_.first(), c_.is_called(flow_.program()) ? kGiven : kNone);
  for (const Address entry : flow_.entries()) reach(entry, kGiven);
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    const std::uint8_t own = before[at - flow_.first()];
    const std::uint8_t state = at < flow_.last() ? behind(at, own) : own;
    for (const Exit* exit = flow_.begin(at); exit != flow_.end(at); ++exit) reach(exit->to, state);
  }
  return before;
}

/// Return whether a hole follows a cycle that has no Z, in its own block or in a later one, before
/// a block gives it one.
bool DrillCheck::drills_without_depth(Address at) const {
  constexpr std::uint32_t kPlace = bit('X') | bit('Y');
  constexpr Address kFar = 64;
  for (Address next = at; next < flow_.last() && next - at < kFar; ++next) {
    const Block& block = c_.code.blocks[next];
    if (!is_words(block.op) || (block.mask & bit('Z')) != 0) return false;
    if (next != at && (use_of(c_, block).forgets || use_of(c_, block).begins)) return false;
    if ((block.mask & kPlace) != 0) return true;
  }
  return false;
}

void DrillCheck::depths() {
  bool asks = false;
  for (Address at = flow_.first(); at < flow_.last(); ++at) {
    const CycleUse use = use_of(c_, c_.code.blocks[at]);
    if (use.turns) return;  // Z is not the depth everywhere
    asks = asks || use.begins;
  }
  if (!asks) return;
  const std::vector<std::uint8_t> before = states();
  for (Address at = flow_.first(); at < flow_.last() && !c_.over(); ++at) {
    const Block& block = c_.code.blocks[at];
    const CycleUse use = use_of(c_, block);
    if (block.op != Op::Words || !use.begins || before[at - flow_.first()] != kNone ||
        !drills_without_depth(at) || repeats_never(c_, block, program_))
      continue;
    c_.found(Check::NothingDrilled, at, {block.text, block.length},
             code_name(use.code) + " has no Z: G80 and G00 to G03 clear the Z of an earlier cycle");
  }
}

/// Remember the cycle that a block begins, or that goes on in it. No cycle is known after a block
/// where another program may have ended it, or where a jump leads on.
void DrillCheck::follow(const Block& block) {
  if (block.op >= Op::Set && block.op != Op::Set && block.op != Op::Assign &&
      block.op != Op::IfGoto && block.op != Op::IfThen)
    series_ = {};
  if (!is_words(block.op)) return;
  const CycleUse use = use_of(c_, block);
  if (use.forgets) series_ = {};
  if (use.begins) series_ = use;
}

/// Report L where the control counts by K, and K where it counts by L: in the block that begins a
/// cycle, and in later blocks that drill.
void DrillCheck::counts(Address at, const Block& block) {
  constexpr std::uint32_t kPlace = bit('X') | bit('Y') | bit('Z');
  follow(block);
  const Letters& letters = c_.code.control->motion.cycle_repeats.value;
  if (!is_words(block.op) || !series_.begins || letters.has('L') == letters.has('K')) return;
  if (!use_of(c_, block).begins && (block.mask & kPlace) == 0) return;
  const bool shifts = series_.meaning == Meaning::FineBore ||
                      series_.meaning == Meaning::BackBore || series_.meaning == Meaning::Peck ||
                      series_.meaning == Meaning::PeckFast;
  const char other = letters.has('K') ? 'L' : 'K', own = letters.has('K') ? 'K' : 'L';
  if ((block.mask & bit(other)) == 0 || (other == 'K' && shifts)) return;
  for (const WrittenWord& word : c_.code.words_of(block, program_))
    if (word.address == std::string_view(&other, 1) && word.known && word.value > 1 &&
        std::round(word.value) == word.value)
      c_.found(Check::OtherCount, at,
               {static_cast<std::uint32_t>(block.text + word.at),
                static_cast<std::uint32_t>(word.width)},
               std::string("the control repeats a cycle by ") + own + ", not by " + other +
                   ": this cycle drills once");
}

}  // namespace

void check_drilling(Checker& c) {
  if (c.machine != MachineType::Mill || c.code.control->lacks(RuleGroup::MotionRules) != nullptr)
    return;
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow) || c.over(flow.size())) continue;
    DrillCheck drilling(c, flow);
    drilling.depths();
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
      each_variant(c.code, c.code.blocks[at],
                   [&](const Block& block) { drilling.counts(at, block); });
  }
}

}  // namespace cncsub
