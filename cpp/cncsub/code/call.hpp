// Calls as they are written, and their targets once the operands are known.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/code/expression.hpp"
#include "cncsub/code/fault.hpp"
#include "cncsub/code/program.hpp"
#include "cncsub/code/statement.hpp"
#include "cncsub/control/control.hpp"

namespace cncsub {

/// The kind of a call, as its frame shows it: a call of its own, or that of a code which calls.
enum class CallKind : std::uint8_t {
  Subprogram,       // M98
  External,         // M198: a program of the external device
  Local,            // M97: blocks of the own program
  OWord,            // o100 call
  Named,            // the name of a program alone: L100, SUB
  Macro,            // G65
  Modal,            // G66
  ModalEveryBlock,  // G66.1
  GCode,
  MCode,
  TCode,
  SCode,
  BCode,
  Ascii,      // a letter whose every code calls
  Repeat,     // REPEAT LABEL: a part of the own program
  CallBlock,  // CALL BLOCK FIRST TO LAST
  Typed       // a text typed in MDI while a program stands between two blocks
};
/// Return the name under which a kind is shown: M98, G66.1, T-code.
std::string_view to_string(CallKind kind);
inline bool is_macro(CallKind kind, CodeCallKind code) {
  switch (kind) {
    case CallKind::Subprogram:
    case CallKind::External:
    case CallKind::Local:
    case CallKind::OWord:
    case CallKind::Named:
    case CallKind::Repeat:
    case CallKind::CallBlock:
    case CallKind::Typed:
      return false;
    case CallKind::Macro:
    case CallKind::Modal:
    case CallKind::ModalEveryBlock:
      return true;
    default:
      return code != CodeCallKind::Subprogram;
  }
}

struct Argument {
  std::int32_t variable = 0;  // the local it sets
  char address = 0;
  Operand operand;
};

/// The target of a call, once its operands are known.
struct Target {
  std::int64_t program_number = -1;
  std::int32_t program = kNoProgram;
  Address start = kNowhere;
  std::int32_t start_n = -1;
  std::int32_t repeats = 1;
  bool skipped = false;   // L0
  bool jump = false;      // a MELDAS M98 without P
  bool external = false;  // on the external device

  bool operator==(const Target&) const = default;
};

/// The jump of M97 P in the running program, or of M96 P Q while an input is 0.
struct JumpRecord {
  Operand p;
  bool reads_input = false;
  std::uint32_t input = 0;  // the expression that gives the input
  std::uint32_t at = 0, width = 1;
};

/// A value in the brackets of a call, in the order of the called program's parameters.
struct ActualParameter {
  Operand operand;  // absent: left out
  DefinedVariable::Type type = DefinedVariable::Type::Real;
  Statement variable;  // its target is the variable that stands there and nothing else, if any
  std::vector<std::int32_t> extents;  // of an array that stands there; 0: not known before it runs
};

/// A parameter that stands for a variable of the caller, or for an array or its copy.
struct PassedReference {
  std::int32_t local = 0;  // of the called program: it holds the Reference; where `extents` is not
                           // empty, the next one the number of elements, then come the extents
  Statement variable;      // of the caller
  std::vector<std::int32_t> extents;
  bool copied = false;
};

/// The call of one of several programs that a name means by turns: the record that passes the
/// values to it, or the fault of a call that it does not take.
struct CallChoice {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::int32_t program = 0;
  std::uint32_t record = 0;
  std::uint32_t fault = kNone;  // in Code::faults
};

/// The parts that few calls have.
struct CallExtras {
  Operand start, device;
  std::string name;  // <NAME>, P[NAME]
  std::uint32_t name_at = 0, name_width = 1;
  std::string path;                           // what stands before the name: /_N_SPF_DIR/
  std::vector<CallChoice> choices;            // where the folder of the main program decides
  char count = 'L';                           // the address of `l` as it is written
  Address part_end = kNowhere;                // of RepeatPart: the block before which a pass ends
  std::uint32_t last_at = 0, last_width = 0;  // the same: where its last block is named, if it is
  // The same: the texts that name its first and its last block, where they are searched for as it
  // runs.
  Operand first_text, last_text;
  // Of a return: it has values: the block after the one that it names is meant, and how many
  // levels it goes back.
  bool by_values = false;
  Operand after, levels;
  std::vector<ActualParameter> given;  // until the called program is known
  std::vector<PassedReference> references;
  Operand name_text;  // the name of the program, a text that is computed
};

/// Extras of a call that take no room where there are none.
class SeldomValue {
 public:
  SeldomValue() = default;
  SeldomValue(const SeldomValue& other)
      : value_(other.value_ ? std::make_unique<CallExtras>(*other.value_) : nullptr) {}
  SeldomValue(SeldomValue&&) noexcept = default;
  SeldomValue& operator=(SeldomValue other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~SeldomValue() = default;

  const CallExtras& get() const {
    static const CallExtras nothing;
    return value_ ? *value_ : nothing;
  }
  CallExtras* find() { return value_.get(); }
  CallExtras& make() {
    if (!value_) value_ = std::make_unique<CallExtras>();
    return *value_;
  }

 private:
  std::unique_ptr<CallExtras> value_;
};

struct CallRecord {
  CallKind kind = CallKind::Subprogram;
  CodeCallKind code_kind = CodeCallKind::Subprogram;
  bool macro = false;
  bool constant = false;  // `target` holds for every execution
  enum class Locals : std::uint8_t {
    ByKind,     // a macro has its own, a subprogram its caller's
    Own,        // the arguments and nothing else
    OwnByName,  // those with a number are the caller's
  } locals = Locals::ByKind;
  std::int32_t code = 0;             // the calling code: 60 of M60
  std::int32_t variable = 0;         // takes the code's value
  std::int32_t program_number = -1;  // a call by code: the program it is registered for
  Operand p, l;
  SeldomValue extras;
  std::uint32_t first_argument = 0, arguments = 0;
  std::uint32_t at = 0, width = 1;  // the calling word
  Target target;

  const Operand& start() const { return extras.get().start; }
  const Operand& device() const { return extras.get().device; }
  const std::string& name() const { return extras.get().name; }
  const std::vector<PassedReference>& references() const { return extras.get().references; }
  const Operand& name_text() const { return extras.get().name_text; }
};

}  // namespace cncsub
