// Two runs compared: where they part, and which rules of two controls make it.
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "cncsub/comparison/rule_exchange.hpp"
#include "gil.hpp"
#include "live.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

using LivePtr = std::shared_ptr<Live>;
/// Two sides: their names, their runs, and what makes their runs again in Python.
using SideRow = std::tuple<std::string, LivePtr, py::function>;
using SideRows = std::array<SideRow, 2>;

/// A run in Python that nobody changes while it is looked at.
Ran ran_of(LivePtr live) {
  struct Held {
    LivePtr live;
    Look look;
    explicit Held(LivePtr of) : live(std::move(of)), look(*live) {}
  };
  auto held = std::make_shared<Held>(std::move(live));
  const Machine* const machine = &held->live->machine;
  return {std::move(held), machine};
}

/// Asks Python, in a scope that does not hold the GIL.
class Asking {
 public:
  explicit Asking(GilRelease& away) : away_(away) {}

  /// Return what runs a side again: a function of Python that takes the most blocks (None: any
  /// number) and the variables to watch, and returns a machine, or None.
  Runner runner(const py::function& again) const {
    return [this, &again](std::int64_t most, const std::vector<std::int32_t>& watch) {
      return away_.ask([&]() -> Ran {
        const py::object blocks =
            most == kAnyBlocks ? py::object(py::none()) : py::object(py::int_(most));
        const py::object live = again(blocks, watch);
        return live.is_none() ? nullptr : ran_of(live.cast<LivePtr>());
      });
    };
  }

  Sides sides(const SideRows& rows) const {
    Sides sides;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [name, live, again] = rows[i];
      sides[i] = {name, ran_of(live), runner(again)};
    }
    return sides;
  }

  GilRelease& away() const { return away_; }

 private:
  GilRelease& away_;
};

/// Compare without the GIL. The job gets the sides and an interrupt that Ctrl-C requests.
template <class Job>
void compare_away(const SideRows& rows, Job&& job) {
  {
    GilRelease away;
    const Asking asking(away);
    const Sides sides = asking.sides(rows);
    InterruptCheck interrupt(
        [&away] { return away.ask([] { return PyErr_CheckSignals() != 0; }); });
    std::forward<Job>(job)(asking, sides, interrupt);
  }
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
}

py::object parting(const std::string& name, const SideRows& rows,
                   const std::map<std::string, std::string>& programs,
                   const std::map<std::int32_t, std::int32_t>& variables) {
  const auto question = question_named(name);
  if (!question) throw py::value_error("no question " + name);
  const Renamed renamed{programs, variables};
  std::optional<Parting> found;
  compare_away(rows, [&](const Asking&, const Sides& sides, InterruptCheck& interrupt) {
    found = parting_of(*question, sides, interrupt, renamed);
  });
  if (!found) return py::none();
  return py::make_tuple(found->first, found->second, found->what, found->column);
}

/// `run_on`: a function of Python that takes a control, and returns what runs the first side's
/// texts on it, as `Asking::runner` wants it, or None.
std::vector<std::string> rules_apart(const RuleExchange& exchange,
                                     const std::pair<std::int64_t, std::int64_t>& at,
                                     const SideRows& rows, const py::function& run_on) {
  std::vector<std::string> names;
  compare_away(rows, [&](const Asking& asking, const Sides& sides, InterruptCheck& interrupt) {
    std::optional<py::function> again;  // of the control that is tried
    const struct Taken {
      GilRelease& away;
      std::optional<py::function>& again;
      ~Taken() {
        away.ask([this] { again.reset(); });
      }
    } taken{asking.away(), again};
    const RunOn tried = [&](const RuleExchange::ControlPtr& control) -> Runner {
      const bool runs = asking.away().ask([&] {
        const py::object made = run_on(std::const_pointer_cast<Control>(control));
        again.reset();
        if (!made.is_none()) again.emplace(made);
        return again.has_value();
      });
      return runs ? asking.runner(*again) : Runner();
    };
    names = rules_that_make({at.first, at.second, "", ""}, sides, exchange, tried, interrupt);
  });
  return names;
}

}  // namespace

void add_comparison(py::module_& m) {
  py::class_<RuleExchange>(m, "RuleExchange", py::is_final())
      .def(
          "control",
          [](const RuleExchange& self, const std::vector<std::string>& names) {
            return std::const_pointer_cast<Control>(self.control(names));
          },
          py::arg("names"))
      .def_property_readonly("untried", &RuleExchange::untried);
  m.def(
      "rule_exchange",
      [](std::shared_ptr<Control> one, std::shared_ptr<Control> other) {
        return std::make_unique<RuleExchange>(std::move(one), std::move(other));
      },
      py::arg("one"), py::arg("other"));
  m.def("parting", &parting, py::arg("question"), py::arg("sides"),
        py::arg("programs") = std::map<std::string, std::string>(),
        py::arg("variables") = std::map<std::int32_t, std::int32_t>());
  m.def("rules_apart", &rules_apart, py::arg("exchange"), py::arg("at"), py::arg("sides"),
        py::arg("run_on"));
  m.def(
      "shared_variables",
      [](Live& one, Live& other) { return shared_variables(*Look(one), *Look(other)); },
      py::arg("one"), py::arg("other"));
  m.def("summary", [](Live& live) { return summary(*Look(live)); }, py::arg("machine"));
}

}  // namespace cncsub::bindings
