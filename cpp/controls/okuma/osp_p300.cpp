// Okuma OSP-P300 of machining centers.
#include "controls/facts.hpp"
#include "controls/okuma/family.hpp"

namespace cncsub {

Control okuma_osp_p300() {
  Control c = okuma::family();
  c.title = "Okuma OSP-P300, machining centers";
  return c;
}

}  // namespace cncsub
