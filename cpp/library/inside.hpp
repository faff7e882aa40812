// What the handles of the public header hold, and how values of the engine become those of the
// header.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/cncsub.hpp"
#include "cncsub/code/code.hpp"
#include "cncsub/machine/machine.hpp"

namespace cncsub::api {

struct Library::Inside {
  std::shared_ptr<const Code> code;
};

struct Run::Inside {
  cncsub::Machine machine;
};

struct Machine::Inside {
  cncsub::Machine machine;
  std::atomic<bool> interrupted = false;

  explicit Inside(cncsub::Machine at) : machine(std::move(at)) {}
};

Place place_of(const Code& code, Address address);
std::string text_at(const Code& code, Address address);
Alarm alarm_of(const cncsub::Alarm& from);
Call call_of(const Frame& from);
Stop stop_of(cncsub::Stop from);
std::optional<double> value_of(double value);
Result<std::optional<double>> read(const cncsub::Machine& machine, std::int64_t number, int level);

std::vector<Variable> variables_of(const cncsub::Machine& machine, int level);

/// Return the control of a name or of an alias, or an error with the names that are near.
Result<const cncsub::Control*> control_named(const std::string& name);
Result<std::shared_ptr<const cncsub::Control>> changed_control(
    const std::string& name, const std::map<std::string, std::string>& changes);
/// Read the texts of a library for another control.
std::shared_ptr<const Code> read_again(const Code& code,
                                       std::shared_ptr<const cncsub::Control> control);

/// Return a machine that stands at the beginning of what the options ask for, or why there is none.
/// `watch`: variables whose changes are kept.
Result<cncsub::Machine> machine_of(const std::shared_ptr<const Code>& code, const Options& options,
                                   const std::vector<std::int32_t>& watch = {});

}  // namespace cncsub::api
