// Siemens SINUMERIK 828D, a mill, in its own language.
#include "controls/facts.hpp"
#include "controls/siemens/family.hpp"

namespace cncsub {

/// As the SINUMERIK ONE, as far as a source tells of it.
Control siemens_828d() {
  Control c = siemens_one();
  c.title = "Siemens SINUMERIK 828D mill";
  c.calls.max_nesting = {15, "828D p.490: 16 program levels, the main program is on the first",
                         Evidence::Manual};
  return c;
}

}  // namespace cncsub
