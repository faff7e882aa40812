// The C face over the record of a run, over changed controls and over comparisons.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "c_inside.hpp"

using namespace cncsub::c_face;  // NOLINT(google-build-using-namespace)

struct cncsub_comparison {
  nc::Comparison comparison;
};

namespace {

/// Read the lines `name=value` of a text. A line without = is a name without a value.
std::map<std::string, std::string> changes_of(std::string_view text) {
  const auto trimmed = [](std::string_view word) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t first = std::min(word.find_first_not_of(kBlanks), word.size());
    return std::string(word.substr(first, word.find_last_not_of(kBlanks) + 1 - first));
  };
  std::map<std::string, std::string> changes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = line.find('=');
    std::string name = trimmed(line.substr(0, equals));
    if (name.empty()) continue;
    changes[std::move(name)] = equals == line.npos ? "" : trimmed(line.substr(equals + 1));
  }
  return changes;
}

template <class Value>
void copy(const std::vector<Value>& from, Value* to) {
  if (to != nullptr) std::copy(from.begin(), from.end(), to);
}

}  // namespace

cncsub_library* cncsub_library_for(const cncsub_library* library, const char* control,
                                   const char* changes) {
  if (missing(library, control)) return nullptr;
  return guarded<cncsub_library*>(nullptr, [&]() -> cncsub_library* {
    auto again = library->library.read_for(control, changes_of(text_of(changes)));
    if (!again) return refused<cncsub_library*>(again.error().message, nullptr);
    return new cncsub_library{*again, again->programs(), {}};
  });
}

size_t cncsub_run_steps(const cncsub_run* run) { return missing(run) ? 0 : run->run.steps(); }

int32_t cncsub_run_step(cncsub_run* run, size_t index, cncsub_step* to) {
  if (missing(run, to)) return 0;
  return guarded<int32_t>(0, [&] {
    if (index >= run->run.steps()) return 0;
    run->step = run->run.step(index);
    *to = {place_of(run->step.at), run->step.text.c_str(), run->step.depth,
           run->step.skipped ? 1 : 0};
    return 1;
  });
}

size_t cncsub_run_calls(const cncsub_run* run) { return missing(run) ? 0 : run->run.calls(); }

int32_t cncsub_run_call(cncsub_run* run, size_t index, cncsub_call_made* to) {
  if (missing(run, to)) return 0;
  return guarded<int32_t>(0, [&] {
    if (index >= run->run.calls()) return 0;
    run->call = run->run.call(index);
    const nc::CallMade& call = run->call;
    *to = {call.kind.c_str(), call.called.c_str(), call.parent,     call.start_n,
           call.repeats,      call.caller_step,    call.first_step, call.last_step};
    return 1;
  });
}

size_t cncsub_run_path(cncsub_run* run, double tolerance) {
  if (missing(run)) return 0;
  return guarded<size_t>(0, [&] {
    run->path = run->run.path(tolerance);
    return run->path.x.size();
  });
}

int32_t cncsub_run_write_path(const cncsub_run* run, double* x, double* y, double* z,
                              uint32_t* move, uint8_t* begins) {
  if (missing(run)) return 0;
  copy(run->path.x, x);
  copy(run->path.y, y);
  copy(run->path.z, z);
  copy(run->path.move, move);
  copy(run->path.begins, begins);
  return 1;
}

size_t cncsub_run_variables(cncsub_run* run) {
  if (missing(run)) return 0;
  return guarded<size_t>(0, [&] {
    run->variables = run->run.variables();
    return run->variables.size();
  });
}

int32_t cncsub_run_variable_at(const cncsub_run* run, size_t index, cncsub_variable* to) {
  if (missing(run, to)) return 0;
  if (index >= run->variables.size()) return 0;
  const nc::Variable& of = run->variables[index];
  *to = {of.number, of.name.c_str(), of.value.value_or(kNone), of.text.c_str()};
  return 1;
}

const char* cncsub_run_message(cncsub_run* run, size_t index) {
  if (missing(run)) return nullptr;
  return guarded<const char*>(nullptr, [&] {
    if (run->messages.empty()) run->messages = run->run.messages();
    return index < run->messages.size() ? run->messages[index].c_str() : nullptr;
  });
}

const char* cncsub_run_waiting_for(cncsub_run* run) {
  if (missing(run)) return "";
  return guarded<const char*>("", [&] {
    run->waiting = run->run.waiting_for();
    return run->waiting.c_str();
  });
}

double cncsub_run_length(const cncsub_run* run) { return missing(run) ? 0 : run->run.length(); }
double cncsub_run_time(const cncsub_run* run) { return missing(run) ? 0 : run->run.time(); }

cncsub_comparison* cncsub_compare(const cncsub_library* first, const cncsub_library* second,
                                  const cncsub_options* options) {
  if (missing(first, second)) return nullptr;
  return guarded<cncsub_comparison*>(nullptr, [&]() -> cncsub_comparison* {
    auto compared = nc::compare(first->library, second->library, options_of(options));
    if (!compared) return refused<cncsub_comparison*>(compared.error().message, nullptr);
    return new cncsub_comparison{std::move(*compared)};
  });
}
void cncsub_comparison_free(cncsub_comparison* comparison) { delete comparison; }

const char* cncsub_comparison_what(const cncsub_comparison* comparison) {
  return missing(comparison) ? "" : comparison->comparison.what.c_str();
}

int64_t cncsub_comparison_step(const cncsub_comparison* comparison, int32_t side) {
  if (missing(comparison) || side < 0 || side > 1) return -1;
  return comparison->comparison.step[static_cast<size_t>(side)];
}

int32_t cncsub_comparison_rule(const cncsub_comparison* comparison, size_t index, cncsub_rule* to) {
  if (missing(comparison, to)) return 0;
  if (index >= comparison->comparison.rules.size()) return 0;
  const nc::RuleApart& of = comparison->comparison.rules[index];
  *to = {of.name.c_str(),
         of.meaning.c_str(),
         {of.values[0].c_str(), of.values[1].c_str()},
         {of.examples[0].c_str(), of.examples[1].c_str()}};
  return 1;
}

cncsub_run* cncsub_comparison_run(const cncsub_comparison* comparison, int32_t side) {
  if (missing(comparison) || side < 0 || side > 1) return nullptr;
  return guarded<cncsub_run*>(nullptr, [&] {
    const nc::Run& run = comparison->comparison.runs[static_cast<size_t>(side)];
    return new cncsub_run{run, run.alarm()};
  });
}
