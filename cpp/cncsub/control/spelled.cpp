#include "cncsub/control/spelled.hpp"

#include <algorithm>
#include <vector>

namespace cncsub {

namespace {

constexpr int kUsualEnd = 30;

/// Return the codes of a role, in the order of their numbers.
std::vector<std::string> codes_of(const Control& control, Role role) {
  std::vector<std::string> codes;
  for (const Roles::Entry& entry : control.calls.roles.value.entries())
    if (entry.role == role) codes.push_back(entry.code.text());
  return codes;
}

std::string either(const std::vector<std::string>& of) {
  std::string text;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (i > 0) text += i + 1 == of.size() ? " or " : ", ";
    text += of[i];
  }
  return text;
}

std::string end_of_main(const Control& control) {
  if (control.calls.roles.value.of_m(kUsualEnd) == Role::End)
    return "M" + std::to_string(kUsualEnd);
  return either(codes_of(control, Role::End));
}

std::string ends_and_returns(const Control& control) {
  std::vector<std::string> all = codes_of(control, Role::End);
  const std::vector<std::string> returns = codes_of(control, Role::Return);
  all.insert(all.end(), returns.begin(), returns.end());
  return either(all);
}

/// Return whether a program can ask for a vacant value by #0.
bool has_vacant(const Control& control) {
  const auto& ranges = control.variables;
  return std::any_of(ranges.begin(), ranges.end(),
                     [](const VariableRange& range) { return range.kind == VariableKind::Vacant; });
}

std::string word_for(std::string_view name, const Control& control) {
  if (name == "end") return end_of_main(control);
  if (name == "return") {
    const std::string codes = either(codes_of(control, Role::Return));
    return codes.empty() ? "a return" : codes;  // one that is no code
  }
  if (name == "end-or-return") return ends_and_returns(control);
  if (name == "macro-call") return either(codes_of(control, Role::MacroCall));
  if (name == "or-vacant") return has_vacant(control) ? ", or compare it with #0 first" : "";
  return "{" + std::string(name) + "}";
}

}  // namespace

std::string spelled(std::string_view text, const Control& control) {
  std::string written;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    const std::size_t close = text.find('}', open);
    written += text.substr(0, open);
    if (close == std::string_view::npos) return written.append(text.substr(open));
    written += word_for(text.substr(open + 1, close - open - 1), control);
    text.remove_prefix(close + 1);
  }
  return written;
}

std::string return_code(const Control& control) {
  const auto code = control.calls.roles.value.code_of(Role::Return);
  return code ? code->text() : "";
}

}  // namespace cncsub
