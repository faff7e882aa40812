// The layout of the variables of a state, and a state that goes on with a library that has more of
// them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cncsub/code/code.hpp"
#include "cncsub/machine/state/state.hpp"

namespace cncsub {

/// How many variables a library has, as a state holds them.
struct VariableLayout {
  std::int32_t locals = 0, elements = 0;  // of one level
  std::int32_t commons = 0;
  std::size_t texts = 0;  // of the code: those of the run are numbered after them

  bool operator==(const VariableLayout&) const = default;
};

inline VariableLayout variable_layout(const Code& code) {
  return {code.locals, code.elements, code.commons, code.texts.size()};
}

/// Lay the variables of a state out anew, for a library that has more of them at the ends of its
/// tables. The texts that the run had made stand among those of the library, in the same order.
void fit(State& state, const VariableLayout& before, const Code& code);

}  // namespace cncsub
