#include "cncsub/analysis/brackets.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

struct Operator {
  std::string name;
  int level = -1;  // no operator
  bool logic = false;
};

struct Part {
  std::string text;
  Operator of;  // what joins it, none of a value
};

class Bracketing {
 public:
  Bracketing(std::string_view written, const Binding& binding, bool apart)
      : text_(written), binding_(binding), apart_(apart) {}

  std::optional<std::string> whole() {
    std::optional<Part> part = joined(0);
    blanks();
    if (!part || at_ != text_.size()) return std::nullopt;
    return std::move(part->text);
  }

 private:
  void blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  std::string name_here() const;
  Operator operator_here() const;
  std::optional<Part> joined(int least);
  std::optional<std::string> value();
  bool bracket(std::string& to);
  std::string held(const Part& part, const Operator& by) const;

  std::string_view text_;
  const Binding& binding_;
  bool apart_;
  std::size_t at_ = 0;
};

std::string Bracketing::name_here() const {
  std::string name;
  for (std::size_t i = at_; i < text_.size() && is_letter(text_[i]); ++i) name += upper(text_[i]);
  return name;
}

Operator Bracketing::operator_here() const {
  if (at_ >= text_.size()) return {};
  const char c = text_[at_];
  if (c == '+' || c == '-') return {std::string(1, c), binding_.sum};
  if (c == '/' || (c == '*' && text_.substr(at_, 2) != "**"))
    return {std::string(1, c), binding_.product};
  const std::string name = name_here();
  if (name == "AND") return {name, binding_.conjunction, true};
  if (name == "OR" || name == "XOR") return {name, binding_.disjunction, true};
  if (name == "MOD") return {name, binding_.product};
  for (const std::string_view of : {"EQ", "NE", "GT", "LT", "GE", "LE"})
    if (name == of) return {name, binding_.comparison};
  return {};
}

/// What stands in brackets, rewritten too.
bool Bracketing::bracket(std::string& to) {
  int depth = 0;
  std::size_t end = at_;
  for (; end < text_.size(); ++end) {
    depth += text_[end] == '[' ? 1 : text_[end] == ']' ? -1 : 0;
    if (depth == 0) break;
  }
  if (end == text_.size()) return false;
  const auto inside = Bracketing(text_.substr(at_ + 1, end - at_ - 1), binding_, apart_).whole();
  if (!inside) return false;
  to += "[" + *inside + "]";
  at_ = end + 1;
  return true;
}

/// A value as it is written: a number, a variable, a function, brackets.
std::optional<std::string> Bracketing::value() {
  std::string value;
  for (blanks(); at_ < text_.size(); ++at_) {  // signs and #
    if (std::string_view("+-#").find(text_[at_]) == std::string_view::npos) break;
    value += text_[at_];
  }
  const std::string name = name_here();
  if (name == "ATAN") return std::nullopt;  // the / behind its bracket may be its own
  value += text_.substr(at_, name.size());
  at_ += name.size();
  const std::size_t digits = value.size();
  for (; at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.'); ++at_)
    value += text_[at_];
  if (value.size() > digits && name.empty()) return value;
  if (at_ == text_.size() || text_[at_] != '[' || !bracket(value)) return std::nullopt;
  return value;
}

std::string Bracketing::held(const Part& part, const Operator& by) const {
  if (part.of.level < 0) return part.text;
  const bool other = part.of.logic != by.logic;
  const bool other_logic = apart_ && by.logic && part.of.logic && part.of.name != by.name;
  return other || other_logic ? "[" + part.text + "]" : part.text;
}

std::optional<Part> Bracketing::joined(int least) {
  std::optional<std::string> first = value();
  if (!first) return std::nullopt;
  Part left{std::move(*first), {}};
  for (;;) {
    const std::size_t before = at_;
    blanks();
    const std::string space(text_.substr(before, at_ - before));
    Operator by = operator_here();
    if (by.level < least) {
      at_ = before;
      return left;
    }
    const std::string_view written = text_.substr(at_, by.name.size());
    at_ += by.name.size();
    const std::size_t behind = at_;
    blanks();
    const std::string more(text_.substr(behind, at_ - behind));
    const std::optional<Part> right = joined(by.level + 1);
    if (!right) return std::nullopt;
    left.text = held(left, by);
    left.text += space;
    left.text += written;
    left.text += more;
    left.text += held(*right, by);
    left.of = std::move(by);
  }
}

}  // namespace

std::optional<std::string> with_brackets(std::string_view written, const Binding& binding,
                                         bool apart, int most) {
  std::optional<std::string> made = Bracketing(written, binding, apart).whole();
  if (!made || *made == written) return std::nullopt;
  int depth = 0, deepest = 0;
  for (const char c : *made) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest <= most ? made : std::nullopt;
}

}  // namespace cncsub
