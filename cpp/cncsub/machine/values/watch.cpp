#include "cncsub/machine/values/watch.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "cncsub/machine/values/variables.hpp"

namespace cncsub {

namespace {

constexpr std::int32_t kNotWatched = -1, kSeveral = -2;  // several numbers name one common

double value_now(const Run& run, const VariablePlace& place, std::int32_t number) {
  const State& s = run.state;
  if (place.is_local()) return s.locals[run.local_at(s.level, place.index)];
  if (place.is_common()) return s.commons[static_cast<std::size_t>(place.index)];
  double value = kVacant;
  read_variable(run, number, s.level, value);
  return value;
}

/// Return whether a system variable stays as it is while blocks only move and assign locals and
/// commons.
bool is_still(VariableKind kind) {
  switch (kind) {
    case VariableKind::Input:
    case VariableKind::InputWord:
    case VariableKind::Output:
    case VariableKind::OutputWord:
    case VariableKind::Control1:
    case VariableKind::Settings:
    case VariableKind::Mirror:
    case VariableKind::Restart:
    case VariableKind::Date:
    case VariableKind::Time:
    case VariableKind::PartsCount:
    case VariableKind::WorkOffset:
    case VariableKind::AxisWorkOffset:
    case VariableKind::ExtraWorkOffset:
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
    case VariableKind::EdgeDatum:
    case VariableKind::ToolName:
    case VariableKind::ParameterChoice:
    case VariableKind::ParameterValue:
      return true;
    default:
      return false;
  }
}

const double* memory_of(const Run& run, const Watched::Range& range) {
  return range.local ? run.state.locals.data() + run.local_at(run.state.level, 0) + range.first
                     : run.state.commons.data() + range.first;
}

void list_place(Watched& watched, std::uint32_t number) {
  const VariablePlace& place = watched.places[number];
  std::vector<std::int32_t>& list = place.is_local() ? watched.locals : watched.commons;
  const auto index = static_cast<std::size_t>(place.index);
  if (list.size() <= index) list.resize(index + 1, kNotWatched);
  list[index] = list[index] == kNotWatched ? static_cast<std::int32_t>(number) : kSeveral;
}

/// Lay out locals and commons, side by side where they lie so.
void lay_out(Watched& watched, std::vector<std::uint32_t> numbers) {
  const auto order = [&](std::uint32_t number) {
    const VariablePlace& place = watched.places[number];
    return std::pair(place.is_local(), static_cast<std::size_t>(place.index));
  };
  std::sort(numbers.begin(), numbers.end(),
            [&](std::uint32_t a, std::uint32_t b) { return order(a) < order(b); });
  std::size_t seen = 0;
  for (const std::uint32_t number : numbers) {
    const auto [local, index] = order(number);
    Watched::Range* const last = watched.ranges.empty() ? nullptr : &watched.ranges.back();
    const bool here = last != nullptr && last->local == local;
    if (here && index < last->first + last->count) {
      watched.seen_at[number] = static_cast<std::uint32_t>(seen - 1);
      continue;
    }
    if (here && index == last->first + last->count)
      ++last->count;
    else
      watched.ranges.push_back({local, index, 1, seen});
    watched.seen_at[number] = static_cast<std::uint32_t>(seen++);
  }
  watched.seen.resize(seen);
}

void see_ranges(Run& run) {
  for (const Watched::Range& range : run.watched.ranges)
    std::copy_n(memory_of(run, range), range.count, run.watched.seen.data() + range.seen);
}

bool ranges_changed(const Run& run) {
  const auto changed = [&](const Watched::Range& range) {
    return std::memcmp(memory_of(run, range), run.watched.seen.data() + range.seen,
                       range.count * sizeof(double)) != 0;
  };
  return std::any_of(run.watched.ranges.begin(), run.watched.ranges.end(), changed);
}

void note(Run& run, std::uint32_t number, std::int64_t step, Address at) {
  Trace::Watched& variable = run.trace.watched[number];
  const double value = value_now(run, run.watched.places[number], variable.number);
  if (value == variable.now || (is_vacant(value) && is_vacant(variable.now))) return;
  run.trace.changes.push({step, value, variable.number, at});
  variable.now = value;
}

void note_all(Run& run, std::int64_t step, Address at) {
  const auto count = static_cast<std::uint32_t>(run.watched.places.size());
  for (std::uint32_t number = 0; number < count; ++number) note(run, number, step, at);
  see_ranges(run);
}

/// Note the one variable that a step wrote.
void note_one(Run& run, std::int64_t step, Address at, const Reach& reach) {
  Watched& watched = run.watched;
  const std::vector<std::int32_t>& list = reach.local ? watched.locals : watched.commons;
  const auto index = static_cast<std::size_t>(reach.index);
  const std::int32_t found = index < list.size() ? list[index] : kNotWatched;
  if (found == kSeveral || (found >= 0 && !watched.moving.empty())) return note_all(run, step, at);
  if (found >= 0) {
    const auto number = static_cast<std::uint32_t>(found);
    note(run, number, step, at);
    watched.seen[watched.seen_at[number]] =
        value_now(run, watched.places[number], run.trace.watched[number].number);
  } else {
    for (const std::uint32_t number : watched.moving) note(run, number, step, at);
  }
}

}  // namespace

Reach reach_of(const Run& run, const Block& block) {
  if (!run.state.modals.empty()) return {};
  if (block.op == Op::Linear || block.op == Op::Arc) return {Reach::Kind::None};
  if (block.op != Op::Set && block.op != Op::Assign) return {};
  const Statement statement = assignment_of(*run.code, block);
  const bool local = statement.target == Statement::Target::Local;
  if (!local && statement.target != Statement::Target::Common) return {};
  return {Reach::Kind::One, local, statement.index};
}

void begin_watching(Run& run) {
  Watched& watched = run.watched;
  std::vector<std::uint32_t> own;
  for (const std::int32_t number : run.options.watch) {
    const VariablePlace place = run.code->place(number);
    const double value = value_now(run, place, number);
    const auto at = static_cast<std::uint32_t>(watched.places.size());
    watched.places.push_back(place);
    run.trace.watched.push_back({number, value, value});
    if (place.is_local() || place.is_common()) {
      list_place(watched, at);
      own.push_back(at);
    } else {
      watched.system.push_back(at);
      if (!is_still(place.kind)) watched.moving.push_back(at);
    }
  }
  watched.seen_at.resize(watched.places.size());
  lay_out(watched, std::move(own));
  see_ranges(run);
}

void note_changes(Run& run, std::int64_t step, Address at, const Reach& reach) {
  const Watched& watched = run.watched;
  if (watched.empty()) return;
  if (reach.kind == Reach::Kind::One) return note_one(run, step, at, reach);
  if (reach.kind == Reach::Kind::Any && ranges_changed(run)) return note_all(run, step, at);
  for (const std::uint32_t number :
       reach.kind == Reach::Kind::Any ? watched.system : watched.moving)
    note(run, number, step, at);
}

}  // namespace cncsub
