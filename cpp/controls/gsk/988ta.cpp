// GSK 988TA lathe, the control of source 000.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

Control gsk_988ta() {
  Control c = family_988();
  c.title = "GSK 988TA lathe";
  c.alarms[Cause::IllegalProgramNumber] = {"291", "P[#] has more than 4 digits",
                                           k000 + "word P, format 2 (1)", SourceDocument};
  c.alarms[Cause::RepeatGivenTwice] = {"293", "count given in P and in L",
                                       k000 + "words L and Q (3)", SourceDocument};
  // The examples feed without F. [source 000]
  add_parameter(
      c, {"1411", 100, "the feed at power-on", "TApar", Manual, {number(rule::power_on_feed)}});
  return c;
}

}  // namespace cncsub
