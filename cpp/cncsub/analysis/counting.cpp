// Finds loops that count in fractions: sums of 0.1 are not what they look like.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// A variable, by its place.
struct Counter {
  bool local = false;
  std::uint32_t index = 0;
  bool operator==(const Counter&) const = default;
};

std::vector<Instruction> instructions_of(const Expression& of) {
  constexpr std::size_t kMost = 4;
  std::vector<Instruction> all;
  for (auto at = of.begin(); at != Expression::end() && all.size() < kMost; ++at)
    all.push_back(*at);
  return all;
}

std::optional<Counter> counter_of(const Code& code, const Instruction& ins) {
  if (ins.op == Ins::NamedLocal || ins.op == Ins::NamedCommon) {
    const NamedVariable& named = code.named_variables[static_cast<std::size_t>(ins.value)];
    return Counter{!named.common, static_cast<std::uint32_t>(named.index)};
  }
  const bool local = ins.op == Ins::Local || ins.op == Ins::LocalRaw;
  const bool common = ins.op == Ins::Common || ins.op == Ins::CommonRaw;
  if ((!local && !common) || (local && ins.at == 0)) return std::nullopt;
  return Counter{local, ins.at};
}

/// Return the comparison that has the same meaning with its two sides exchanged.
std::optional<Ins> turned(Ins op) {
  switch (exact(op)) {
    case Ins::Less:
      return Ins::Greater;
    case Ins::Greater:
      return Ins::Less;
    case Ins::LessEqual:
      return Ins::GreaterEqual;
    case Ins::GreaterEqual:
      return Ins::LessEqual;
    case Ins::Equal:
    case Ins::NotEqual:
      return exact(op);
    default:
      return std::nullopt;
  }
}

/// The condition of a loop: how its counter compares with a limit, which is a number or a variable.
struct Asked {
  Counter counter;
  Ins op{};
  Instruction limit;
};

std::optional<Asked> asked_by(const Code& code, const Expression& of) {
  const std::vector<Instruction> all = instructions_of(of);
  const auto mirrored = all.size() == 3 ? turned(all[2].op) : std::nullopt;
  if (!mirrored) return std::nullopt;
  if (const auto left = counter_of(code, all[0])) return Asked{*left, all[2].op, all[1]};
  if (const auto right = counter_of(code, all[1])) return Asked{*right, *mirrored, all[0]};
  return std::nullopt;
}

bool holds(Ins op, double a, double b) {
  switch (exact(op)) {
    case Ins::Less:
      return a < b;
    case Ins::Greater:
      return a > b;
    case Ins::LessEqual:
      return a <= b;
    case Ins::GreaterEqual:
      return a >= b;
    case Ins::Equal:
      return a == b;
    default:
      return a != b;
  }
}

constexpr int kMostPasses = 100'000;

/// Return how often the condition holds for a counter that grows by a step; none where that takes
/// very long. The sums are rounded to multiples of 1 / `digits`; where that is 0, they are as the
/// control adds them.
std::optional<int> passes(Ins op, double limit, double from, double step, double digits) {
  double value = from;
  for (int count = 0; count < kMostPasses; ++count) {
    if (!holds(op, value, limit)) return count;
    value += step;
    if (digits > 0) value = std::round(value * digits) / digits;
  }
  return std::nullopt;
}

class CountingCheck {
 public:
  CountingCheck(Checker& c, const ProgramFlow& flow) : c_(c), flow_(flow) {}
  void run();

 private:
  struct Body {
    Address from = 0, to = 0;
  };

  Body body(Address at) const;
  /// Check a loop from one block up to another, which tests its condition in a third.
  void loop(Address at, std::uint32_t expression, Address from, Address to);
  /// Check a while of a language of labels with its end.
  void o_word(Address at);
  /// Check a loop that a jump back closes, and that blocks in it leave where a condition holds.
  void leaving(Address from, Address to);
  bool assigns(Address at, const Counter& counter) const;
  void ask(Address at, const Asked& asked, const Expression& written, Address from, Address to);
  std::optional<double> value(const Instruction& of, Address from, Address to) const;
  std::optional<double> step(const Counter& counter, Address from, Address to) const;
  std::optional<double> start(const Counter& counter, Address before) const;

  Checker& c_;
  const ProgramFlow& flow_;
  std::map<std::uint32_t, Address> open_;  // the last do or while of each label
  std::size_t looked_at_ = 0;
};

bool CountingCheck::assigns(Address at, const Counter& counter) const {
  const Block& block = c_.code.blocks[at];
  if (block.op != Op::Set && block.op != Op::Assign) return block.op > Op::Arc;
  const Statement of = assignment_of(c_.code, block);
  if (of.target == Statement::Target::Indirect) return true;
  const bool local = of.target == Statement::Target::Local;
  if (!local && of.target != Statement::Target::Common) return false;
  return counter == Counter{local, static_cast<std::uint32_t>(of.index)};
}

/// The value that is added to a counter or subtracted from it.
struct Step {
  Instruction by;
  bool adds = true;
};

std::optional<Step> step_of(const Code& code, const Counter& counter, const Expression& of) {
  const std::vector<Instruction> all = instructions_of(of);
  if (all.size() == 2 && counter_of(code, all[0]) == counter) {
    const bool adds = all[1].op == Ins::AddConstant;
    if (!adds && all[1].op != Ins::SubtractConstant) return std::nullopt;
    return Step{{Ins::Constant, 0, 0, all[1].value}, adds};
  }
  if (all.size() != 3 || (all[2].op != Ins::Add && all[2].op != Ins::Subtract)) return std::nullopt;
  const bool adds = all[2].op == Ins::Add;
  if (counter_of(code, all[0]) == counter) return Step{all[1], adds};
  if (adds && counter_of(code, all[1]) == counter) return Step{all[0], adds};  // 0.1+#1
  return std::nullopt;
}

/// Return the value of a number, or of a variable that nothing in a loop changes.
std::optional<double> CountingCheck::value(const Instruction& of, Address from, Address to) const {
  if (of.op == Ins::Constant) return of.value;
  const auto variable = counter_of(c_.code, of);
  if (!variable) return std::nullopt;
  for (Address at = from; at < to; ++at) {
    const Block& block = c_.code.blocks[at];
    if ((block.op == Op::Set || block.op == Op::Assign) && assigns(at, *variable))
      return std::nullopt;
  }
  return start(*variable, from);
}

/// Return by how much the one assignment of a loop changes its counter.
std::optional<double> CountingCheck::step(const Counter& counter, Address from, Address to) const {
  std::optional<double> found;
  for (Address at = from; at < to; ++at) {
    const Block& block = c_.code.blocks[at];
    const bool sets = block.op == Op::Set || block.op == Op::Assign;
    if (!sets || !assigns(at, counter)) continue;
    const Statement of = assignment_of(c_.code, block);
    const auto added = step_of(c_.code, counter, c_.code.expression(of.expression));
    const auto by = added ? value(added->by, from, to) : std::nullopt;
    if (!by || found) return std::nullopt;
    found = added->adds ? *by : -*by;
  }
  return found;
}

/// Return the value of a counter before a loop, where the blocks before it set one.
std::optional<double> CountingCheck::start(const Counter& counter, Address before) const {
  constexpr Address kFar = 32;
  for (Address at = before; at > flow_.first() && before - at < kFar; --at) {
    if (!assigns(at - 1, counter)) continue;
    const Block& block = c_.code.blocks[at - 1];
    if (block.op != Op::Set && block.op != Op::Assign) return std::nullopt;
    const Statement of = assignment_of(c_.code, block);
    const std::vector<Instruction> all = instructions_of(c_.code.expression(of.expression));
    if (all.size() != 1 || all[0].op != Ins::Constant) return std::nullopt;
    return all[0].value;
  }
  return std::nullopt;
}

/// Return whether a step is no sum of halves, quarters, eighths ..., which are added without
/// rounding.
bool is_rounded(double step) {
  constexpr double kScale = 1 << 20;
  return std::isfinite(step) && step != 0 && std::fabs(step) < kScale &&
         std::round(step * kScale) != step * kScale;
}

void CountingCheck::loop(Address at, std::uint32_t expression, Address from, Address to) {
  const Expression written = c_.code.expression(expression);
  if (const auto asked = asked_by(c_.code, written)) ask(at, *asked, written, from, to);
}

/// Return the comparison that holds where `op` does not.
Ins opposite(Ins op) {
  switch (exact(op)) {
    case Ins::Less:
      return Ins::GreaterEqual;
    case Ins::Greater:
      return Ins::LessEqual;
    case Ins::LessEqual:
      return Ins::Greater;
    case Ins::GreaterEqual:
      return Ins::Less;
    case Ins::Equal:
      return Ins::NotEqual;
    default:
      return Ins::Equal;
  }
}

void CountingCheck::leaving(Address from, Address to) {
  for (Address at = from; at < to; ++at) {
    const Block& block = c_.code.blocks[at];
    if (block.op != Op::IfGoto) continue;
    const Statement& of = c_.code.statements[block.aux];
    if (of.to == kNowhere || (of.to >= from && of.to <= to)) continue;
    const Expression written = c_.code.expression(of.expression);
    auto asked = asked_by(c_.code, written);
    if (!asked) continue;
    asked->op = opposite(asked->op);
    ask(at, *asked, written, from, to);
  }
}

void CountingCheck::ask(Address at, const Asked& asked, const Expression& written, Address from,
                        Address to) {
  constexpr double kDigits = 1e7;
  const Address head = std::min(from, at);
  const auto by = step(asked.counter, head, to);
  if (!by || !is_rounded(*by)) return;
  const auto begins = start(asked.counter, head);
  const auto limit = value(asked.limit, head, to);
  const std::string sums = "fractions such as 0.1 are not exact in binary: ";
  std::string reported;
  if (limit && begins) {
    const auto real = passes(asked.op, *limit, *begins, *by, 0);
    const auto meant = passes(asked.op, *limit, *begins, *by, kDigits);
    if (!meant || real == meant) return;
    reported = sums + (real ? "the loop makes " + std::to_string(*real) + " passes instead of " +
                                  std::to_string(*meant)
                            : "the counter never reaches this value, and the loop never ends");
  } else if (asked.op == Ins::NotEqual) {
    reported = sums + "the counter may never reach this value, and then the loop never ends";
  }
  if (reported.empty()) return;
  c_.found(Check::FractionLoop, at, {written.at(), written.width()}, std::move(reported));
}

/// Return the blocks of the loop that the block at `at` begins, or closes with a jump back; empty
/// where it does neither.
CountingCheck::Body CountingCheck::body(Address at) const {
  const Block& block = c_.code.blocks[at];
  if (block.op == Op::While) {
    const Address end = c_.code.statements[block.aux].end;
    return end == kNowhere ? Body{} : Body{at + 1, std::min(end, flow_.last())};
  }
  if (block.op != Op::IfGoto && block.op != Op::Goto) return {};
  const Address target = c_.code.statements[block.aux].to;
  return target < flow_.first() ? Body{} : Body{target, at};
}

void CountingCheck::o_word(Address at) {
  const OWord& own = c_.code.o_words[c_.code.blocks[at].aux];
  if (own.kind == OWordKind::Sub || own.kind == OWordKind::Head || own.kind == OWordKind::EndSub)
    open_.clear();  // a label has a meaning only in its subprogram
  const auto kind_of = [&](Address of) { return c_.code.o_words[c_.code.blocks[of].aux].kind; };
  const bool ends = own.kind == OWordKind::While || own.kind == OWordKind::EndWhile;
  const auto begun = ends ? open_.find(own.label) : open_.end();
  if (begun == open_.end()) {
    if (own.kind == OWordKind::While || own.kind == OWordKind::Do) open_[own.label] = at;
    return;
  }
  const Address from = begun->second;
  const bool of_do = kind_of(from) == OWordKind::Do;
  const Address asks = of_do ? at : from;
  const std::uint32_t value = c_.code.o_words[c_.code.blocks[asks].aux].value;
  looked_at_ += at - from;
  open_.erase(begun);
  if (of_do == (own.kind == OWordKind::While) && value != OWord::kNone) loop(asks, value, from, at);
}

/// Check the loops of the program. Inner loops are visited again; a bound keeps the work in
/// proportion to the program.
void CountingCheck::run() {
  const std::size_t most = 64 * flow_.size();
  for (Address at = flow_.first(); at < flow_.last() && !c_.over(); ++at) {
    const Block& block = c_.code.blocks[at];
    if (looked_at_ > most) return;
    if (block.op == Op::OWord) o_word(at);
    const Body of = body(at);
    if (of.from >= of.to) continue;
    looked_at_ += of.to - of.from;
    if (block.op == Op::Goto)
      leaving(of.from, of.to);
    else
      loop(at, c_.code.statements[block.aux].expression, of.from, of.to);
  }
}

}  // namespace

void check_counting(Checker& c) {
  for (const ProgramFlow& flow : c.flows)
    if (!c.inside(flow)) CountingCheck(c, flow).run();
}

}  // namespace cncsub
