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

constexpr int kDeepest = 100;  // more brackets than any control takes

/// A comparison by signs, which not every control has. It binds as those by letters do.
constexpr OperatorRow kBySigns{"", 1, Ins::Equal};

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

  /// Return whether the text is an expression, and note what stands in it.
  bool read() { return read_operators(*this) && at_ == text_.size(); }
  const WrittenLogic& found() const { return found_; }
  /// Return the expression with its brackets; nothing where none are missing, or where it has more
  /// than operators and plain values.
  std::string bracketed() const {
    std::string made;
    if (!plain_ || opened_.empty()) return made;
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
  void pass(const OperatorRow& of) {
    at_ += of.spelling.size();
    while (&of == &kBySigns && is_sign_of_comparison()) ++at_;
  }
  Part apply(const OperatorRow& of, std::uint32_t /*at*/, const Part& left, const Part& right) {
    const bool after_or = left.of != nullptr && left.of->is_logic() && !left.of->is_conjunction();
    found_.and_after_or = found_.and_after_or || (of.is_conjunction() && after_or);
    hold(left, of);
    hold(right, of);
    return {left.from, right.to, &of};
  }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  /// Pass over blanks and comments.
  void blanks() {
    for (; at_ < text_.size() && (is_blank(here()) || begins_comment()); ++at_)
      if (begins_comment()) at_ = std::min(text_.find(')', at_), text_.size() - 1);
  }
  bool begins_comment() const { return here() == '(' && open_ != '('; }
  bool is_sign_of_comparison() const { return here() == '<' || here() == '>' || here() == '='; }
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
  bool plain_ = true;  // operators and plain values are all that was read
  WrittenLogic found_;
  int depth_ = 0;
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
  if (is_sign_of_comparison()) {
    plain_ = false;
    return &kBySigns;
  }
  if (rest.empty())
    at_ = text_.size();
  else if (here() != close_ && here() != ',')
    at_ = before;
  return nullptr;
}

/// Read what stands in brackets, between commas, and look for missing brackets in it too.
bool Bracketing::bracket() {
  if (++depth_ > kDeepest) return false;
  do {
    ++at_;
    if (!read_operators(*this)) return false;
  } while (here() == ',');
  --depth_;
  if (here() != close_) return false;
  ++at_;
  return true;
}

/// Read a value as it is written: a number, a variable, a function, brackets.
Part Bracketing::operand() {
  blanks();
  const std::size_t from = at_;
  while (here() == '+' || here() == '-' || here() == '#') ++at_;
  if (here() == '<') {  // the name of a variable
    at_ = std::min(text_.find('>', at_), text_.size() - 1) + 1;
    return {from, at_};
  }
  const std::string_view name = letters();
  // The slash after its brackets may be its own.
  plain_ = plain_ && !std::equal(name.begin(), name.end(), spelling_.slash_function.begin(),
                                 spelling_.slash_function.end(),
                                 [](char a, char b) { return upper(a) == b; });
  at_ += name.size();
  const std::size_t digits = at_;
  while (is_digit(here()) || here() == '.') ++at_;
  if (at_ > digits && name.empty()) return {from, at_};
  if (here() == open_) return bracket() ? Part{from, at_} : Part{};
  if (name.empty() || at_ > digits) return {};
  plain_ = false;  // a constant, or a word before its condition
  const std::size_t end = at_;
  blanks();
  if (here() != '#' && here() != open_ && !is_digit(here())) return {from, end};
  const Part value = operand();
  return value ? Part{from, at_} : Part{};
}

void Bracketing::hold(const Part& part, const OperatorRow& by) {
  if (part.of == nullptr || part.of == &kBySigns || &by == &kBySigns) return;
  const bool other = part.of->is_logic() != by.is_logic();
  const bool other_logic = apart_ && by.is_logic() && part.of->is_logic() && part.of->op != by.op;
  found_.beside_other = found_.beside_other || other;
  if (!other && !other_logic) return;
  opened_.push_back(part.from);
  closed_.push_back(part.to);
}

}  // namespace

WrittenLogic read_logic(std::string_view written, const Spelling& spelling, LogicOrder order,
                        bool apart, int most) {
  Bracketing reader(written, spelling, order, apart);
  if (!reader.read()) return {};
  WrittenLogic found = reader.found();
  found.bracketed = reader.bracketed();
  int depth = 0, deepest = 0;
  for (const char c : found.bracketed) {
    depth += c == spelling.brackets.before[0] ? 1 : c == spelling.brackets.behind[0] ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  if (deepest > most) found.bracketed.clear();
  return found;
}

}  // namespace cncsub
