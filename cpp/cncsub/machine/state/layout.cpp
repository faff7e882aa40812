#include "cncsub/machine/state/layout.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cncsub {

namespace {

/// Lay the levels of a table out with more cells each.
template <class T>
void widen(std::vector<T>& table, std::int32_t before, std::int32_t after, T value) {
  if (before == after || table.empty()) return;
  const auto from = static_cast<std::size_t>(before), to = static_cast<std::size_t>(after);
  const std::size_t levels = from == 0 ? 1 : table.size() / from;
  std::vector<T> wide(levels * to, value);
  for (std::size_t level = 0; level < levels; ++level)
    std::copy_n(table.data() + level * from, from, wide.data() + level * to);
  table = std::move(wide);
}

}  // namespace

void fit(State& state, const VariableLayout& before, const Code& code) {
  const VariableLayout after = variable_layout(code);
  if (after == before) return;
  widen(state.locals, before.locals, after.locals, kVacant);
  widen(state.programmed, before.locals, after.locals, std::uint8_t{0});
  for (ModalCall& modal : state.modals) widen(modal.locals, before.locals, after.locals, kVacant);
  for (WaitingBlock& waiting : state.waiting) {
    widen(waiting.arguments, before.locals, after.locals, kVacant);
    widen(waiting.programmed, before.locals, after.locals, std::uint8_t{0});
  }
  const auto levels = static_cast<std::size_t>(state.level) + 1;
  if (before.elements == 0)
    state.elements.assign(levels * static_cast<std::size_t>(after.elements), 0);
  else
    widen(state.elements, before.elements, after.elements, 0.0);
  state.commons.resize(static_cast<std::size_t>(after.commons), kVacant);
  for (const auto& [common, value] : code.first_values)
    if (common >= before.commons) state.commons[static_cast<std::size_t>(common)] = value;
  if (after.texts != before.texts) state.texts = {};
}

}  // namespace cncsub
