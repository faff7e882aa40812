// Locals that have no value, arguments that nobody gives or reads, variables that two programs use.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/code/variables_used.hpp"

namespace cncsub {

namespace {

/// Variables as bits: a local by its number; others by places that somebody gave them.
using Bits = std::uint64_t;
constexpr std::int32_t kMostBits = 64;

/// What one block does with variables.
struct Use {
  std::vector<std::int32_t> reads, writes;  // locals by number, commons by number
  Bits read_locals = 0, written_locals = 0;
  Bits word_locals = 0;  // those of `read_locals` that a word holds alone
  bool tests = false;    // compares with #0: what it reads may be vacant
  bool any = false;      // a number is computed, or a name is used
};

/// All that one program does.
struct Summary {
  Bits reads = 0, writes = 0, tested = 0;  // locals, with those of subprograms that share them
  bool any = false;                        // any variable may be read or written
};

/// Of numbers in order those that are among `numbers`, as bits.
Bits bits_of(const std::vector<std::int32_t>& ordered, const std::vector<std::int32_t>& numbers) {
  Bits found = 0;
  for (const std::int32_t number : numbers) {
    const auto at = std::lower_bound(ordered.begin(), ordered.end(), number);
    if (at != ordered.end() && *at == number) found |= Bits{1} << (at - ordered.begin());
  }
  return found;
}

class VariableCheck {
 public:
  explicit VariableCheck(Checker& c);
  void run();

 private:
  struct Vacant {
    Bits always = 0, sometimes = 0;
    bool reached = false;
  };

  void take(const ProgramFlow& flow, Address at);
  Bits bit_of(std::int64_t number, std::vector<std::int32_t>& to);
  bool tests_vacancy(const Block& block) const;
  const Use* use(Address at) const {
    const auto found = uses_.find(at);
    return found == uses_.end() ? nullptr : &found->second;
  }
  Summary& summary(std::int32_t program) { return summaries_[static_cast<std::size_t>(program)]; }
  void share();
  Bits given(const CallEdge& edge) const;
  Vacant at_entry(const ProgramFlow& flow);
  std::vector<Vacant> vacant(const ProgramFlow& flow);
  void pass(const ProgramFlow& flow, Address at, Vacant& state);
  void tell_vacant(const ProgramFlow& flow);
  void tell_vacant(const ProgramFlow& flow, Address at, Bits locals, Check check);
  void tell_unread();
  void tell_overwritten(const ProgramFlow& flow);
  void tell_overwritten(const ProgramFlow& flow, const std::vector<std::int32_t>& candidates);
  std::vector<std::int32_t> scratch(std::int32_t program);
  Bits handed_over(const ProgramFlow& flow, const std::vector<std::int32_t>& both);
  Bits overwrites(const CallEdge& edge, const std::vector<std::int32_t>& candidates);
  void tell_lost(const ProgramFlow& flow, Address at, std::int32_t number);
  TextPlace place_of(Address at, std::int32_t number) const;

  Checker& c_;
  std::unordered_map<Address, Use> uses_;
  std::vector<Summary> summaries_;
  std::vector<std::optional<std::vector<std::int32_t>>> scratch_;
  std::vector<std::vector<const CallEdge*>> calls_at_;
  bool computed_calls_ = false;
  Bits locals_;
};

VariableCheck::VariableCheck(Checker& c)
    : c_(c), summaries_(c.flows.size()), scratch_(c.flows.size()) {
  const std::int32_t last = std::min(c.code.locals, kMostBits) - 1;
  locals_ = (last >= 63 ? ~Bits{0} : (Bits{1} << (last + 1)) - 1) & ~Bits{1};
  for (const ProgramFlow& flow : c.flows) {
    computed_calls_ = computed_calls_ || flow.calls_computed();
    if (c.inside(flow)) continue;
    for (Address at = flow.first(); at < flow.last(); ++at) take(flow, at);
  }
}

Bits VariableCheck::bit_of(std::int64_t number, std::vector<std::int32_t>& to) {
  const VariablePlace place = c_.code.place(number);
  const bool local = place.is_local() && place.index < kMostBits;
  if (local || place.is_common()) to.push_back(static_cast<std::int32_t>(number));
  return local ? Bits{1} << place.index : 0;
}

/// Whether a condition of the block compares with #0.
bool VariableCheck::tests_vacancy(const Block& block) const {
  bool tests = false;
  each_variant(c_.code, block, [&](const Block& of) {
    if (of.op != Op::IfGoto && of.op != Op::IfThen && of.op != Op::If && of.op != Op::While) return;
    const Expression& condition = c_.code.expressions[c_.code.statements[of.aux].expression];
    for (const Instruction* at = c_.code.instructions.data() + condition.first; at->op != Ins::End;
         ++at) {
      tests = tests || (at->op == Ins::Constant && is_vacant(at->value));
    }
  });
  return tests;
}

void VariableCheck::take(const ProgramFlow& flow, Address at) {
  const Block& block = c_.code.blocks[at];
  const bool plain = block.op == Op::Linear || block.op == Op::Arc || block.op == Op::Fault;
  const bool words =
      block.op == Op::Words && (block.flags & Block::kCodeExpression) == 0 &&
      ((block.flags & Block::kHasExtra) == 0 || c_.code.cells[block.data].extra.expressions == 0);
  if (plain || words) return;
  const References of = references_of(c_.code, block, flow.program());
  if (of.reads.empty() && of.writes.empty()) return;
  Use use;
  use.tests = tests_vacancy(block);
  const std::string& text = c_.code.files[c_.program(flow.program()).file].text;
  for (const VariableReference& each : of.reads) {
    use.any = use.any || each.computed || each.number < 0;
    const Bits own = each.number < 0 ? 0 : bit_of(each.number, use.reads);
    use.read_locals |= own;
    const std::string_view written = std::string_view(text).substr(each.place.at, each.place.width);
    const bool alone =
        is_words(block.op) && written.find_first_of("[+*/") == std::string_view::npos;
    if (alone) use.word_locals |= own;
  }
  for (const VariableReference& each : of.writes) {
    use.any = use.any || each.computed || each.number < 0;
    if (each.number >= 0) use.written_locals |= bit_of(each.number, use.writes);
  }
  Summary& own = summary(flow.program());
  own.reads |= use.read_locals;
  own.writes |= use.written_locals;
  own.any = own.any || use.any;
  if (use.tests) own.tested |= use.read_locals;
  uses_.emplace(at, std::move(use));
}

/// A subprogram has the locals of its caller: what it does is done by the caller too.
void VariableCheck::share() {
  std::vector<std::int32_t> waiting;
  for (const ProgramFlow& flow : c_.flows) waiting.push_back(flow.program());
  while (!waiting.empty()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    const Summary of = summary(program);
    for (const CallEdge& edge : c_.callers[static_cast<std::size_t>(program)]) {
      if (edge.macro) continue;
      Summary& caller = summary(edge.caller);
      const Summary before = caller;
      caller.reads |= of.reads;
      caller.writes |= of.writes;
      caller.tested |= of.tested;
      caller.any = caller.any || of.any;
      if (caller.reads != before.reads || caller.writes != before.writes ||
          caller.tested != before.tested || caller.any != before.any)
        waiting.push_back(edge.caller);
    }
  }
}

/// The locals that the arguments of a call set.
Bits VariableCheck::given(const CallEdge& edge) const {
  const CallRecord& record = c_.code.calls[edge.record];
  Bits given = 0;
  for (std::uint32_t i = 0; i < record.arguments; ++i) {
    const std::int16_t variable = c_.code.arguments[record.first_argument + i].variable;
    if (variable >= 0 && variable < kMostBits) given |= Bits{1} << variable;
  }
  return given;
}

VariableCheck::Vacant VariableCheck::at_entry(const ProgramFlow& flow) {
  const auto& callers = c_.callers[static_cast<std::size_t>(flow.program())];
  Vacant entry{0, 0, true};
  if (callers.empty()) {
    // Nobody knows who calls a subprogram that is not called here.
    if (flow.ever_ends() || !flow.ever_returns()) entry = {locals_, locals_, true};
    return entry;
  }
  if (computed_calls_ || flow.program() == c_.main) return entry;
  Bits always = locals_, sometimes = 0;
  for (const CallEdge& edge : callers) {
    const CallKind kind = c_.code.calls[edge.record].kind;
    const bool own = edge.macro && (kind == CallKind::Macro || kind == CallKind::GCode ||
                                    kind == CallKind::MCode);
    if (!own || c_.code.calls[edge.record].variable != 0) return entry;
    always &= ~given(edge);
    sometimes |= locals_ & ~given(edge);
  }
  return {always, sometimes, true};
}

/// What a block and the programs it calls give values to.
void VariableCheck::pass(const ProgramFlow& flow, Address at, Vacant& state) {
  if (at >= flow.last()) return;
  Bits set = 0;
  if (const Use* own = use(at)) set = own->any ? ~Bits{0} : own->written_locals;
  for (const CallEdge* edge : calls_at_[at - flow.first()]) {
    if (edge->macro) continue;
    const Summary& called = summary(edge->called);
    set |= called.any ? ~Bits{0} : called.writes;
  }
  const Op op = c_.code.blocks[at].op;
  if (op == Op::Labelled || op == Op::Choose ||
      (op == Op::Call && calls_at_[at - flow.first()].empty()))
    set = ~Bits{0};
  state.always &= ~set;
  // A variable that is set only where a condition holds, and read where it holds again, has one.
  state.sometimes &= ~set;
}

/// Which locals have no value before each block: on every way to it, on some way.
std::vector<VariableCheck::Vacant> VariableCheck::vacant(const ProgramFlow& flow) {
  std::vector<Vacant> before(flow.size());
  std::vector<Address> waiting;
  const auto reach = [&](Address at, const Vacant& state) {
    Vacant& own = before[at - flow.first()];
    const Vacant old = own;
    own.always = own.reached ? own.always & state.always : state.always;
    own.sometimes |= state.sometimes;
    own.reached = true;
    if (!old.reached || own.always != old.always || own.sometimes != old.sometimes)
      waiting.push_back(at);
  };
  for (const Address entry : flow.entries()) reach(entry, {0, 0, true});
  reach(flow.first(), at_entry(flow));
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Vacant state = before[at - flow.first()];
    pass(flow, at, state);
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) reach(exit->to, state);
  }
  return before;
}

/// The word or value of a block that reads a variable.
TextPlace VariableCheck::place_of(Address at, std::int32_t number) const {
  const Block& block = c_.code.blocks[at];
  const References of = references_of(c_.code, block, c_.code.program_at(at));
  for (const VariableReference& each : of.reads)
    if (each.number == number) return each.place;
  return {block.text, block.length};
}

void VariableCheck::tell_vacant(const ProgramFlow& flow, Address at, Bits locals, Check check) {
  for (std::int32_t local = 1; local < kMostBits; ++local) {
    if ((locals >> local & 1) == 0) continue;
    const std::string name = "#" + std::to_string(local);
    Finding& found = c_.found(check, at, place_of(at, local),
                              check == Check::ArgumentMissing ? "no call gives " + name
                              : check == Check::Vacant        ? name + " has no value here"
                                                              : name + " may have no value here");
    if (check != Check::ArgumentMissing) continue;
    found.path = {c_.callers[static_cast<std::size_t>(flow.program())].front().from};
  }
}

void VariableCheck::tell_vacant(const ProgramFlow& flow) {
  Bits told = summary(flow.program()).tested;
  const std::vector<Vacant> before = vacant(flow);
  const bool macro = c_.is_called(flow.program());
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const Use* own = use(at);
    const Vacant& state = before[at - flow.first()];
    if (own == nullptr || !state.reached || own->read_locals == 0) continue;
    const Bits always = own->read_locals & state.always & ~told;
    tell_vacant(flow, at, always, macro ? Check::ArgumentMissing : Check::Vacant);
    told |= always;
    const Bits sometimes = own->read_locals & ~own->word_locals & state.sometimes & ~told;
    tell_vacant(flow, at, sometimes, Check::MaybeVacant);
    told |= sometimes;
  }
}

/// Arguments that a macro and the subprograms that share its locals never read.
void VariableCheck::tell_unread() {
  for (const ProgramFlow& flow : c_.flows)
    for (const CallEdge& edge : flow.calls()) {
      if (!edge.macro || edge.start == kNowhere) continue;
      const ProgramFlow& called = c_.flow(edge.called);
      const Summary& of = summary(edge.called);
      if (of.any || called.calls_computed()) continue;
      const CallRecord& record = c_.code.calls[edge.record];
      for (std::uint32_t i = 0; i < record.arguments; ++i) {
        const Argument& argument = c_.code.arguments[record.first_argument + i];
        const bool known = argument.variable > 0 && argument.variable < kMostBits;
        if (!known || (of.reads >> argument.variable & 1) != 0) continue;
        c_.found(
            Check::ArgumentUnread, edge.from, {argument.operand.at, argument.operand.width},
            c_.code.name_of(edge.called) + " never reads #" + std::to_string(argument.variable));
      }
    }
}

/// The variables that a program uses as its own: it writes each before it reads it, and reads it.
std::vector<std::int32_t> VariableCheck::scratch(std::int32_t program) {
  auto& known = scratch_[static_cast<std::size_t>(program)];
  if (known) return *known;
  known.emplace();
  const ProgramFlow& flow = c_.flow(program);
  std::map<std::int32_t, std::pair<bool, bool>> seen;  // number: read, written
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const Use* own = use(at)) {
      if (own->any) return *known;
      for (const std::int32_t number : own->reads) seen[number].first = true;
      for (const std::int32_t number : own->writes) seen[number].second = true;
    }
  std::vector<std::int32_t> both;
  for (const auto& [number, how] : seen)
    if (how.first && how.second) both.push_back(number);
  if (both.size() > kMostBits) both.resize(kMostBits);
  const Bits handed = handed_over(flow, both);
  for (std::size_t i = 0; i < both.size(); ++i)
    if ((handed >> i & 1) == 0) known->push_back(both[i]);
  return *known;
}

/// Which of these variables some way reads before it writes them.
Bits VariableCheck::handed_over(const ProgramFlow& flow, const std::vector<std::int32_t>& both) {
  std::vector<Bits> unwritten(flow.size(), 0);
  std::vector<Address> waiting{flow.first()};
  unwritten[0] = both.empty() ? 0 : ~Bits{0} >> (kMostBits - static_cast<int>(both.size()));
  Bits handed = 0;
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    Bits state = unwritten[at - flow.first()];
    if (const Use* own = at < flow.last() ? use(at) : nullptr) {
      handed |= state & bits_of(both, own->reads);
      state &= ~bits_of(both, own->writes);
    }
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) {
      Bits& next = unwritten[exit->to - flow.first()];
      if ((next | state) == next) continue;
      next |= state;
      waiting.push_back(exit->to);
    }
  }
  return handed;
}

void VariableCheck::tell_overwritten(const ProgramFlow& flow) {
  std::vector<std::int32_t> own, called;
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const Use* of = use(at)) own.insert(own.end(), of->writes.begin(), of->writes.end());
  std::sort(own.begin(), own.end());
  for (const CallEdge& edge : flow.calls()) {
    if (edge.called == flow.program()) continue;
    const std::vector<std::int32_t> of = scratch(edge.called);
    for (const std::int32_t number : of) {
      const bool shared = !edge.macro || !c_.code.place(number).is_local();
      if (shared && std::binary_search(own.begin(), own.end(), number)) called.push_back(number);
    }
  }
  std::sort(called.begin(), called.end());
  called.erase(std::unique(called.begin(), called.end()), called.end());
  for (std::size_t first = 0; first < called.size(); first += kMostBits) {
    const std::size_t last = std::min<std::size_t>(called.size(), first + kMostBits);
    tell_overwritten(flow, {called.begin() + static_cast<std::ptrdiff_t>(first),
                            called.begin() + static_cast<std::ptrdiff_t>(last)});
  }
}

/// What a call of a program makes of its caller's variables.
Bits VariableCheck::overwrites(const CallEdge& edge, const std::vector<std::int32_t>& candidates) {
  Bits found = 0;
  const std::vector<std::int32_t> of = scratch(edge.called);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool shared = !edge.macro || !c_.code.place(candidates[i]).is_local();
    if (shared && std::binary_search(of.begin(), of.end(), candidates[i])) found |= Bits{1} << i;
  }
  return found;
}

/// Of these variables those that the program reads as its own, and reads again as its own after a
/// called program has used them.
void VariableCheck::tell_overwritten(const ProgramFlow& flow,
                                     const std::vector<std::int32_t>& candidates) {
  struct State {
    Bits own = 0, lost = 0;
    bool reached = false;
  };
  std::vector<State> before(flow.size());
  std::vector<Address> waiting;
  const auto reach = [&](Address at, const State& state) {
    State& of = before[at - flow.first()];
    const State old = of;
    of.own |= state.own, of.lost |= state.lost, of.reached = true;
    if (!old.reached || of.own != old.own || of.lost != old.lost) waiting.push_back(at);
  };
  reach(flow.first(), {});
  Bits read = 0;
  while (!waiting.empty()) {
    const Address at = waiting.back();
    waiting.pop_back();
    State state = before[at - flow.first()];
    if (const Use* of = at < flow.last() ? use(at) : nullptr) {
      read |= state.own & bits_of(candidates, of->reads);
      const Bits set = bits_of(candidates, of->writes);
      state.own = of->any ? 0 : state.own | set;
      state.lost = of->any ? 0 : state.lost & ~set;
    }
    for (const CallEdge* edge : calls_at_[at - flow.first()]) {
      const Bits lost = state.own & overwrites(*edge, candidates);
      state.own &= ~lost;
      state.lost |= lost;
    }
    for (const Exit* exit = flow.begin(at); exit != flow.end(at); ++exit) reach(exit->to, state);
  }
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (const Use* of = use(at)) {
      const Bits lost = bits_of(candidates, of->reads) & before[at - flow.first()].lost & read;
      read &= ~lost;  // told once
      for (std::size_t i = 0; i < candidates.size(); ++i)
        if ((lost >> i & 1) != 0) tell_lost(flow, at, candidates[i]);
    }
}

void VariableCheck::tell_lost(const ProgramFlow& flow, Address at, std::int32_t number) {
  for (const CallEdge& edge : flow.calls()) {
    if (overwrites(edge, {number}) == 0) continue;
    const bool local = c_.code.place(number).is_local();
    c_.found(local ? Check::SharedLocal : Check::SharedCommon, at, place_of(at, number),
             c_.code.name_of(edge.called) + ", called in line " +
                 std::to_string(c_.code.blocks[edge.from].line) + ", has overwritten #" +
                 std::to_string(number))
        .path = {edge.from};
    return;
  }
}

void VariableCheck::run() {
  share();
  for (const ProgramFlow& flow : c_.flows) {
    if (c_.inside(flow)) continue;
    calls_at_.assign(flow.size(), {});
    for (const CallEdge& edge : flow.calls()) calls_at_[edge.from - flow.first()].push_back(&edge);
    if (summary(flow.program()).reads != 0) tell_vacant(flow);
    if (!flow.calls().empty()) tell_overwritten(flow);
  }
  tell_unread();
}

}  // namespace

void check_variables(Checker& c) {
  if (c.code.control->lacks(RuleGroup::MacroRules) == nullptr) VariableCheck(c).run();
}

}  // namespace cncsub
