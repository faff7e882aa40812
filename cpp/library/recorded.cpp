// The record of a run: its calls, its path, and the variables that have values.
#include <string>
#include <utility>
#include <vector>

#include "cncsub/system/decimal.hpp"
#include "cncsub/text/axis_names.hpp"
#include "cncsub/text/number.hpp"
#include "cncsub/trace/polyline.hpp"
#include "inside.hpp"

namespace cncsub::api {

namespace {

/// Return the text of a value, as people read it.
std::string text_of(const cncsub::Machine& machine, DefinedVariable::Type type, double value) {
  if (type == DefinedVariable::Type::Text) return machine.text(is_vacant(value) ? 0 : value);
  if (type == DefinedVariable::Type::Axis) return axis_letter(is_vacant(value) ? 0 : value);
  return is_vacant(value) ? "" : system::shortest(value);
}

/// Return the indices of an element: "[1,0]".
std::string indices(const std::vector<std::int32_t>& extents, std::int32_t element) {
  std::string text;
  for (auto extent = extents.rbegin(); extent != extents.rend(); element /= *extent++)
    text.insert(0, (extent + 1 == extents.rend() ? "[" : ",") + std::to_string(element % *extent));
  return text.empty() ? text : text + "]";
}

void append_named(const cncsub::Machine& machine, const NamedValues& of,
                  std::vector<Variable>& all) {
  using Type = DefinedVariable::Type;
  const DefinedVariable& known = *of.variable;
  for (std::int32_t i = 0; i < known.size(); ++i) {
    const double value = of.values[i];
    const bool is_text = known.type == Type::Text || known.type == Type::Axis;
    all.push_back({-1, known.name + indices(known.extents, i),
                   is_text ? std::nullopt : value_of(value), text_of(machine, known.type, value)});
  }
}

}  // namespace

std::vector<Variable> variables_of(const cncsub::Machine& machine, int level) {
  std::vector<Variable> all;
  for (const auto& [number, value] : machine.variables(level))
    if (!is_vacant(value)) all.push_back({number, "", value, system::shortest(value)});
  for (const NamedValues& of : machine.named(level)) append_named(machine, of, all);
  return all;
}

std::vector<Variable> Run::variables() const {
  return variables_of(inside_->machine, inside_->machine.state().level);
}

std::size_t Run::calls() const { return inside_->machine.trace().calls.size(); }

CallMade Run::call(std::size_t index) const {
  if (index >= calls()) return {};
  const CallRow& row = inside_->machine.trace().calls[index];
  return {std::string(cncsub::to_string(row.kind)),
          inside_->machine.code().name_of(row.program),
          row.parent,
          row.start_n,
          row.repeats,
          row.caller_step,
          row.first_step,
          row.last_step};
}

Path Run::path(double tolerance) const {
  if (!(tolerance > 0)) return {};
  const Moves& moves = inside_->machine.trace().moves;
  std::vector<std::int32_t> kinds(moves.size());
  moves.column("kind", kinds.data());
  Sampler sampler(moves, PathFrame::Work, tolerance / 2, 0, moves.size());
  InterruptCheck none;
  if (sampler.count(&none) >= Sampler::kMostPoints) return {};
  Outline line = sampler.outline(kinds.data(), tolerance / 2, &none);
  Path path{std::move(line.x), std::move(line.y), std::move(line.z), std::move(line.row), {}};
  for (const std::int32_t key : line.key) path.begins.push_back(key < 0 ? 1 : 0);
  return path;
}

}  // namespace cncsub::api
