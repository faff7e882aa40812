// The alarms that the GSK 980TDi and 980MDi share.
#include "controls/gsk/family.hpp"

namespace cncsub::gsk {

/// The list of the 980MDi; none of the 980TDi was found.
void add_980_alarms(Control& c) {
  const auto add = [&c](Cause cause, const std::string& number, const std::string& text) {
    c.alarms[cause] = {number, text, kMDia + number, Manual};
  };
  const std::string length = "word has too few or too many characters";
  const std::string value = "value illegal or out of range";
  const std::string number = "O0000, no program number, or an illegal one";
  const std::string target = "sequence number of GOTO or M99 missing or out of range";
  const std::string format = "format of a macro statement";
  const std::string loop = "format of DO and END, or jump into a loop";
  const std::string brackets = "brackets not paired, or wrong format";
  add(Cause::AddressWithoutValue, "0003", length);
  add(Cause::TooManyDigits, "0003", length);
  add(Cause::IllegalMinusSign, "0012", value);
  add(Cause::IllegalDecimalPoint, "0012", value);
  add(Cause::ValueOutOfRange, "0012", value);
  add(Cause::AddressGivenTwice, "0010", "same address twice in a block");
  add(Cause::TooManyWords, "0011", "more than 100 words in a block");
  add(Cause::BlockTooLong, "0037", "block longer than 256 characters");
  add(Cause::CommentNotClosed, "0041", "format of a comment, brackets not paired");
  add(Cause::SequenceNumberNotFirst, "0006",
      "sequence number not at the head of the block, or out of range");
  add(Cause::IllegalSequenceNumber, "0006",
      "sequence number not at the head of the block, or out of range");
  add(Cause::ProgramNumberZero, "0095", number);
  add(Cause::ProgramNumberMissing, "0095", number);
  add(Cause::IllegalProgramNumber, "0095", number);
  add(Cause::IllegalProgramName, "0095", number);
  add(Cause::ProgramNotFound, "0001", "called program does not exist or cannot be opened");
  add(Cause::NamedProgramNotFound, "0001", "called program does not exist or cannot be opened");
  add(Cause::ReturnTargetNotFound, "0112", target);
  add(Cause::JumpTargetNotFound, "0112", target);
  add(Cause::IllegalJumpNumber, "0112", target);
  add(Cause::IllegalRepeatCount, "0092", "wrong count of a subprogram call");
  add(Cause::RepeatCountDigits, "0092", "wrong count of a subprogram call");
  add(Cause::NestingTooDeep, "0096", "more than 4 levels of subprograms");
  add(Cause::MacroNestingTooDeep, "0096", "more than 4 levels of subprograms");
  add(Cause::ProgramCallsItself, "0097", "called program is the current program");
  add(Cause::ProgramCallsCaller, "0094", "subprogram calls the main program");
  add(Cause::MacroCallNotFirst, "0114", "G65 or G66 is not the first word");
  add(Cause::CodeWithMacroCall, "0115", "G65 with G43, G44 or G49");
  add(Cause::MCodeWithMacroCall, "0116", "G65 with M00, M01, M02, M30, M98 or M99");
  add(Cause::CodeWithModalCall, "0044", "G66 with a G code of group 00 or 01");
  add(Cause::IllegalMacroNumber, "0119", "P of a macro call out of range");
  add(Cause::CallInModalCall, "0113", "M98 or M99 P in G66 mode");
  add(Cause::NcAndMacroInBlock, "0114", "G65 or G66 not at the head of the block");
  add(Cause::StatementFormat, "0101", format);
  add(Cause::StatementNotAvailable, "0101", format);
  add(Cause::ExpressionFormat, "0101", format);
  add(Cause::MissingEquals, "0101", format);
  add(Cause::MissingComma, "0101", format);
  add(Cause::IfFormat, "0101", format);
  add(Cause::WhileFormat, "0101", format);
  add(Cause::BracketNotOpened, "0104", brackets);
  add(Cause::BracketNotClosed, "0104", brackets);
  add(Cause::BracketsTooDeep, "0104", brackets);
  add(Cause::IllegalVariable, "0111", "variable does not exist");
  add(Cause::VariableWriteProtected, "0120", "variable is read only");
  add(Cause::VacantAssigned, "0117", "#0 cannot take a result");
  add(Cause::IllegalVariableValue, "0121", "a system variable cannot be made vacant");
  add(Cause::DivisionByZero, "0105", "division by zero");
  add(Cause::SquareRootOfNegative, "0108", "square root of a negative value");
  add(Cause::LogarithmOfNonPositive, "0107", "LN of zero or of a negative value");
  add(Cause::TangentInfinite, "0109", "tangent is infinite");
  add(Cause::ArcSineOutOfRange, "0110", "ASIN or ACOS outside -1 to 1");
  add(Cause::ArgumentOutOfRange, "0127", "not a whole number, cannot be made binary");
  add(Cause::Overflow, "0043", "overflow");
  add(Cause::LogicOfBits, "0133", "operand or result of AND, OR, XOR is neither 0 nor 1");
  add(Cause::IllegalLoopNumber, "0102", "DO or END number is not 1, 2, 3");
  add(Cause::MissingEnd, "0103", loop);
  add(Cause::MissingDo, "0103", loop);
  add(Cause::TooManyArgumentSets, "0118", "more than 10 of I, J or K");
  add(Cause::HCodeMissing, "0122", "no P in G65 or G66, or no H in G65");
  add(Cause::HCodeFormat, "0123", "format of G65 H");
  add(Cause::IllegalHCode, "0124", "illegal H code");
  add(Cause::HCodeOperand, "0125", "wrong count of operands");
  add(Cause::IllegalUserAlarm, "0126", "alarm number outside 0 to 99");
  c.alarms[Cause::GCodeNotAvailable] = {"0002", "illegal G code", kMDib + "0002", Manual};
  c.alarms[Cause::IllegalWordWithCall] = {"0051", "G04, G54 or G54.1 with M98", kMDib + "0051",
                                          Manual};
}

}  // namespace cncsub::gsk
