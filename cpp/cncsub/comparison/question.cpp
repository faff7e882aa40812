#include "cncsub/comparison/question.hpp"

#include <array>
#include <utility>

namespace cncsub {

std::optional<Question> question_named(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Question>, 6> kAll = {{
      {"versions", Question::Versions},
      {"controls", Question::Controls},
      {"rewritten", Question::Rewritten},
      {"translated", Question::Translated},
      {"flat", Question::Flat},
      {"edited", Question::Edited},
  }};
  for (const auto& [known, question] : kAll)
    if (known == name) return question;
  return std::nullopt;
}

Asked asked(Question question, bool one_language) {
  switch (question) {
    case Question::Versions:
      return {.variables = true,
              .calls = true,
              .starts = true,
              .levels = true,
              .alarm = AlarmPart::Program};
    case Question::Controls:
      return {.two_controls = true,
              .times = Times::Dwells,
              .variables = true,
              .calls = one_language,
              .starts = true,
              .places = true,
              .steps = one_language,
              .alarm = AlarmPart::Line};
    case Question::Rewritten:
      return {.two_controls = true, .times = Times::Dwells};
    case Question::Translated:
      return {.two_controls = true, .times = Times::Dwells, .variables = true};
    case Question::Flat:
      return {.times = Times::Moves, .alarm = AlarmPart::Number};
    case Question::Edited:
      return {.variables = true, .calls = true, .levels = true, .alarm = AlarmPart::Edited};
  }
  return {};
}

}  // namespace cncsub
