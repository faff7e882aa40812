#include "cncsub/machine/values/texts.hpp"

#include "cncsub/machine/state/limits.hpp"

namespace cncsub {

const std::string& text_of(const Run& run, double value) {
  static const std::string nothing;
  const Texts& of_code = run.code->texts;
  const Texts& of_run = run.state.texts;
  if (!(value >= 0)) return nothing;  // nor is a vacant value one
  const auto number = to_whole<std::size_t>(value);
  if (number < of_code.size()) return of_code.at(number);
  return number - of_code.size() < of_run.size() ? of_run.at(number - of_code.size()) : nothing;
}

double keep_text(Run& run, std::string text) {
  constexpr std::size_t kMany = 4096;
  text.resize(std::min(text.size(), text.find('\0')));
  if (text.empty()) return 0;
  const Texts& of_code = run.code->texts;
  if (const auto found = of_code.find(text)) return *found;
  Texts& of_run = run.state.texts;
  const std::size_t number = of_run.number_of(text);
  if (of_run.size() % kMany == 0) look_soon(run);
  return static_cast<double>(of_code.size() + number);
}

}  // namespace cncsub
