// Siemens SINUMERIK 840D sl, a mill, in its own language.
#include "controls/facts.hpp"
#include "controls/siemens/family.hpp"

namespace cncsub {

/// As the SINUMERIK ONE, which keeps the language. [NCX chapter 1]
Control siemens_840d_sl() {
  Control c = siemens_one();
  c.title = "Siemens SINUMERIK 840D sl mill";
  return c;
}

}  // namespace cncsub
