// The alarms that the GSK 988TA and 988T share.
#include "controls/gsk/family.hpp"

namespace cncsub::gsk {

/// The list of the 988T. No list of the 988TA was found; its numbers up to 289 are those of the
/// 988T.
void add_988_alarms(Control& c) {
  const auto add = [&c](Cause cause, const std::string& number, const std::string& text) {
    c.alarms[cause] = {number, text, kTalm + number, Manual};
  };
  const std::string range = "value out of range, or more than 8 digits";
  const std::string missing = "program number not found";
  const std::string above = "call of an upper program or of itself";
  const std::string command = "wrong command in a macro";
  const std::string formula = "format of a formula";
  add(Cause::AddressWithoutValue, "005", "no data behind the address");
  add(Cause::ValueWithoutAddress, "004", "block starts without an address");
  add(Cause::IllegalMinusSign, "006", "minus sign misused");
  add(Cause::IllegalDecimalPoint, "007", "decimal point misused");
  add(Cause::TooManyDigits, "003", range);
  add(Cause::ValueOutOfRange, "003", range);
  add(Cause::IllegalSequenceNumber, "003", range);
  add(Cause::IllegalRepeatCount, "003", range);
  add(Cause::RepeatCountDigits, "003", range);
  add(Cause::AddressNotUsable, "008", "illegal address");
  add(Cause::AddressGivenTwice, "010", "same address or G code of one group twice");
  add(Cause::BlockTooLong, "002", "block longer than 256 characters");
  add(Cause::GCodeNotAvailable, "009", "illegal G code");
  add(Cause::IllegalMCombination, "012", "too many M codes");
  add(Cause::ProgramNumberMissing, "081", "address P not defined");
  add(Cause::ProgramNotFound, "083", missing);
  add(Cause::NamedProgramNotFound, "083", missing);
  add(Cause::ExternalProgramNotFound, "083", missing);
  add(Cause::StartNotFound, "083", missing);
  add(Cause::ReturnTargetNotFound, "083", missing);
  add(Cause::NestingTooDeep, "082", "more than 12 levels of subprograms");
  add(Cause::MacroNestingTooDeep, "207", "more than 4 levels of macro calls");
  add(Cause::ProgramCallsItself, "084", above);
  add(Cause::ProgramCallsCaller, "084", above);
  add(Cause::CallInMdi, "085", "call not allowed in MDI and DNC");
  add(Cause::MacroCallNotFirst, "212", "NC and macro call in one block");
  add(Cause::CodeWithMacroCall, "212", "NC and macro call in one block");
  add(Cause::CodeWithModalCall, "212", "NC and macro call in one block");
  add(Cause::ModalCallsTooMany, "207", "more than 4 levels of macro calls");
  add(Cause::CallInModalCall, "204", "M98, G65 or G66 in G66 mode");
  add(Cause::IllegalWordWithReturn, "030", "G28, G30, G53, G36, G37 with M99");
  add(Cause::EndOfRecord, "019", "% reached, or no program end");
  add(Cause::NcAndMacroInBlock, "212", "NC code and macro call in one block");
  add(Cause::StatementFormat, "201", command);
  add(Cause::StatementNotAvailable, "201", command);
  add(Cause::IfFormat, "201", command);
  add(Cause::WhileFormat, "201", command);
  add(Cause::ExpressionFormat, "202", formula);
  add(Cause::MissingEquals, "202", formula);
  add(Cause::MissingComma, "202", formula);
  add(Cause::BracketNotOpened, "202", formula);
  add(Cause::BracketNotClosed, "202", formula);
  add(Cause::BracketsTooDeep, "205", "more than 5 brackets");
  add(Cause::IllegalVariable, "203", "illegal variable number");
  add(Cause::VacantAssigned, "210", "no permission to assign");
  add(Cause::VariableWriteProtected, "220", "variable is read only");
  add(Cause::IllegalVariableValue, "216", "illegal variable value");
  add(Cause::DivisionByZero, "014", "division by zero");
  add(Cause::TangentInfinite, "014", "division by zero");
  add(Cause::SquareRootOfNegative, "206", "SQRT of a negative value, or argument of BIN, BCD");
  add(Cause::ArgumentOutOfRange, "206", "SQRT of a negative value, or argument of BIN, BCD");
  add(Cause::LogicOfNegative, "217", "OR, XOR, AND of a negative value");
  add(Cause::Overflow, "221", "overflow");
  add(Cause::JumpTargetNotFound, "213", "sequence number not 1 to 99999, or not found");
  add(Cause::IllegalJumpNumber, "213", "sequence number not 1 to 99999, or not found");
  add(Cause::IllegalLoopNumber, "211", "DO number is not 1 to 3");
  add(Cause::MissingEnd, "209", "DO and END not paired, or jump into a loop");
  add(Cause::MissingDo, "209", "DO and END not paired, or jump into a loop");
  add(Cause::JumpInMdi, "208", "macro branch in DNC or MDI");
  add(Cause::IllegalArgument, "214", "illegal argument address");
  add(Cause::ModalCallMissing, "218", "G67 without G66");
  add(Cause::CodeMayNotCall, "222", "M code may not call a macro");
  add_alarms(
      c,
      {{Cause::NoFeed, "021", "no feed, or one that does not fit G98 and G99", "Talm 021", Manual},
       {Cause::OffsetNumber, "026", "offset number", "Talm 026", Manual},
       {Cause::RadiusOffsetNumber, "026", "offset number", "Talm 026", Manual},
       {Cause::LengthAxis, "027", "no axis for the length offset", "Talm 027", Manual},
       {Cause::ArcAxis, "033", "axis outside the plane of the arc", "Talm 033", Manual},
       {Cause::NoRadius, "034", "neither R nor I, J, K", "Talm 034", Manual},
       {Cause::RadiusTooSmall, "035", "R too small", "Talm 035", Manual},
       {Cause::RadiusTolerance, "036", "the radii of start and end differ", "Talm 036", Manual},
       {Cause::ThreadLead, "038", "thread lead", "Talm 038", Manual},
       {Cause::UnitChangeLate, "042", "G20, G21 not alone at the head", "Talm 042", Manual},
       {Cause::NotAtReference, "045", "G27 not at the reference point", "Talm 045", Manual},
       {Cause::NotHomed, "043", "the machine zero is not known", "Talm 043", Manual},
       {Cause::ReferenceNotHomed, "047", "G30 before the machine zero is known", "Talm 047",
        Manual},
       {Cause::ReferenceNumber, "048", "P of G30", "Talm 048", Manual},
       {Cause::MeasuringMissed, "051", "no arrival signal in G36, G37", "Talm 051", Manual},
       {Cause::MeasuringEarly, "051", "no arrival signal in G36, G37", "Talm 051: in the zone",
        Inferred},
       {Cause::MeasuringOffset, "052", "no offset number in G36, G37", "Talm 052", Manual},
       {Cause::MeasuringWithOffset, "053", "T in G36, G37", "Talm 053", Manual},
       {Cause::MeasuringAxis, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringIncremental, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringZone, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringInCompensation, "056", "G36, G37 in G41, G42", "Talm 056", Manual},
       {Cause::SkipPerRevolution, "058", "G31 in feed per revolution", "Talm 058", Manual},
       {Cause::CompensationSkip, "059", "G31 in G41, G42", "Talm 059", Manual},
       {Cause::G10L, "061", "L of G10", "Talm 061", Manual},
       {Cause::G10P, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10System, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10Offset, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10Word, "062", "P of G10", "Talm 062", Manual},
       {Cause::StrokeArea, "068", "the range of the stroke check", "Talm 068", Manual},
       {Cause::CornerOffset, "271", "chamfer in a block that takes none", "Talm 271", Manual},
       {Cause::ToolWithSetting, "028", "T in a block that takes none", "Talm 028", Manual},
       {Cause::SpindleStands, "102", "thread at spindle speed 0", "Talm 102", Manual},
       {Cause::Taper, "123", "taper of G90, G92", "Talm 123", Manual},
       {Cause::FaceTaper, "124", "taper of G94", "Talm 124", Manual},
       {Cause::ProfileCall, "131", "a call in the profile", "Talm 131", Manual},
       {Cause::PqMissing, "133", "P or Q missing", "Talm 133", Manual},
       {Cause::PqNotFound, "134", "P or Q not found", "Talm 134", Manual},
       {Cause::ProfileNotMonotone, "138", "the profile is not monotone", "Talm 138", Manual},
       {Cause::ProfileFirstBlock, "144", "ns is not G00 or G01", "Talm 144", Manual},
       {Cause::CycleDepth, "148", "depth of cut", "Talm 148", Manual},
       {Cause::CyclePlane, "126", "plane of a multiple cycle", "Talm 126", Manual},
       {Cause::CycleAxis, "127", "axis outside ZX in G70 to G76", "Talm 127", Manual},
       {Cause::TurningPlane, "121", "a turning cycle outside ZX", "Talm 121", Manual},
       {Cause::TurningAxis, "122", "axis outside ZX in a turning cycle", "Talm 122", Manual},
       {Cause::ProfileCode, "128", "a G code in G70 to G73", "Talm 128", Manual},
       {Cause::ProfileInMdi, "129", "G70 to G73 in MDI", "Talm 129", Manual},
       {Cause::ProfileMacro, "130", "a macro statement in G70 to G73", "Talm 130", Manual},
       {Cause::PqSame, "135", "P and Q of G70 to G73", "Talm 135", Manual},
       {Cause::ProfileTooLong, "137", "more than 100 blocks", "Talm 137", Manual},
       {Cause::ProfileStart, "139", "the start of G71 to G73 lies in the range of the cut",
        "Talm 139", Manual},
       {Cause::ProfilePockets, "140", "too many pockets in G71", "Talm 140", Manual},
       {Cause::PatternX, "141", "X escape against the allowance of G73", "Talm 141", Manual},
       {Cause::PatternZ, "142", "Z escape against the allowance of G73", "Talm 142", Manual},
       {Cause::PatternFirstBlock, "145", "the first block of G73", "Talm 145", Manual},
       {Cause::ProfileFirstX, "146", "no X in the first block of G71", "Talm 146", Manual},
       {Cause::ProfileFirstZ, "147", "no Z in the first block of G72", "Talm 147", Manual},
       {Cause::CycleEscape, "149", "escape of G71, G72 below 0", "Talm 149", Manual},
       {Cause::PatternPasses, "151", "passes of G73", "Talm 151", Manual},
       {Cause::GrooveQ, "153", "Q of G74", "Talm 153", Manual},
       {Cause::GrooveP, "155", "P of G75", "Talm 155", Manual},
       {Cause::GrooveRetract, "156", "R(e) of G74, G75 below 0", "Talm 156", Manual},
       {Cause::GrooveEscape, "157", "R(d) of G74, G75 below 0", "Talm 157", Manual},
       {Cause::GrooveStep, "158", "a step of G74, G75", "Talm 158", Manual},
       {Cause::GrooveAxis, "154", "G75 without X", "Talm 154", Manual},
       {Cause::ThreadRunOut, "039", "run-out of a thread along the long axis", "Talm 039", Manual},
       {Cause::ThreadTravel, "160", "no travel in X or Z of G76", "Talm 160", Manual},
       {Cause::ThreadPasses, "161", "passes of G76 outside 1 to 99", "Talm 161", Manual},
       {Cause::ThreadLeastCut, "164", "Q(dmin) of G76", "Talm 164", Manual},
       {Cause::ThreadAllowance, "165", "R(d) of G76", "Talm 165", Manual},
       {Cause::ThreadTaper, "166", "R and U of a taper thread of G76", "Talm 166", Manual},
       {Cause::ThreadHeightValue, "168", "height of the thread of G76", "Talm 168", Manual},
       {Cause::ThreadCut, "169", "Q of G76", "Talm 169", Manual},
       {Cause::ThreadSteep, "170", "taper of G76 over 45 degrees", "Talm 170", Manual},
       {Cause::ThreadHeight, "167", "no height of the thread", "Talm 167", Manual},
       {Cause::CycleRepeats, "181", "K outside 1 to 99", "Talm 181", Manual},
       {Cause::CompensationNoIntersection, "251", "no intersection", "Talm 251", Manual},
       {Cause::CompensationArc, "252", "start or end of the compensation in an arc", "Talm 252",
        Manual},
       {Cause::CompensationEndArc, "252", "start or end of the compensation in an arc", "Talm 252",
        Manual},
       {Cause::CompensationPlane, "253", "plane change in the compensation", "Talm 253", Manual},
       {Cause::CompensationArcStart, "254", "arc starts or ends on its centre", "Talm 254", Manual},
       {Cause::CompensationArcEnd, "254", "arc starts or ends on its centre", "Talm 254", Manual},
       {Cause::CompensationInterference, "256", "interference", "Talm 256", Manual},
       {Cause::CompensationArcTooSmall, "261", "inner arc smaller than the radius", "Talm 261",
        Manual},
       {Cause::CornerInRapid, "271", "chamfer in a block that takes none", "Talm 271", Manual},
       {Cause::CornerNextMove, "272", "the block behind the chamfer", "Talm 272", Manual},
       {Cause::CornerNoMove, "273", "no move behind the chamfer", "Talm 273", Manual},
       {Cause::CornerPlane, "274", "plane change behind the chamfer", "Talm 274", Manual},
       {Cause::CornerTooShort, "275", "the move is shorter than the chamfer", "Talm 275", Manual},
       {Cause::CornerFormat, "276", "C, R and A together", "Talm 276", Manual}});
}

}  // namespace cncsub::gsk
