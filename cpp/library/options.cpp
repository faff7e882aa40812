// What a run is given, checked and handed to the engine.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cncsub/code/variable_faults.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/text/scan.hpp"
#include "cncsub/trace/duration.hpp"
#include "inside.hpp"

namespace cncsub::api {

namespace {

/// Return why points name what is no axis, or nothing.
std::optional<Error> wrong_axis(const std::string& option, const Point& point) {
  for (const auto& [axis, value] : point)
    if (kAxisNames.find(axis) == std::string_view::npos || !std::isfinite(value))
      return Error{option, std::string("there is no such value of an axis ") + axis};
  return std::nullopt;
}

std::optional<Error> wrong_setup(const cncsub::Control& control, const Setup& setup) {
  constexpr std::string_view kMachines[] = {"", "mill", "lathe-a", "lathe-b"};
  if (std::find(std::begin(kMachines), std::end(kMachines), setup.machine) == std::end(kMachines))
    return Error{"setup", "machine must be mill, lathe-a or lathe-b, not " + setup.machine};
  for (const Point* point : {&setup.start, &setup.rapid})
    if (auto wrong = wrong_axis("setup", *point)) return wrong;
  for (const auto& [number, point] : setup.reference)
    if (auto wrong = wrong_axis("setup", point)) return wrong;
  for (const auto& [name, point] : setup.work_offsets) {
    if (!has_system(control, name))
      return Error{"setup", control.name + " has no work offset " + name};
    if (auto wrong = wrong_axis("setup", point)) return wrong;
  }
  for (const auto& [axis, limits] : setup.limits)
    if (auto wrong = wrong_axis("setup", {{axis, limits.first}})) return wrong;
  return std::nullopt;
}

cncsub::Setup setup_of(const Setup& from) {
  cncsub::Setup setup;
  setup.machine = from.machine;
  setup.start = from.start;
  setup.work_offsets = from.work_offsets;
  setup.length_offsets = from.length_offsets;
  setup.radius_offsets = from.radius_offsets;
  setup.reference = from.reference;
  setup.rapid = from.rapid;
  setup.limits = from.limits;
  return setup;
}

cncsub::Options options_of(const Options& from) {
  cncsub::Options options;
  options.start = from.start.value_or(-1);
  for (const auto& [number, value] : from.variables)
    options.variables[number] = value.value_or(kVacant);
  for (const int number : from.block_skip)
    options.skips = static_cast<std::uint16_t>(options.skips | 1U << static_cast<unsigned>(number));
  options.optional_stop = from.optional_stop;
  options.max_cycles = from.max_cycles;
  options.max_blocks = from.max_blocks;
  options.max_seconds = from.max_seconds;
  options.trace = static_cast<Trace::Depth>(from.record);
  options.setup = setup_of(from.setup);
  for (const auto& [number, value] : from.signals) options.inputs.signals[number] = value;
  return options;
}

std::optional<Error> wrong_options(const Code& code, const Options& options) {
  for (const int number : options.block_skip)
    if (number < 1 || number > cncsub::Options::kSwitches)
      return Error{"block_skip", "a switch is 1 to 10, not " + std::to_string(number)};
  for (const auto& [number, value] : options.signals)
    if (!is_signal(code, number))
      return Error{"signals",
                   "#" + std::to_string(number) + " is not a signal of " + code.control->name};
  if (options.max_cycles < 1) return Error{"max_cycles", "it must be at least 1"};
  if (options.max_blocks < 1) return Error{"max_blocks", "it must be at least 1"};
  if (!(options.max_seconds >= 0)) return Error{"max_seconds", "it must be 0 or more"};
  return wrong_setup(*code.control, options.setup);
}

/// Return the program that runs: the one of this name, or the one that a run begins with.
std::int32_t main_of(const Code& code, const std::string& name) {
  return name.empty() ? code.main_program() : code.find(std::string_view(name));
}

}  // namespace

Result<cncsub::Machine> machine_of(const std::shared_ptr<const Code>& code, const Options& options,
                                   const std::vector<std::int32_t>& watch) {
  const std::int32_t main = main_of(*code, options.main);
  if (main == kNoProgram)
    return Error{"main", options.main.empty() ? "there is no program"
                                              : "there is no program " + options.main};
  if (auto wrong = wrong_options(*code, options)) return *wrong;
  const Program& program = code->programs[static_cast<std::size_t>(main)];
  if (options.start && code->first_of(program, *options.start) == kNowhere)
    return Error{"start", "there is no block N" + std::to_string(*options.start) + " in " +
                              code->name_of(program)};
  cncsub::Options own = options_of(options);
  own.watch = watch;
  cncsub::Machine machine(code, main, std::move(own));
  for (const auto& [number, value] : options.variables)
    if (const auto fault = machine.write(number, 0, value.value_or(kVacant)))
      return Error{"variables", fault->detail};
  return machine;
}

}  // namespace cncsub::api
