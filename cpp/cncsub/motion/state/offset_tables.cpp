#include "cncsub/motion/state/offset_tables.hpp"

#include "cncsub/text/scan.hpp"

namespace cncsub {
namespace {

std::size_t place(int number) { return static_cast<std::size_t>(number); }

}  // namespace

const Shared<OffsetTables::Numbers>* OffsetTables::of(VariableKind kind) const {
  switch (kind) {
    case VariableKind::LengthWear:
      return &length_wear;
    case VariableKind::LengthGeometry:
      return &length;
    case VariableKind::RadiusWear:
      return &radius_wear;
    case VariableKind::RadiusGeometry:
      return &radius;
    default:
      return nullptr;
  }
}

const Axes& OffsetTables::zero(int system) const {
  return system < kFirstExtra ? (*work)[place(system)] : (*extra)[place(system - kFirstExtra)];
}

Axes& OffsetTables::change_zero(int system) {
  return system < kFirstExtra ? work.change()[place(system)]
                              : extra.change()[place(system - kFirstExtra)];
}

double OffsetTables::length_of(int number) const {
  return (*length)[place(number)] + (*length_wear)[place(number)];
}

double OffsetTables::radius_of(int number) const {
  return (*radius)[place(number)] + (*radius_wear)[place(number)];
}

const ToolOffsets& OffsetTables::tool(int number) const {
  static constexpr ToolOffsets kNone;
  return place(number) < tools->size() ? (*tools)[place(number)] : kNone;
}

ToolOffsets& OffsetTables::change_tool(int number) {
  std::vector<ToolOffsets>& all = tools.change();
  if (place(number) >= all.size()) all.resize(place(number) + 1);
  return all[place(number)];
}

int OffsetTables::tool_of(std::string_view name) const {
  const auto found = edges->tools.find(capitals(trimmed(name)));
  return found == edges->tools.end() ? 0 : found->second;
}

void OffsetTables::name_tool(int number, std::string_view name) {
  EdgeTables& all = edges.change();
  std::erase_if(all.tools, [number](const auto& of) { return of.second == number; });
  if (const std::string capital = capitals(trimmed(name)); !capital.empty())
    all.tools[capital] = number;
}

Axes OffsetTables::point(int number) const {
  const auto found = reference->find(number);
  return found == reference->end() ? Axes{} : found->second;
}

}  // namespace cncsub
