// The standard cycles, programs of the control itself, and the alarms that they raise. They are
// written after what the sources say of each cycle; see the folder cycles.
#include "controls/siemens/family.hpp"

namespace cncsub::siemens {
namespace {

using enum Evidence;

constexpr SystemProgram kCycles[] = {
#define CYCLE(name, text) {name, text, {}},
#include "controls/siemens/cycles.def"
#undef CYCLE
    // Cycles of the control whose moves are not computed.
    {"CYCLE60", {}, {}},
    {"CYCLE61", {}, {}},
    {"CYCLE62", {}, {}},
    {"CYCLE63", {}, {}},
    {"CYCLE64", {}, {}},
    {"CYCLE70", {}, {}},
    {"CYCLE71", {}, {}},
    {"CYCLE72", {}, {}},
    {"CYCLE73", {}, {}},
    {"CYCLE74", {}, {}},
    {"CYCLE75", {}, {}},
    {"CYCLE76", {}, {}},
    {"CYCLE77", {}, {}},
    {"CYCLE78", {}, {}},
    {"CYCLE79", {}, {}},
    {"CYCLE90", {}, {}},
    {"CYCLE92", {}, {}},
    {"CYCLE93", {}, {}},
    {"CYCLE94", {}, {}},
    {"CYCLE95", {}, {}},
    {"CYCLE96", {}, {}},
    {"CYCLE97", {}, {}},
    {"CYCLE98", {}, {}},
    {"CYCLE99", {}, {}},
    {"CYCLE435", {}, {}},
    {"CYCLE495", {}, {}},
    {"CYCLE800", {}, "it needs the swivel data of the machine"},
    {"CYCLE802", {}, {}},
    {"CYCLE830", {}, {}},
    {"CYCLE899", {}, {}},
    {"CYCLE930", {}, {}},
    {"CYCLE940", {}, {}},
    {"CYCLE950", {}, {}},
    {"CYCLE951", {}, {}},
    {"CYCLE952", {}, {}},
    {"CYCLE961", {}, {}},
    {"CYCLE971", {}, {}},
    {"CYCLE973", {}, {}},
    {"CYCLE974", {}, {}},
    {"CYCLE976", {}, {}},
    {"CYCLE977", {}, {}},
    {"CYCLE978", {}, {}},
    {"CYCLE979", {}, {}},
    {"CYCLE982", {}, {}},
    {"CYCLE994", {}, {}},
    {"CYCLE995", {}, {}},
    {"CYCLE996", {}, {}},
    {"CYCLE997", {}, {}},
    {"CYCLE998", {}, {}},
    {"LONGHOLE", {}, {}},
    {"POCKET1", {}, {}},
    {"POCKET2", {}, {}},
    {"POCKET3", {}, {}},
    {"POCKET4", {}, {}},
    {"SLOT1", {}, {}},
    {"SLOT2", {}, {}},
    // What the cycles above do not compute of their parameters: they call these names.
    {"_GMODE_OF_CYCLE", {}, "GMODE of a drilling cycle: write 0"},
    {"_VARI_OF_CYCLE82", {}, "drilling through, VARI, ZA and ZD of CYCLE82"},
    {"_DAM_WITHOUT_MDEP", {}, "a factor in DAM of CYCLE83 without MDEP"},
    {"_AMODE_OF_CYCLE83", {}, "hundreds and more in AMODE of CYCLE83, which say what others count"},
    {"_FRF_OF_CYCLE83", {}, "FRF of CYCLE83 outside 0.001 to 1"},
    {"_VARI_OF_CYCLE801", {}, "frames and parallelograms, VARI, ANG1 and ANG2 of CYCLE801"},
    {"_VARI_OF_HOLES2", {}, "VARI of HOLES2: write 0, or leave it out"},
    {"_HIDE_OF_PATTERN", {}, "positions that HIDE leaves out: write the others one by one"},
    {"_VARI_OF_CYCLE84", {}, "tapping in strokes, VARI of CYCLE84"},
    {"_PITA_OF_CYCLE", {}, "leads in inches or in threads an inch, PITA above 1"},
};

constexpr const char* kAlarms = "general knowledge of the SINUMERIK alarms";
constexpr const char* kWiki = "CW-C, alarms of the cycles";

constexpr RaisedAlarm kRaised[] = {
    {61001, "thread lead incorrectly defined", kAlarms, Inferred},
    {61101, "reference plane incorrectly defined", kWiki, Secondary},
    {61102, "no spindle direction programmed", kAlarms, Inferred},
    {61103, "number of holes is zero", kAlarms, Inferred},
    {61107, "first drilling depth incorrectly defined", kAlarms, Inferred},
    {61815, "G40 not active", kWiki, Secondary},
};

}  // namespace

void standard_cycles(Control& c) {
  c.system_programs = kCycles;
  c.raised_alarms = kRaised;
}

}  // namespace cncsub::siemens
