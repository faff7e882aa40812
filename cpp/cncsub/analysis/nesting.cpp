// How deep calls go on any way, and circles of calls.
#include <algorithm>
#include <array>
#include <string>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// How many calls are open: of subprograms, of macros, of both.
using Depth = std::array<int, 3>;

/// All programs, each before those it calls, but for the calls that close a circle.
class CallOrder {
 public:
  explicit CallOrder(Checker& c) : c_(c), state_(c.flows.size(), Walked::New) {
    for (std::size_t i = 0; i < state_.size(); ++i)
      if (state_[i] == Walked::New) walk(static_cast<std::int32_t>(i));
    std::reverse(order_.begin(), order_.end());
  }
  const std::vector<std::int32_t>& order() const { return order_; }
  /// Whether a call leads back to a program that is open.
  bool closes(const CallEdge& edge) const {
    return std::binary_search(closing_.begin(), closing_.end(), edge.from);
  }

 private:
  enum class Walked : std::uint8_t { New, Open, Done };
  struct Open {
    std::int32_t program;
    std::size_t call = 0;
  };

  void walk(std::int32_t from);
  void circle(const CallEdge& edge);
  bool is_apart(const CallEdge& edge) const;

  Checker& c_;
  std::vector<Walked> state_;
  std::vector<Open> open_;
  std::vector<std::int32_t> order_;
  std::vector<Address> closing_;
};

/// Whether a program calls a part of itself that does not lead back to the call.
bool CallOrder::is_apart(const CallEdge& edge) const {
  constexpr std::size_t kFar = 4096;
  const ProgramFlow& flow = c_.flow(edge.caller);
  if (edge.called != edge.caller || edge.start == flow.first()) return false;
  std::vector<bool> seen(flow.size(), false);
  std::vector<Address> waiting{edge.start};
  for (std::size_t count = 0; !waiting.empty() && count < kFar; ++count) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (at == edge.from) return false;
    if (seen[at - flow.first()]) continue;
    seen[at - flow.first()] = true;
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit)
      waiting.push_back(exit->to);
  }
  return true;
}

void CallOrder::circle(const CallEdge& edge) {
  closing_.push_back(edge.from);
  const CallRecord& record = c_.code.calls[edge.record];
  // Blocks of the own program; and a code that does not call in the program that it calls.
  const Block& block = c_.code.blocks[edge.from];
  const bool code = block.op == Op::Choose && c_.code.choices[block.aux].address != 0;
  if (record.kind == CallKind::Local || code || is_apart(edge)) return;
  auto first = open_.begin();
  while (first->program != edge.called) ++first;
  std::string names = c_.code.name_of(edge.called);
  std::vector<Address> path;
  for (auto at = first; at + 1 != open_.end(); ++at) {
    path.push_back(c_.flow(at->program).calls()[at->call - 1].from);
    names += " > " + c_.code.name_of((at + 1)->program);
  }
  names += " > " + c_.code.name_of(edge.called);
  const bool refused = edge.called == edge.caller &&
                       (c_.code.control->calls.self_call.value == SelfCall::Refused ||
                        (c_.code.control->calls.self_call.value == SelfCall::WithStart &&
                         record.target.start_n < 0));
  Finding& found = refused
                       ? c_.refused(Check::Recursion, edge.from,
                                    {Cause::ProgramCallsItself, record.at, record.width, names})
                       : c_.found(Check::Recursion, edge.from, {record.at, record.width}, names);
  found.path = std::move(path);
}

void CallOrder::walk(std::int32_t from) {
  open_.push_back({from});
  state_[static_cast<std::size_t>(from)] = Walked::Open;
  while (!open_.empty()) {
    Open& top = open_.back();
    const std::vector<CallEdge>& calls = c_.flow(top.program).calls();
    if (top.call == calls.size()) {
      state_[static_cast<std::size_t>(top.program)] = Walked::Done;
      order_.push_back(top.program);
      open_.pop_back();
      continue;
    }
    const CallEdge& edge = calls[top.call++];
    Walked& state = state_[static_cast<std::size_t>(edge.called)];
    if (state == Walked::Open) circle(edge);
    if (state != Walked::New) continue;
    state = Walked::Open;
    open_.push_back({edge.called});
  }
  std::sort(closing_.begin(), closing_.end());
}

class NestingCheck {
 public:
  explicit NestingCheck(Checker& c)
      : c_(c), deepest_(c.flows.size()), from_(c.flows.size(), {nullptr, nullptr, nullptr}) {}

  void call(const CallEdge& edge);

 private:
  struct Limit {
    int measure;
    int most;
    Cause cause;
    const char* what;
  };
  std::vector<Limit> limits(bool macro) const;
  std::vector<Address> path(const CallEdge& edge, std::size_t measure) const;

  Checker& c_;
  std::vector<Depth> deepest_;
  std::vector<std::array<const CallEdge*, 3>> from_;
};

std::vector<NestingCheck::Limit> NestingCheck::limits(bool macro) const {
  const CallRules& rules = c_.code.control->calls;
  std::vector<Limit> all;
  if (macro)
    all.push_back(
        {1, rules.max_macro_nesting.value, Cause::MacroNestingTooDeep, " levels of macro calls"});
  if (rules.nesting_counts_macros.value)
    all.push_back({2, rules.max_nesting.value, Cause::NestingTooDeep, " levels of calls"});
  else if (!macro)
    all.push_back({0, rules.max_nesting.value, Cause::NestingTooDeep, " levels of calls"});
  if (rules.max_total_nesting.value > 0)
    all.push_back({2, rules.max_total_nesting.value, Cause::NestingTooDeep,
                   " levels of calls of both kinds"});
  return all;
}

std::vector<Address> NestingCheck::path(const CallEdge& edge, std::size_t measure) const {
  std::vector<Address> blocks;
  for (const CallEdge* at = from_[static_cast<std::size_t>(edge.caller)][measure];
       at != nullptr && blocks.size() < c_.flows.size();
       at = from_[static_cast<std::size_t>(at->caller)][measure])
    blocks.push_back(at->from);
  std::reverse(blocks.begin(), blocks.end());
  return blocks;
}

void NestingCheck::call(const CallEdge& edge) {
  const Depth& depth = deepest_[static_cast<std::size_t>(edge.caller)];
  Depth deeper = depth;
  ++deeper[edge.macro ? 1 : 0];
  ++deeper[2];
  const CallRecord& record = c_.code.calls[edge.record];
  for (const Limit& limit : limits(edge.macro)) {
    const auto measure = static_cast<std::size_t>(limit.measure);
    if (deeper[measure] != limit.most + 1) continue;
    c_.refused(Check::TooDeep, edge.from,
               {limit.cause, record.at, record.width,
                "the control allows " + std::to_string(limit.most) + limit.what})
        .path = path(edge, measure);
    break;
  }
  const auto called = static_cast<std::size_t>(edge.called);
  for (std::size_t i = 0; i < deeper.size(); ++i)
    if (deeper[i] > deepest_[called][i]) {
      deepest_[called][i] = deeper[i];
      from_[called][i] = &edge;
    }
}

}  // namespace

void check_nesting(Checker& c) {
  const CallOrder order(c);
  NestingCheck nesting(c);
  for (const std::int32_t program : order.order())
    for (const CallEdge& edge : c.flow(program).calls())
      if (!order.closes(edge)) nesting.call(edge);
}

}  // namespace cncsub
