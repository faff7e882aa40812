// Modes that a called program switches on and leaves on for its caller.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

// What may be in force, as four bits for each mode: what was found, the usual value, and two
// others.
using Modes = std::uint64_t;
constexpr int kBits = 4;
constexpr Modes kFound = 1, kUsual = 2, kOther = 4, kSecond = 8, kOne = 15;
enum Mode : std::uint8_t {
  Distance,
  Plane,
  Units,
  Radius,
  Cycle,
  Length,
  Work,
  Shift,   // of the work coordinates, by G52
  Origin,  // of the work coordinates, by G92
  Rotation,
  Scaling,
  Mirror,
  Polar,
  Feed,
  Surface,
  Macro  // a macro that each move calls
};
constexpr int kModes = Macro + 1;
// Modes of which nobody knows what is usual: parameters say it.
constexpr bool has_no_usual(int mode) { return mode == Units || mode == Feed || mode == Surface; }
// Modes that are never off: a caller that chose another one than the usual loses it by the usual.
constexpr bool is_choice(int mode) {
  return has_no_usual(mode) || mode == Distance || mode == Plane;
}
/// The values of a mode that count where they are left on.
constexpr Modes counted(int mode) { return kOther | kSecond | (is_choice(mode) ? kUsual : 0); }

constexpr Modes of(int mode, Modes value) { return value << (kBits * mode); }
constexpr Modes all(Modes value) {
  Modes modes = 0;
  for (int mode = 0; mode < kModes; ++mode) modes |= value << (kBits * mode);
  return modes;
}
// What M70 and M73 keep. [LC m-code]
constexpr Modes kKept = of(Distance, kFound) | of(Plane, kFound) | of(Units, kFound) |
                        of(Radius, kFound) | of(Length, kFound) | of(Work, kFound) |
                        of(Feed, kFound) | of(Surface, kFound);
constexpr Modes value(Modes modes, int mode) { return modes >> (kBits * mode) & kOne; }

constexpr std::uint32_t kAxes =
    kEndWords | bit('A') | bit('B') | bit('C') | bit('U') | bit('V') | bit('W');

struct Meant {
  Mode mode;
  Modes value;
  Meaning meaning;
};

/// The values of the modes, the usual ones of a machine.
std::vector<Meant> meant(bool lathe) {
  return {{Distance, kUsual, Meaning::Absolute},
          {Distance, kOther, Meaning::Incremental},
          {Plane, lathe ? kOther : kUsual, Meaning::PlaneXY},
          {Plane, lathe ? kUsual : kOther, Meaning::PlaneZX},
          {Plane, kSecond, Meaning::PlaneYZ},
          {Units, kUsual, Meaning::Metric},
          {Units, kOther, Meaning::Inch},
          {Radius, kUsual, Meaning::RadiusOff},
          {Radius, kOther, Meaning::RadiusLeft},
          {Radius, kSecond, Meaning::RadiusRight},
          {Cycle, kUsual, Meaning::CycleOff},
          {Length, kUsual, Meaning::LengthOff},
          {Length, kOther, Meaning::LengthPlus},
          {Length, kSecond, Meaning::LengthMinus},
          {Work, kUsual, Meaning::Work1},
          {Work, kOther, Meaning::Work2},
          {Work, kOther, Meaning::Work3},
          {Work, kOther, Meaning::Work4},
          {Work, kOther, Meaning::Work5},
          {Work, kOther, Meaning::Work6},
          {Work, kSecond, Meaning::WorkExtra},
          {Shift, kOther, Meaning::Local},
          {Origin, kOther, Meaning::SetCoordinate},
          {Origin, kUsual, Meaning::ClearCoordinate},
          {Rotation, kUsual, Meaning::RotationOff},
          {Rotation, kOther, Meaning::RotationOn},
          {Scaling, kUsual, Meaning::ScalingOff},
          {Scaling, kOther, Meaning::ScalingOn},
          {Mirror, kUsual, Meaning::MirrorOff},
          {Mirror, kOther, Meaning::MirrorOn},
          {Polar, kUsual, Meaning::PolarOff},
          {Polar, kOther, Meaning::PolarOn},
          {Feed, kUsual, Meaning::PerMinute},
          {Feed, kOther, Meaning::PerRevolution},
          {Feed, kSecond, Meaning::InverseTime},
          {Surface, kUsual, Meaning::SpindleSpeed},
          {Surface, kOther, Meaning::SurfaceSpeed}};
}

/// Whether all words of a block that name axes are the number 0: G52 X0 Y0 shifts nothing.
bool all_zero(const Code& code, const Block& block) {
  const Cell* cell = code.cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) expressions = (cell++)->extra.expressions;
  cell += block.code_cells();
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const std::uint32_t address = left & ~(left - 1);
    if ((address & kAxes) != 0 && ((expressions & address) != 0 || cell->value != 0)) return false;
  }
  return true;
}

/// Sets a mode; where it is set sometimes only, what was in force may be so still.
void put(Modes& modes, Modes own, bool sometimes) {
  for (int mode = 0; mode < kModes; ++mode)
    if (value(own, mode) != 0) modes = (sometimes ? modes : modes & ~of(mode, kOne)) | own;
}

/// What is in force when a main program begins.
Modes at_first() {
  Modes usual = 0;
  for (int mode = 0; mode < kModes; ++mode) usual |= of(mode, has_no_usual(mode) ? kFound : kUsual);
  return usual;
}

/// What is in force behind a call of a program that leaves this.
Modes through(Modes modes, Modes left) {
  Modes kept = 0;
  for (int mode = 0; mode < kModes; ++mode)
    if ((value(left, mode) & kFound) != 0) kept |= modes & of(mode, kOne);
  return kept | (left & ~all(kFound));
}

class ModeCheck {
 public:
  explicit ModeCheck(Checker& c)
      : c_(c), meant_(meant(c.machine != MachineType::Mill)), left_(c.flows.size(), all(kFound)) {}

  void run();

 private:
  Modes set_by(Meaning meaning, Group group) const;
  Modes set_by(int g, const Block& block) const;
  Modes after(Modes before, Address at) const;
  void take_back(Modes& modes, const Block& block, bool sometimes) const;
  bool keeps(const ProgramFlow& flow) const;
  std::vector<Modes> states(const ProgramFlow& flow, std::int32_t but = kNoProgram) const;
  Modes leaves(const ProgramFlow& flow, const std::vector<Modes>& states) const;
  void settle();
  void leaks(const ProgramFlow& flow);
  void leak(const ProgramFlow& flow, const CallEdge& edge, Modes own,
            std::set<std::tuple<std::int32_t, int>>& told);
  Address moves_with(const ProgramFlow& flow, Address call, int mode) const;
  std::string name(int mode, Modes which) const;

  Checker& c_;
  std::vector<Meant> meant_;
  std::vector<Modes> left_;  // by program: what it leaves
};

/// The modes that a code sets, 0 where it sets none.
Modes ModeCheck::set_by(Meaning meaning, Group group) const {
  for (const Meant& each : meant_)
    if (each.meaning == meaning) return of(each.mode, each.value);
  if (group == Group::Cycle) return of(Cycle, kOther);
  return group == Group::Motion ? of(Cycle, kUsual) : 0;
}

/// The same of a code of a block, ten times its number.
Modes ModeCheck::set_by(int g, const Block& block) const {
  const GCode code = c_.g_codes.find(g);
  if (code.meaning == Meaning::Local && all_zero(c_.code, block)) return of(Shift, kUsual);
  return set_by(code.meaning, code.group);
}

/// A computed code puts back what was found, as it is written to do: `G#3` behind `#3=#4003`; so
/// does M72.
void ModeCheck::take_back(Modes& modes, const Block& block, bool sometimes) const {
  if (block.g_count != 0 && (block.flags & Block::kCodeExpression) != 0)
    put(modes, all(kFound), sometimes);
  each_m(c_.code, block, [&](int m) {
    if (c_.code.control->calls.roles.value.of_m(m) == Role::RestoreModes)
      put(modes, kKept, sometimes);
  });
}

/// Whether a program keeps its modes by M73: its return takes them back in.
bool ModeCheck::keeps(const ProgramFlow& flow) const {
  const Roles& roles = c_.code.control->calls.roles.value;
  if (!roles.code_of(Role::KeepModes)) return false;
  bool keeps = false;
  for (Address at = flow.first(); at < flow.last() && !keeps; ++at) {
    const Block& block = c_.code.blocks[at];
    if (block.op == Op::Words)
      each_m(c_.code, block, [&](int m) { keeps |= roles.of_m(m) == Role::KeepModes; });
  }
  return keeps;
}

/// What is in force behind a block and what it calls.
Modes ModeCheck::after(Modes before, Address at) const {
  const Block& block = c_.code.blocks[at];
  Modes modes = before;
  const bool sometimes = block.skip != 0 || block.op == Op::IfThen || block.op == Op::Choose;
  each_variant(c_.code, block, [&](const Block& each) {
    const bool plain = each.op == Op::Linear || each.op == Op::Arc;
    if (plain && (each.flags & Block::kNoG) == 0)
      put(modes, set_by(Meaning::Line, Group::Motion), sometimes);
    if (plain) return;
    each_g(c_.code, each, [&](int g) { put(modes, set_by(g, each), sometimes); });
    take_back(modes, each, sometimes);
    if (each.op == Op::ModalCall) put(modes, of(Macro, kOther), sometimes);
    if (each.op == Op::CancelModal) put(modes, of(Macro, kUsual), sometimes);
  });
  return modes;
}

/// What may be in force before each block, were one of the called programs to leave nothing.
std::vector<Modes> ModeCheck::states(const ProgramFlow& flow, std::int32_t but) const {
  std::vector<Modes> before(flow.size(), 0);
  std::vector<Address> waiting;
  const auto reach = [&](Address at, Modes modes) {
    Modes& own = before[at - flow.first()];
    if ((own | modes) == own) return;
    own |= modes;
    waiting.push_back(at);
  };
  const bool called = c_.is_called(flow.program());
  reach(flow.first(), called ? all(kFound) : at_first());
  for (const Address entry : flow.entries()) reach(entry, all(kFound));
  std::vector<const CallEdge*> calls(flow.size(), nullptr);
  for (const CallEdge& edge : flow.calls()) calls[edge.from - flow.first()] = &edge;
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Modes modes = before[at - flow.first()];
    if (at < flow.last()) modes = after(modes, at);
    const CallEdge* edge = calls[at - flow.first()];
    if (edge != nullptr && edge->called != but)
      modes = through(modes, left_[static_cast<std::size_t>(edge->called)]);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) reach(exit->to, modes);
  }
  return before;
}

/// What a called program leaves where it returns.
Modes ModeCheck::leaves(const ProgramFlow& flow, const std::vector<Modes>& states) const {
  Modes left = all(kFound);
  bool returned = false;
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const Modes before = states[at - flow.first()];
    if (!flow.returns(at) || before == 0) continue;
    left = (returned ? left : 0) | after(before, at);
    returned = true;
  }
  if (keeps(flow)) put(left, kKept, false);
  return left;
}

/// Until no program leaves more than was known.
void ModeCheck::settle() {
  std::vector<std::int32_t> waiting;
  for (const ProgramFlow& flow : c_.flows)
    if (c_.is_called(flow.program())) waiting.push_back(flow.program());
  std::vector<bool> first(c_.flows.size(), true);
  while (!waiting.empty()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    const auto place = static_cast<std::size_t>(program);
    const ProgramFlow& flow = c_.flow(program);
    const Modes found = leaves(flow, states(flow));
    const Modes left = first[place] ? found : left_[place] | found;
    first[place] = false;
    if (left == left_[place]) continue;
    left_[place] = left;
    for (const CallEdge& edge : c_.callers[place])
      if (c_.is_called(edge.caller)) waiting.push_back(edge.caller);
  }
}

/// The first block behind a call that moves in a mode, kNowhere where all ways set it before.
Address ModeCheck::moves_with(const ProgramFlow& flow, Address call, int mode) const {
  constexpr std::size_t kFar = 4096;
  std::vector<bool> seen(flow.size(), false);
  std::vector<Address> waiting;
  const auto go_on = [&](Address at) {
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      waiting.push_back(exit->to);
  };
  go_on(call);
  for (std::size_t count = 0; !waiting.empty() && count < kFar; ++count) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (at >= flow.last() || seen[at - flow.first()]) continue;
    seen[at - flow.first()] = true;
    const Block& block = c_.code.blocks[at];
    if (value(after(0, at), mode) != 0) continue;
    if (is_words(block.op) && (block.mask & kAxes) != 0) return at;
    if (block.op == Op::Words || block.op > Op::Return) go_on(at);
  }
  return kNowhere;
}

std::string ModeCheck::name(int mode, Modes which) const {
  if (mode == Cycle) return "a canned cycle";
  if (mode == Macro) return "a modal macro call";
  if (mode == Work) return "another work coordinate system";
  for (const Meant& each : meant_)
    if (each.mode == mode && (each.value & which) != 0)
      if (const GCode code = c_.g_codes.of(each.meaning); code.code >= 0)
        return code_name(code.code);
  return "a mode";
}

/// The rule of a mode: what a program may leave on for good reasons is only noted.
Check rule_of(int mode) {
  if (mode == Length) return Check::LeavesLength;
  return mode == Work || mode == Origin ? Check::LeavesWork : Check::LeavesOn;
}

/// The modes that a called program may leave on, were they not those of its caller.
bool may_leak(Modes left) {
  for (int mode = 0; mode < kModes; ++mode)
    if ((value(left, mode) & counted(mode)) != 0) return true;
  return false;
}

/// Whether some block of a program leads back.
bool leads_back(const ProgramFlow& flow) {
  for (Address at = flow.first(); at < flow.last(); ++at)
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      if (exit->to <= at) return true;
  return false;
}

void ModeCheck::leaks(const ProgramFlow& flow) {
  constexpr std::size_t kMostCalled = 64;  // for each of them the program is gone through
  const bool loops = leads_back(flow);
  const std::vector<Modes> before = states(flow);
  std::map<std::int32_t, std::vector<Modes>> without;  // a called program, in a loop
  std::set<std::tuple<std::int32_t, int>> told;
  for (const CallEdge& edge : flow.calls()) {
    const Modes left = left_[static_cast<std::size_t>(edge.called)];
    if (before[edge.from - flow.first()] == 0 || !may_leak(left)) continue;
    const std::vector<Modes>* found = &before;
    if (loops && (without.contains(edge.called) || without.size() < kMostCalled)) {
      std::vector<Modes>& own = without[edge.called];
      if (own.empty()) own = states(flow, edge.called);
      found = &own;
    }
    leak(flow, edge, after((*found)[edge.from - flow.first()], edge.from), told);
  }
}

/// What one call leaves on that its caller had not.
void ModeCheck::leak(const ProgramFlow& flow, const CallEdge& edge, Modes own,
                     std::set<std::tuple<std::int32_t, int>>& told) {
  const Modes left = left_[static_cast<std::size_t>(edge.called)];
  for (int mode = 0; mode < kModes; ++mode) {
    const Modes leak = value(left, mode) & counted(mode) & ~value(own, mode);
    if (leak == 0 || (value(own, mode) & kFound) != 0 || told.contains({edge.called, mode}))
      continue;
    const Address moves = moves_with(flow, edge.from, mode);
    if (moves == kNowhere) continue;
    told.insert({edge.called, mode});
    const CallRecord& record = c_.code.calls[edge.record];
    c_.found(rule_of(mode), edge.from, {record.at, record.width},
             c_.code.name_of(edge.called) + " leaves " + name(mode, leak) + " on, and line " +
                 std::to_string(c_.code.blocks[moves].line) + " moves with it");
  }
}

void ModeCheck::run() {
  settle();
  for (const ProgramFlow& flow : c_.flows)
    if (!flow.calls().empty()) leaks(flow);
}

}  // namespace

void check_modes(Checker& c) {
  const bool calls = std::any_of(c.flows.begin(), c.flows.end(),
                                 [](const ProgramFlow& flow) { return !flow.calls().empty(); });
  if (calls) ModeCheck(c).run();
}

}  // namespace cncsub
