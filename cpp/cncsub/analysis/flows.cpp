// The paths through all programs of a memory: calls and returns open exits in the calling programs.
#include <algorithm>
#include <vector>

#include "cncsub/analysis/flow.hpp"

namespace cncsub {

namespace {

/// Adds the exits that calls open in the programs that call.
class CallWays {
 public:
  CallWays(const Code& code, std::vector<ProgramFlow>& all) : code_(code), all_(all) {
    for (const ProgramFlow& flow : all) {
      numbers_.push_back(numbers_of(flow));
      names_.push_back(names_of(flow));
    }
    find_far_returns();
  }
  /// Add where the called program of a call returns to and where it begins.
  void add(const CallEdge& edge);

 private:
  static constexpr std::size_t kManyReturns = 64;      // more of them may lead anywhere
  static constexpr std::size_t kMostWays = 4'000'000;  // of a memory: more lead anywhere too

  static std::vector<std::int64_t> numbers_of(const ProgramFlow& flow) {
    std::vector<std::int64_t> numbers;
    for (const ProgramFlow::ReturnTo& to : flow.return_numbers())
      if (to.name.empty()) numbers.push_back(to.n);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  /// A block that a return names, and whether the one after it may be meant.
  using Named = std::pair<std::string_view, bool>;
  static std::vector<Named> names_of(const ProgramFlow& flow) {
    std::vector<Named> names;
    for (const ProgramFlow::ReturnTo& to : flow.return_numbers())
      if (!to.name.empty()) names.emplace_back(to.name, to.after);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }
  void find_far_returns();
  void add_names(const CallEdge& edge);

  const Code& code_;
  std::vector<ProgramFlow>& all_;
  std::vector<std::vector<std::int64_t>> numbers_;  // the numbers of M99 P by program, -1: computed
  std::vector<std::vector<Named>> names_;           // the blocks that returns name, by program
  std::vector<bool> far_;  // the programs in whose calls a return goes back over several levels
  std::size_t added_ = 0;
};

/// Find the programs from which a return to a named block goes over several levels, and all that
/// such a return may leave on its path.
void CallWays::find_far_returns() {
  far_.assign(all_.size(), false);
  std::vector<std::int32_t> waiting;
  std::vector<std::vector<std::int32_t>> callers(all_.size());
  const auto add = [&](std::int32_t program) {
    if (far_[static_cast<std::size_t>(program)]) return;
    far_[static_cast<std::size_t>(program)] = true;
    waiting.push_back(program);
  };
  for (const ProgramFlow& flow : all_) {
    for (const CallEdge& edge : flow.calls())
      callers[static_cast<std::size_t>(edge.called)].push_back(edge.caller);
    for (const ProgramFlow::ReturnTo& to : flow.return_numbers())
      if (to.over_levels) add(flow.program());
  }
  while (!waiting.empty()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    for (const std::int32_t caller : callers[static_cast<std::size_t>(program)]) add(caller);
  }
}

/// Add where returns with a name lead in the calling program.
void CallWays::add_names(const CallEdge& edge) {
  ProgramFlow& caller = all_[static_cast<std::size_t>(edge.caller)];
  const auto& names = names_[static_cast<std::size_t>(edge.called)];
  const bool many = names.size() > kManyReturns || added_ > kMostWays;
  if (far_[static_cast<std::size_t>(edge.called)] || many)
    return caller.add(edge.from, {caller.anywhere(), ExitKind::Returned});
  added_ += names.size();
  const Program& program = code_.programs[static_cast<std::size_t>(edge.caller)];
  for (const auto& [name, after] : names) {
    const Address found = code_.named_return_target(program, name, edge.from);
    if (found == kNowhere) continue;
    caller.add(edge.from, {found, ExitKind::Returned});
    if (after) caller.add(edge.from, {found + 1, ExitKind::Returned});
  }
}

void CallWays::add(const CallEdge& edge) {
  ProgramFlow& caller = all_[static_cast<std::size_t>(edge.caller)];
  ProgramFlow& called = all_[static_cast<std::size_t>(edge.called)];
  const auto& numbers = numbers_[static_cast<std::size_t>(edge.called)];
  auto& entries = called.entries();
  if (edge.start != kNowhere && edge.start != called.first() &&
      (entries.empty() || entries.back() != edge.start))
    entries.push_back(edge.start);
  add_names(edge);
  if (numbers.empty()) return;
  if (numbers.size() > kManyReturns || added_ > kMostWays)
    return caller.add(edge.from, {caller.anywhere(), ExitKind::Returned});
  const Program& program = code_.programs[static_cast<std::size_t>(edge.caller)];
  added_ += numbers.size();
  for (const std::int64_t n : numbers) {
    const Address found = n < 0 ? caller.anywhere() : code_.return_target(program, n, edge.from);
    if (found != kNowhere) caller.add(edge.from, {found, ExitKind::Returned});
  }
}

/// Add the exits of M99 in a main program: M99 starts it over, M99 P goes on at its block.
void add_main(const Code& code, ProgramFlow& flow) {
  if (code.control->calls.main_return.value != MainReturn::Restarts) return;
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (flow.returns(at)) flow.add(at, {flow.first(), ExitKind::Jump});
  const Program& program = code.programs[static_cast<std::size_t>(flow.program())];
  for (const ProgramFlow::ReturnTo& to : flow.return_numbers()) {
    if (!to.name.empty()) continue;
    const Address found = to.n < 0 ? flow.anywhere() : code.first_of(program, to.n);
    if (found != kNowhere) flow.add(to.from, {found, ExitKind::Jump});
  }
}

}  // namespace

std::vector<ProgramFlow> flow_of(const Code& code, InterruptCheck& interrupt) {
  std::vector<Address> labelled;
  for (const LabelledHead& head : code.heads)
    if (head.label != LabelledHead::kReadOnTheWay) labelled.push_back(head.address);
  std::sort(labelled.begin(), labelled.end());
  std::vector<ProgramFlow> all;
  all.reserve(code.programs.size());
  for (std::size_t i = 0; i < code.programs.size(); ++i)
    all.emplace_back(code, static_cast<std::int32_t>(i), labelled, interrupt);
  std::vector<bool> called(all.size(), false);
  CallWays ways(code, all);
  for (const ProgramFlow& flow : all)
    for (const CallEdge& edge : flow.calls()) {
      if (interrupt.requested(InterruptCheck::kBlock)) break;
      called[static_cast<std::size_t>(edge.called)] = true;
      ways.add(edge);
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!called[i]) add_main(code, all[i]);
    all[i].close();
    if (interrupt.requested(all[i].size())) break;
  }
  return all;
}

std::vector<bool> ProgramFlow::reached() const {
  std::vector<Address> waiting{first_};
  waiting.insert(waiting.end(), entries_.begin(), entries_.end());
  return reached(std::move(waiting));
}

Arrows ProgramFlow::backwards() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  all.reserve(exits_.size());
  for (Address at = first_; at <= anywhere(); ++at)
    for (const Exit* exit = begin(at); exit != end(at); ++exit)
      all.emplace_back(exit->to - first_, at - first_);
  return {size(), all};
}

std::vector<bool> ProgramFlow::reached_from(Address start) const { return reached({start}); }

std::vector<bool> ProgramFlow::reached(std::vector<Address> waiting) const {
  std::vector<bool> found(size(), false);
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (at < first_ || at > anywhere() || found[at - first_]) continue;
    found[at - first_] = true;
    for (const Exit* exit = begin(at); exit != end(at); ++exit) waiting.push_back(exit->to);
  }
  return found;
}

}  // namespace cncsub
