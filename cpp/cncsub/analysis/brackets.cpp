#include "cncsub/analysis/brackets.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// A part of an expression and the operator that joins it; the operator is null for a plain value.
struct Part {
  std::size_t from = 0, to = 0;
  const OperatorRow* of = nullptr;

  explicit operator bool() const { return to > from; }
};

/// A parser of an expression as it is written, which finds where brackets are missing.
class Bracketing {
 public:
  using Value = Part;
  using Operator = OperatorRow;

  Bracketing(std::string_view written, const Spelling& spelling, LogicOrder order, bool apart)
      : text_(written),
        spelling_(spelling),
        rows_(spelling.operators(order)),
        open_(spelling.brackets.before[0]),
        close_(spelling.brackets.behind[0]),
        apart_(apart) {}

  /// Return the expression with its brackets; nothing where it has more than operators and plain
  /// values.
  std::optional<std::string> whole() {
    if (!read_operators(*this) || at_ != text_.size()) return std::nullopt;
    std::string made;
    for (std::size_t i = 0; i <= text_.size(); ++i) {
      made.append(static_cast<std::size_t>(std::count(closed_.begin(), closed_.end(), i)), close_);
      made.append(static_cast<std::size_t>(std::count(opened_.begin(), opened_.end(), i)), open_);
      if (i < text_.size()) made += text_[i];
    }
    return made;
  }

  // For read_operators.
  Part operand();
  const OperatorRow* next_operator();
  template <class Left>
  int level_of(const OperatorRow& of, const Part& /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return static_cast<std::uint32_t>(at_); }
  void pass(const OperatorRow& of) { at_ += of.spelling.size(); }
  Part apply(const OperatorRow& of, std::uint32_t /*at*/, const Part& left, const Part& right) {
    hold(left, of);
    hold(right, of);
    return {left.from, right.to, &of};
  }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  std::string_view letters() const {
    std::size_t to = at_;
    while (to < text_.size() && is_letter(text_[to])) ++to;
    return text_.substr(at_, to - at_);
  }
  bool bracket();
  void hold(const Part& part, const OperatorRow& by);

  std::string_view text_;
  const Spelling& spelling_;
  std::span<const OperatorRow> rows_;
  char open_, close_;
  bool apart_;
  std::size_t at_ = 0;
  std::vector<std::size_t> opened_, closed_;  // the characters before which brackets are missing
};

const OperatorRow* Bracketing::next_operator() {
  const std::size_t before = at_;
  blanks();
  const std::string_view rest = text_.substr(at_);
  if (is_letter(here())) return operator_of_letters(rows_, letters());
  for (const OperatorRow& of : rows_)
    if (rest.starts_with(of.spelling)) return &of;
  if (rest.empty())
    at_ = text_.size();
  else if (here() != close_)
    at_ = before;
  return nullptr;
}

/// Read an expression in brackets and look for missing brackets in it too.
bool Bracketing::bracket() {
  ++at_;
  if (!read_operators(*this) || here() != close_) return false;
  ++at_;
  return true;
}

/// Read a value as it is written: a number, a variable, a function, brackets.
Part Bracketing::operand() {
  blanks();
  const std::size_t from = at_;
  while (here() == '+' || here() == '-' || here() == '#') ++at_;
  const std::string_view name = letters();
  const bool slash =
      std::equal(name.begin(), name.end(), spelling_.slash_function.begin(),
                 spelling_.slash_function.end(), [](char a, char b) { return upper(a) == b; });
  if (slash) return {};  // the slash after its brackets may be its own
  at_ += name.size();
  const std::size_t digits = at_;
  while (is_digit(here()) || here() == '.') ++at_;
  if (at_ > digits && name.empty()) return {from, at_};
  return here() == open_ && bracket() ? Part{from, at_} : Part{};
}

void Bracketing::hold(const Part& part, const OperatorRow& by) {
  if (part.of == nullptr) return;
  const bool other = part.of->is_logic() != by.is_logic();
  const bool other_logic = apart_ && by.is_logic() && part.of->is_logic() && part.of->op != by.op;
  if (!other && !other_logic) return;
  opened_.push_back(part.from);
  closed_.push_back(part.to);
}

}  // namespace

std::optional<std::string> with_brackets(std::string_view written, const Spelling& spelling,
                                         LogicOrder order, bool apart, int most) {
  std::optional<std::string> made = Bracketing(written, spelling, order, apart).whole();
  if (!made || *made == written) return std::nullopt;
  int depth = 0, deepest = 0;
  for (const char c : *made) {
    depth += c == spelling.brackets.before[0] ? 1 : c == spelling.brackets.behind[0] ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest <= most ? made : std::nullopt;
}

}  // namespace cncsub
