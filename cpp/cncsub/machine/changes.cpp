#include "cncsub/machine/changes.hpp"

#include "cncsub/machine/variables.hpp"

namespace cncsub {

namespace {

double value_now(const Run& run, const VariablePlace& place, std::int32_t number) {
  const State& s = run.state;
  if (place.is_local()) return s.locals[run.local_at(s.level, place.index)];
  if (place.is_common()) return s.commons[static_cast<std::size_t>(place.index)];
  double value = kVacant;
  read_variable(run, number, s.level, value);
  return value;
}

}  // namespace

void begin_watching(Run& run) {
  for (const std::int32_t number : run.options.watch) {
    const VariablePlace place = run.code->place(number);
    const double value = value_now(run, place, number);
    run.watched.push_back(place);
    run.trace.watched.push_back({number, value, value});
  }
}

void note_changes(Run& run, std::int64_t step, Address at) {
  for (std::size_t i = 0; i < run.watched.size(); ++i) {
    Trace::Watched& variable = run.trace.watched[i];
    const double value = value_now(run, run.watched[i], variable.number);
    if (value == variable.now || (is_vacant(value) && is_vacant(variable.now))) continue;
    run.trace.changes.push({step, value, variable.number, at});
    variable.now = value;
  }
}

}  // namespace cncsub
