#include "cncsub/machine/values/named_variables.hpp"

#include <utility>

namespace cncsub {

namespace {

/// Return the program that opened a level of locals.
const Program& program_of(const Run& run, int level) {
  const std::vector<OpenFrame>& frames = run.state.frames;
  std::size_t at = 0;
  for (std::size_t i = 1; i < frames.size() && level > 0; ++i)
    if (frames[i].own_locals) --level, at = i;
  return run.code->programs[static_cast<std::size_t>(frames[at].program)];
}

/// Return where the values lie of what a parameter stands for; null where that is not known.
const double* values_referenced(const Run& run, const DefinedVariable& of, int level,
                                std::vector<std::int32_t>& extents) {
  const State& s = run.state;
  const double* const local = s.locals.data() + run.local_at(level, of.reference);
  if (is_vacant(*local)) return nullptr;
  for (std::size_t i = 0; i < extents.size(); ++i)
    extents[i] = to_whole<std::int32_t>(local[2 + i]);
  const auto last = extents.empty() ? 0 : to_whole<std::size_t>(local[1]) - 1;
  const Reference first = Reference::of(*local);
  return s.cell(first.behind(last)) == nullptr ? nullptr : s.cell(first);
}

/// Return where the values of a variable lie.
const double* values_of(const Run& run, const DefinedVariable& of, int level,
                        std::vector<std::int32_t>& extents) {
  const State& s = run.state;
  extents = of.extents;
  if (of.reference >= 0) {
    const double* const found = values_referenced(run, of, level, extents);
    if (found != nullptr || !extents.empty()) return found;
  }
  const auto index = static_cast<std::size_t>(of.index);
  if (of.common) return s.commons.data() + index;
  if (of.extents.empty()) return s.locals.data() + run.local_at(level, of.index);
  const auto each = static_cast<std::size_t>(run.code->elements);
  return s.elements.data() + static_cast<std::size_t>(level) * each + index;
}

}  // namespace

std::vector<NamedValues> named_variables(const Run& run, int level) {
  std::vector<NamedValues> named;
  const Program& program = program_of(run, level);
  for (std::uint32_t i = 0; i < program.defined; ++i) {
    const DefinedVariable& of = run.code->defined_variables[program.first_defined + i];
    std::vector<std::int32_t> extents;
    const double* const values = values_of(run, of, level, extents);
    if (values != nullptr && (!extents.empty() || !is_vacant(*values)))
      named.push_back({&of, values, std::move(extents)});
  }
  for (const DefinedVariable& of : run.code->shared_variables) {
    std::vector<std::int32_t> extents;
    const double* const values = values_of(run, of, level, extents);
    named.push_back({&of, values, std::move(extents)});
  }
  return named;
}

std::optional<NamedValues> named_variable(const Run& run, int level, const std::string& name) {
  for (const NamedValues& of : named_variables(run, level))
    if (of.variable->name == name) return of;
  return std::nullopt;
}

}  // namespace cncsub
