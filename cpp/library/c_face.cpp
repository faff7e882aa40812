// The C face over the C++ library: libraries, options, runs and machines.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "c_inside.hpp"

using namespace cncsub::c_face;  // NOLINT(google-build-using-namespace)

namespace {

/// Set an option that is a number; return false where there is none of this name.
bool set_number(nc::Options& options, const std::string& name, double value) {
  const auto whole = static_cast<std::int64_t>(std::fmax(std::fmin(value, 9e15), -9e15));
  if (name == "start")
    options.start = whole;
  else if (name == "max_blocks")
    options.max_blocks = whole;
  else if (name == "max_cycles")
    options.max_cycles = whole;
  else if (name == "max_seconds")
    options.max_seconds = value;
  else if (name == "optional_stop")
    options.optional_stop = value != 0;
  else if (name == "block_skip")
    options.block_skip.push_back(static_cast<int>(std::fmax(std::fmin(value, 99.0), 0.0)));
  else if (name == "record" && whole >= 0 && whole <= 3)
    options.record = static_cast<nc::Record>(whole);
  else
    return false;
  return true;
}

}  // namespace

const char* cncsub_version() { return nc::version().data(); }
int32_t cncsub_abi() { return CNCSUB_ABI; }
const char* cncsub_error() { return last_error().c_str(); }

namespace {

const std::vector<nc::Control>& all_controls() {
  static const std::vector<nc::Control> all = nc::controls();
  return all;
}

const char* told_of_control(size_t index, const std::string nc::Control::* of) {
  return guarded<const char*>(nullptr, [&]() -> const char* {
    return index < all_controls().size() ? (all_controls()[index].*of).c_str() : nullptr;
  });
}

/// Return the value of a variable; NaN, with no error, where it is vacant.
double value_or_none(const nc::Result<std::optional<double>>& value) {
  if (!value) return refused(value.error().message, kNone);
  last_error().clear();
  return value->value_or(kNone);
}

}  // namespace

const char* cncsub_control(size_t index) { return told_of_control(index, &nc::Control::name); }
const char* cncsub_control_title(size_t index) {
  return told_of_control(index, &nc::Control::title);
}

cncsub_library* cncsub_library_new(const char* control, size_t count, const char* const* names,
                                   const char* const* texts, const size_t* sizes) {
  if (missing(control) || (count > 0 && missing(names, texts, sizes))) return nullptr;
  return guarded<cncsub_library*>(nullptr, [&]() -> cncsub_library* {
    std::vector<nc::Source> sources;
    for (size_t i = 0; i < count; ++i)
      if (texts[i] == nullptr) return refused<cncsub_library*>("a text is NULL", nullptr);
    for (size_t i = 0; i < count; ++i)
      sources.push_back({text_of(names[i]), std::string(texts[i], sizes[i])});
    auto library = nc::Library::read(std::move(sources), text_of(control));
    if (!library) return refused<cncsub_library*>(library.error().message, nullptr);
    return new cncsub_library{*library, library->programs(), {}};
  });
}
void cncsub_library_free(cncsub_library* library) { delete library; }

const char* cncsub_library_program(const cncsub_library* library, size_t index) {
  if (missing(library)) return nullptr;
  return index < library->programs.size() ? library->programs[index].c_str() : nullptr;
}

size_t cncsub_library_check(cncsub_library* library) {
  if (missing(library)) return 0;
  return guarded<size_t>(0, [&] {
    library->findings = library->library.check();
    return library->findings.size();
  });
}

int32_t cncsub_library_finding(const cncsub_library* library, size_t index, cncsub_finding* to) {
  if (missing(library, to)) return 0;
  if (index >= library->findings.size()) return 0;
  const nc::Finding& from = library->findings[index];
  *to = {from.rule.c_str(), from.severity.c_str(), from.message.c_str(), place_of(from.at),
         from.column};
  return 1;
}

const char* cncsub_library_hint(const cncsub_library* library, size_t index) {
  if (missing(library)) return nullptr;
  return index < library->findings.size() ? library->findings[index].hint.c_str() : nullptr;
}

cncsub_options* cncsub_options_new() {
  return guarded<cncsub_options*>(nullptr, [] { return new cncsub_options; });
}
void cncsub_options_free(cncsub_options* options) { delete options; }

int32_t cncsub_options_text(cncsub_options* options, const char* name, const char* value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    const std::string option = text_of(name);
    if (option == "main")
      options->options.main = text_of(value);
    else if (option == "machine")
      options->options.setup.machine = text_of(value);
    else
      return refused("there is no option " + option + " that takes a text", 0);
    return 1;
  });
}

int32_t cncsub_options_number(cncsub_options* options, const char* name, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    const std::string option = text_of(name);
    if (std::isnan(value) || !set_number(options->options, option, value))
      return refused("there is no option " + option + " that takes this number", 0);
    return 1;
  });
}

int32_t cncsub_options_variable(cncsub_options* options, int32_t number, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.variables[number] = value_of(value);
    return 1;
  });
}

int32_t cncsub_options_signal(cncsub_options* options, int32_t number, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.signals[number] = value;
    return 1;
  });
}

int32_t cncsub_options_work_offset(cncsub_options* options, const char* system, char axis,
                                   double value) {
  if (missing(options, system)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.setup.work_offsets[text_of(system)][axis] = value;
    return 1;
  });
}

int32_t cncsub_options_length_offset(cncsub_options* options, int32_t number, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.setup.length_offsets[number] = value;
    return 1;
  });
}

int32_t cncsub_options_radius_offset(cncsub_options* options, int32_t number, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.setup.radius_offsets[number] = value;
    return 1;
  });
}

int32_t cncsub_options_start_position(cncsub_options* options, char axis, double value) {
  if (missing(options)) return 0;
  return guarded<int32_t>(0, [&] {
    options->options.setup.start[axis] = value;
    return 1;
  });
}

cncsub_run* cncsub_library_run(const cncsub_library* library, const cncsub_options* options) {
  if (missing(library)) return nullptr;
  return guarded<cncsub_run*>(nullptr, [&]() -> cncsub_run* {
    auto run = library->library.run(options_of(options));
    if (!run) return refused<cncsub_run*>(run.error().message, nullptr);
    return new cncsub_run{*run, run->alarm()};
  });
}
void cncsub_run_free(cncsub_run* run) { delete run; }
const char* cncsub_run_stop(const cncsub_run* run) {
  if (missing(run)) return "";
  return to_string(run->run.stop()).data();
}

int32_t cncsub_run_alarm(const cncsub_run* run, cncsub_alarm* to) {
  if (missing(run, to)) return 0;
  if (!run->alarm) return 0;
  const nc::Alarm& from = *run->alarm;
  *to = {from.number.c_str(), from.cause.c_str(), from.text.c_str(), from.shown.c_str(),
         from.cure.c_str(),   place_of(from.at),  from.column};
  return 1;
}

const char* cncsub_run_alarm_word(const cncsub_run* run) {
  if (missing(run)) return "";
  return run->alarm ? run->alarm->word.c_str() : "";
}

int32_t cncsub_run_alarm_call(const cncsub_run* run, size_t index, cncsub_call* to) {
  if (missing(run, to)) return 0;
  if (!run->alarm || index >= run->alarm->stack.size()) return 0;
  *to = call_of(run->alarm->stack[index]);
  return 1;
}

int64_t cncsub_run_blocks(const cncsub_run* run) {
  if (missing(run)) return 0;
  return run->run.blocks();
}

double cncsub_run_variable(const cncsub_run* run, int64_t number) {
  if (missing(run)) return kNone;
  return guarded<double>(kNone, [&] { return value_or_none(run->run.variable(number)); });
}

size_t cncsub_run_moves(const cncsub_run* run) {
  if (missing(run)) return 0;
  return run->run.moves();
}

int32_t cncsub_run_write_moves(const cncsub_run* run, const cncsub_columns* to) {
  if (missing(run, to)) return 0;
  return guarded<int32_t>(0, [&] {
    run->run.write_moves({to->x, to->y, to->z, to->mx, to->my, to->mz, to->cx, to->cy, to->cz,
                          to->feed, to->length, to->time, to->kind, to->step});
    return 1;
  });
}

cncsub_machine* cncsub_library_machine(const cncsub_library* library,
                                       const cncsub_options* options) {
  if (missing(library)) return nullptr;
  return guarded<cncsub_machine*>(nullptr, [&]() -> cncsub_machine* {
    auto machine = library->library.machine(options_of(options));
    if (!machine) return refused<cncsub_machine*>(machine.error().message, nullptr);
    return new cncsub_machine{*machine, {}, {}};
  });
}
void cncsub_machine_free(cncsub_machine* machine) { delete machine; }

int32_t cncsub_machine_step(cncsub_machine* machine) {
  if (missing(machine)) return 0;
  return guarded<int32_t>(0, [&] { return machine->machine.step() ? 1 : 0; });
}

int32_t cncsub_machine_run_to(cncsub_machine* machine, const char* program, int64_t n) {
  if (missing(machine, program)) return 0;
  return guarded<int32_t>(0, [&] {
    const auto there = machine->machine.run_to(text_of(program), n);
    if (!there) return refused(there.error().message, 0);
    return *there ? 1 : refused("the run stopped before that block", 0);
  });
}

int32_t cncsub_machine_run(cncsub_machine* machine, int64_t blocks) {
  if (missing(machine)) return 0;
  return guarded<int32_t>(0, [&] { return machine->machine.run_blocks(blocks) ? 1 : 0; });
}

void cncsub_machine_interrupt(cncsub_machine* machine) {
  if (missing(machine)) return;
  machine->machine.interrupt();
}
const char* cncsub_machine_stop(const cncsub_machine* machine) {
  if (missing(machine)) return "";
  return to_string(machine->machine.stop()).data();
}

void cncsub_machine_next(cncsub_machine* machine, cncsub_place* to) {
  if (missing(machine, to)) return;
  guarded<int32_t>(0, [&] {
    machine->next = machine->machine.next();
    return 1;
  });
  *to = place_of(machine->next);
}

int32_t cncsub_machine_call(cncsub_machine* machine, size_t index, cncsub_call* to) {
  if (missing(machine, to)) return 0;
  return guarded<int32_t>(0, [&] {
    machine->stack = machine->machine.stack();
    if (index >= machine->stack.size()) return 0;
    *to = call_of(machine->stack[index]);
    return 1;
  });
}

double cncsub_machine_position(const cncsub_machine* machine, char axis) {
  if (missing(machine)) return kNone;
  return guarded<double>(kNone, [&] {
    const nc::Point point = machine->machine.position();
    const auto found = point.find(axis);
    return found == point.end() ? kNone : found->second;
  });
}

double cncsub_machine_variable(const cncsub_machine* machine, int64_t number) {
  if (missing(machine)) return kNone;
  return guarded<double>(kNone, [&] { return value_or_none(machine->machine.variable(number)); });
}

int32_t cncsub_machine_set_variable(cncsub_machine* machine, int64_t number, double value) {
  if (missing(machine)) return 0;
  return guarded<int32_t>(0, [&] {
    const auto wrong = machine->machine.set_variable(number, value_of(value));
    return wrong ? refused(wrong->message, 0) : 1;
  });
}

cncsub_run* cncsub_machine_so_far(const cncsub_machine* machine) {
  if (missing(machine)) return nullptr;
  return guarded<cncsub_run*>(nullptr, [&] {
    nc::Run run = machine->machine.so_far();
    auto alarm = run.alarm();
    return new cncsub_run{std::move(run), std::move(alarm)};
  });
}
