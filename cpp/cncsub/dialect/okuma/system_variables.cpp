#include "cncsub/dialect/okuma/system_variables.hpp"

namespace cncsub::okuma {

namespace {

// The numbers stand in controls/okuma too, which says what the variables hold. [OKA 2203, 2214,
// 2229; OKM, the rotation and the tool change]
constexpr SystemVariable kVariables[] = {
    {"VDIN", 1'000'001, 1, true, false},  {"VDOUT", 1'100'001, 1, false, true},
    {"VZOFX", 2'000'000, 20, true, true}, {"VZOFY", 2'000'001, 20, true, true},
    {"VZOFZ", 2'000'002, 20, true, true}, {"VZOFA", 2'000'003, 20, true, true},
    {"VZOFB", 2'000'004, 20, true, true}, {"VZOFC", 2'000'005, 20, true, true},
    {"VTOFH", 3'000'001, 1, true, true},  {"VTOFD", 3'100'001, 1, true, true},
    {"VTLCN", 4'000'000, 0, true, false},
};

}  // namespace

const SystemVariable* find_system_variable(std::string_view name) {
  for (const SystemVariable& of : kVariables)
    if (of.name == name) return &of;
  return nullptr;
}

std::string name_of_variable(const Control& /*control*/, std::int64_t number) {
  if (number > kCommonsC && number <= std::int64_t{2} * kCommonsC)
    return "VC" + std::to_string(number - kCommonsC);
  constexpr std::int64_t kApart = 100'000;  // from the variables of one name to those of the next
  for (const SystemVariable& of : kVariables) {
    const std::int64_t behind = number - of.first;
    if (behind < 0 || behind >= kApart) continue;
    if (of.step == 0 && behind == 0) return std::string(of.name);
    if (of.step > 0 && behind % of.step == 0)
      return std::string(of.name) + "[" + std::to_string(behind / of.step + 1) + "]";
  }
  return "";
}

}  // namespace cncsub::okuma
