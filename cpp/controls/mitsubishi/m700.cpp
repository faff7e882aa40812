// Mitsubishi M700, M70, E70, C70.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

using namespace mitsubishi;

Control mitsubishi_m700() {
  Control c = family();
  c.title = "Mitsubishi M700, M70, E70, C70";
  return c;
}

}  // namespace cncsub
