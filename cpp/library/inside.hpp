// What the handles of the public header hold, and how values of the engine become those of the
// header.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

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

/// Return a machine that stands at the beginning of what the options ask for, or why there is none.
Result<cncsub::Machine> machine_of(const std::shared_ptr<const Code>& code, const Options& options);

}  // namespace cncsub::api
