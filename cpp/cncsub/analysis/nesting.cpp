// How deep calls go on any way, and circles of calls.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// How many calls are open: of subprograms, of macros, of both.
using Depth = std::array<int, 3>;

/// Whether the control refuses a call of a program by itself, wherever it begins.
bool is_refused_again(const Checker& c, const CallEdge& edge) {
  const SelfCall rule = c.code.control->calls.self_call.value;
  const CallRecord& record = c.code.calls[edge.record];
  return edge.called == edge.caller && record.kind != CallKind::Local &&
         (rule == SelfCall::Refused || (rule == SelfCall::WithStart && record.target.start_n < 0));
}

/// Programs that call themselves where the control refuses it.
void check_self_calls(Checker& c) {
  for (const ProgramFlow& flow : c.flows)
    for (const CallEdge& edge : flow.calls()) {
      const Block& block = c.code.blocks[edge.from];
      const bool code = block.op == Op::Choose && c.code.choices[block.aux].address != 0;
      if (code || c.inside(flow) || !is_refused_again(c, edge)) continue;
      const CallRecord& record = c.code.calls[edge.record];
      std::string names = c.code.name_of(edge.called);
      names += " > " + c.code.name_of(edge.called);
      c.refused(Check::CallsOpen, edge.from,
                {Cause::ProgramCallsItself, record.at, record.width, std::move(names)});
    }
}

/// A program from a block on: what a call enters.
struct Entered {
  std::int32_t program;
  Address start;
};

/// What calls enter, and what each of these calls: only calls that some way from its first block
/// leads to, where a program is entered at several.
class CallTree {
 public:
  struct Call {
    const CallEdge* edge;
    std::size_t to;
  };

  explicit CallTree(const Checker& c);
  std::size_t size() const { return entered_.size(); }
  const Entered& entered(std::size_t place) const { return entered_[place]; }
  const std::vector<Call>& calls(std::size_t place) const { return calls_[place]; }

 private:
  std::size_t enter(std::int32_t program, Address start);
  void take_calls(std::size_t place);

  const Checker& c_;
  std::size_t looked_at_ = 0;  // blocks, for all starts inside programs
  std::map<std::pair<std::int32_t, Address>, std::size_t> inside_;  // those that begin inside
  std::vector<Entered> entered_;
  std::vector<std::vector<Call>> calls_;
};

CallTree::CallTree(const Checker& c) : c_(c) {
  entered_.reserve(c.flows.size());
  for (const ProgramFlow& flow : c.flows) entered_.push_back({flow.program(), flow.first()});
  for (std::size_t place = 0; place < entered_.size(); ++place) take_calls(place);
}

std::size_t CallTree::enter(std::int32_t program, Address start) {
  if (start == kNowhere || start == c_.flow(program).first())
    return static_cast<std::size_t>(program);
  const auto [found, added] = inside_.try_emplace({program, start}, entered_.size());
  if (added) entered_.push_back({program, start});
  return found->second;
}

void CallTree::take_calls(std::size_t place) {
  constexpr std::size_t kMostBlocks = 4'000'000;  // beyond that, starts inside call nothing here
  const Entered from = entered_[place];
  const ProgramFlow& flow = c_.flow(from.program);
  calls_.emplace_back();
  if (flow.calls().empty()) return;
  std::vector<bool> reached;
  if (!flow.entries().empty()) {
    if (looked_at_ > kMostBlocks && from.start != flow.first()) return;
    looked_at_ += flow.size();
    reached = flow.reached_from(from.start);
  }
  for (const CallEdge& edge : flow.calls())
    if (reached.empty() || reached[edge.from - flow.first()])
      calls_[place].push_back({&edge, enter(edge.called, edge.start)});
}

/// All that is entered, each before what it calls, but for the calls that close a circle.
class CallOrder {
 public:
  CallOrder(Checker& c, const CallTree& tree)
      : c_(c), tree_(tree), state_(tree.size(), Walked::New) {
    for (std::size_t i = 0; i < state_.size(); ++i)
      if (state_[i] == Walked::New) walk(i);
    std::reverse(order_.begin(), order_.end());
    std::sort(closing_.begin(), closing_.end());
  }
  const std::vector<std::size_t>& order() const { return order_; }
  /// Whether a call leads back to what is open.
  bool closes(std::size_t from, const CallEdge& edge) const {
    return std::binary_search(closing_.begin(), closing_.end(), std::pair(from, &edge));
  }

 private:
  enum class Walked : std::uint8_t { New, Open, Done };
  struct Open {
    std::size_t place;
    std::size_t call = 0;
  };

  void walk(std::size_t from);
  void circle(const CallTree::Call& call);
  std::string name(std::size_t place) const;
  bool is_of_open_caller(const CallEdge& edge) const;
  void refuse(const CallEdge& edge);

  Checker& c_;
  const CallTree& tree_;
  std::vector<Walked> state_;
  std::vector<Open> open_;
  std::vector<std::size_t> order_;
  std::vector<std::pair<std::size_t, const CallEdge*>> closing_;
  std::set<Address> told_;
};

void CallOrder::circle(const CallTree::Call& call) {
  const CallEdge& edge = *call.edge;
  closing_.emplace_back(open_.back().place, &edge);
  // A code does not call in the program that it calls.
  const Block& block = c_.code.blocks[edge.from];
  const bool code = block.op == Op::Choose && c_.code.choices[block.aux].address != 0;
  if (code || is_refused_again(c_, edge) || !told_.insert(edge.from).second) return;
  auto first = open_.begin();
  while (first->place != call.to) ++first;
  std::string names = name(call.to);
  std::vector<Address> path;
  for (auto at = first; at + 1 != open_.end(); ++at) {
    path.push_back(tree_.calls(at->place)[at->call - 1].edge->from);
    names += " > " + name((at + 1)->place);
  }
  names += " > " + name(call.to);
  const CallRecord& record = c_.code.calls[edge.record];
  c_.found(Check::Recursion, edge.from, {record.at, record.width}, names).path = std::move(path);
}

/// Whether the control refuses a call because its program is open already.
bool CallOrder::is_of_open_caller(const CallEdge& edge) const {
  const CallerCall rule = c_.code.control->calls.caller_call.value;
  const bool started = c_.code.calls[edge.record].target.start_n >= 0;
  if (edge.called == edge.caller || rule == CallerCall::Allowed ||
      (rule == CallerCall::WithStart && started) ||
      (rule == CallerCall::MainRefused && edge.called != c_.main))
    return false;
  return std::any_of(open_.begin(), open_.end(), [&](const Open& open) {
    return tree_.entered(open.place).program == edge.called;
  });
}

void CallOrder::refuse(const CallEdge& edge) {
  if (!told_.insert(edge.from).second) return;
  auto first = open_.begin();
  while (tree_.entered(first->place).program != edge.called) ++first;
  std::string names;
  std::vector<Address> path;
  for (auto at = first; at != open_.end(); ++at) {
    if (at + 1 != open_.end()) path.push_back(tree_.calls(at->place)[at->call - 1].edge->from);
    names += name(at->place);
    names += " > ";
  }
  const CallRecord& record = c_.code.calls[edge.record];
  c_.refused(
        Check::CallsOpen, edge.from,
        {Cause::ProgramCallsCaller, record.at, record.width, names + c_.code.name_of(edge.called)})
      .path = std::move(path);
}

/// "O2", and "O2 N100" where it is entered inside.
std::string CallOrder::name(std::size_t place) const {
  const Entered& of = tree_.entered(place);
  std::string program = c_.code.name_of(of.program);
  if (of.start == c_.flow(of.program).first() || of.start >= c_.code.blocks.size()) return program;
  const std::int32_t n = c_.code.blocks[of.start].n;
  return n < 0 ? program : program + " N" + std::to_string(n);
}

void CallOrder::walk(std::size_t from) {
  open_.push_back({from});
  state_[from] = Walked::Open;
  while (!open_.empty()) {
    Open& top = open_.back();
    const std::vector<CallTree::Call>& calls = tree_.calls(top.place);
    if (top.call == calls.size()) {
      state_[top.place] = Walked::Done;
      order_.push_back(top.place);
      open_.pop_back();
      continue;
    }
    const CallTree::Call& call = calls[top.call++];
    if (is_of_open_caller(*call.edge)) refuse(*call.edge);
    Walked& state = state_[call.to];
    if (state == Walked::Open) circle(call);
    if (state != Walked::New) continue;
    state = Walked::Open;
    open_.push_back({call.to});
  }
}

class NestingCheck {
 public:
  NestingCheck(Checker& c, const CallTree& tree)
      : c_(c), tree_(tree), deepest_(tree.size()), from_(tree.size()) {}

  void call(std::size_t from, const CallTree::Call& call);

 private:
  struct Limit {
    int measure;
    int most;
    Cause cause;
    const char* what;
  };
  std::vector<Limit> limits(bool macro) const;
  std::vector<Address> path(std::size_t to, std::size_t measure) const;

  /// The call by which something is deepest.
  struct By {
    std::size_t caller = 0;
    const CallEdge* edge = nullptr;
  };

  Checker& c_;
  const CallTree& tree_;
  std::vector<Depth> deepest_;
  std::vector<std::array<By, 3>> from_;
  std::set<Address> told_;
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

std::vector<Address> NestingCheck::path(std::size_t to, std::size_t measure) const {
  std::vector<Address> blocks;
  for (By at = from_[to][measure]; at.edge != nullptr && blocks.size() < tree_.size();
       at = from_[at.caller][measure])
    blocks.push_back(at.edge->from);
  std::reverse(blocks.begin(), blocks.end());
  return blocks;
}

void NestingCheck::call(std::size_t from, const CallTree::Call& call) {
  const CallEdge& edge = *call.edge;
  Depth deeper = deepest_[from];
  const CallRecord& record = c_.code.calls[edge.record];
  ++deeper[record.macro ? 1 : 0];
  ++deeper[2];
  for (const Limit& limit : limits(record.macro)) {
    const auto measure = static_cast<std::size_t>(limit.measure);
    if (deeper[measure] != limit.most + 1 || !told_.insert(edge.from).second) continue;
    c_.refused(Check::TooDeep, edge.from,
               {limit.cause, record.at, record.width,
                "the control allows " + std::to_string(limit.most) + limit.what})
        .path = path(from, measure);
    break;
  }
  for (std::size_t i = 0; i < deeper.size(); ++i)
    if (deeper[i] > deepest_[call.to][i]) {
      deepest_[call.to][i] = deeper[i];
      from_[call.to][i] = {from, &edge};
    }
}

}  // namespace

void check_nesting(Checker& c) {
  check_self_calls(c);
  const CallTree tree(c);
  const CallOrder order(c, tree);
  NestingCheck nesting(c, tree);
  for (const std::size_t from : order.order())
    for (const CallTree::Call& call : tree.calls(from))
      if (!order.closes(from, *call.edge)) nesting.call(from, call);
}

}  // namespace cncsub
