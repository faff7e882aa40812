#include "controls/settings.hpp"

namespace cncsub {

void add_parameter(Control& c, const Parameter& parameter) {
  c.parameters.push_back(parameter);
  apply(c, parameter, "parameter " + parameter.name + " as delivered: " + parameter.source,
        parameter.evidence);
}

void add_parameters(Control& c, std::span<const Parameter> parameters) {
  for (const Parameter& parameter : parameters) add_parameter(c, parameter);
}

void measuring_parameters(Control& c, const char* source, Evidence evidence) {
  const auto add = [&](const char* name, const char* meaning) {
    c.parameters.push_back(read_by(rule::measuring, {name, 0, meaning, source, evidence}));
  };
  add("6241", "the measuring feed of G36 and G37, mm/min");
  add("6251", "G36, and G37 of a mill: how far before the point the measuring feed begins, mm");
  add("6252", "G37 of a lathe: how far before the point the measuring feed begins, mm");
  add("6254", "G36, and G37 of a mill: within what distance of the point the tool arrives, mm");
  add("6255", "G37 of a lathe: within what distance of the point the tool arrives, mm");
  add_parameter(c, {"6210#6",
                    0,
                    "what G36 and G37 measure is 0 added to the offset, 1 subtracted",
                    source,
                    evidence,
                    {bit(rule::measured, Measured::Added, Measured::Subtracted)}});
}

}  // namespace cncsub
