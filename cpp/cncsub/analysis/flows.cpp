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
    for (const ProgramFlow& flow : all) numbers_.push_back(numbers_of(flow));
  }
  /// Add where the called program of a call returns to and where it begins.
  void add(const CallEdge& edge);

 private:
  static constexpr std::size_t kManyReturns = 64;      // more of them may lead anywhere
  static constexpr std::size_t kMostWays = 4'000'000;  // of a memory: more lead anywhere too

  static std::vector<std::int64_t> numbers_of(const ProgramFlow& flow) {
    std::vector<std::int64_t> numbers;
    for (const ProgramFlow::ReturnTo& to : flow.return_numbers()) numbers.push_back(to.n);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  const Code& code_;
  std::vector<ProgramFlow>& all_;
  std::vector<std::vector<std::int64_t>> numbers_;  // the numbers of M99 P by program, -1: computed
  std::size_t added_ = 0;
};

void CallWays::add(const CallEdge& edge) {
  ProgramFlow& caller = all_[static_cast<std::size_t>(edge.caller)];
  ProgramFlow& called = all_[static_cast<std::size_t>(edge.called)];
  const auto& numbers = numbers_[static_cast<std::size_t>(edge.called)];
  auto& entries = called.entries();
  if (edge.start != kNowhere && edge.start != called.first() &&
      (entries.empty() || entries.back() != edge.start))
    entries.push_back(edge.start);
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
    const Address found = to.n < 0 ? flow.anywhere() : code.first_of(program, to.n);
    if (found != kNowhere) flow.add(to.from, {found, ExitKind::Jump});
  }
}

}  // namespace

std::vector<ProgramFlow> flow_of(const Code& code, InterruptCheck& interrupt) {
  std::vector<ProgramFlow> all;
  all.reserve(code.programs.size());
  for (std::size_t i = 0; i < code.programs.size(); ++i)
    all.emplace_back(code, static_cast<std::int32_t>(i), interrupt);
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

}  // namespace cncsub
