// FANUC Series 16i/18i/21i with the 0i-A/B/C.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

// Mills and lathes (systems A, B and C) together, options included. Three-digit codes are the other
// spelling of codes with a point: G107 is G07.1, G112 and G113 are G12.1 and G13.1, G150-G152 are
// G40.1-G42.1, G250 and G251 are G50.2 and G51.2.
constexpr const char* kCodes16i =
    "0 1 2 2.1 2.2 2.3 3 3.1 3.2 3.3 4 5 5.1 5.4 6.2 7 7.1 8 9 10 10.6 11 12.1 13.1 15 16 17 18 19 "
    "20 21 22 23 24 25 26 "
    "27 28 29 30 30.1 31 31.1 31.2 31.3 31.8 32 33 34 35 36 37 39 40 40.1 41 41.1 42 42.1 43 44 45 "
    "46 47 48 49 50 50.1 "
    "50.2 50.3 51 51.1 51.2 52 53 54 54.1 54.2 55 56 57 58 59 60 61 62 63 64 65 66 67 68 69 70 71 "
    "72 72.1 72.2 73 74 75 "
    "76 77 78 79 80 81 81.1 82 83 84 84.2 84.3 85 86 87 88 89 90 91 92 92.1 93 94 95 96 97 98 99 "
    "107 112 113 150 151 152 "
    "160 161 250 251";

const AlarmList& alarms_16i() {
  using enum Cause;
  static const AlarmList list = {"",
                                 Inferred,
                                 false,
                                 "general knowledge of the 16i alarm list",
                                 {
#include "controls/fanuc/alarms_16i.def"
                                 }};
  return list;
}

}  // namespace

Control fanuc_16i() {
  Control c = family();
  c.title = "FANUC Series 16i/18i/21i, 0i-A/B/C";
  c.reading.g_codes = {kCodes16i, cite({kReg, kCncs, "the rest general knowledge"}), Inferred};
  c.motion.negative_radius = {NegativeRadius::MillsOnly, "16TC p.67", Manual};
  code_calls(c, 255, 1, 97, 6, 255);
  take_list(c, alarms_16i());
  for (const auto& [cause, source] : {std::pair{Cause::Overflow, kJix},
                                      {Cause::LogarithmOfNonPositive, kAli},
                                      {Cause::ArcSineOutOfRange, kAli}}) {
    c.alarms[cause].source = source;
    c.alarms[cause].evidence = Secondary;
  }
  return c;
}

}  // namespace cncsub
