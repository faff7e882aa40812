// Expressions such as `[#101*COS[#102]-1.5]`, which are most of what is read and which every
// control reads alike, compiled in one pass.
#pragma once

#include <cstdint>

#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct OperatorName;

/// What was read: where it ends, and what kind of value it gives. None where it is not that plain:
/// it is left to the general way, which gives the same instructions.
struct PlainValue {
  const char* at = nullptr;
  Value value;
};

class PlainExpression {
 public:
  explicit PlainExpression(ValueWriter& out)
      : out_(out), written_(out.instructions()), rules_(out.rules()) {}

  /// Operands and operators as far as the text goes. What is written begins anew.
  PlainValue read(const Scanner& s);
  /// Whether comments may stand in what was read last, or behind it.
  bool comments() const { return comments_; }
  /// What stands in brackets, with them.
  PlainValue bracket(const Scanner& s);
  /// The variable that stands here, and nothing behind it.
  PlainValue variable(const Scanner& s);

 private:
  struct Waiting;
  struct Logic;
  struct Opening {
    int width = 0;  // 0: nothing opens
    Ins op{};       // of what is in the brackets, End where they are nothing but brackets
  };

  void begin(const Scanner& s) {
    end_ = s.end;
    file_ = s.file;
    address_ = out_.address();
    comments_ = false;
  }
  std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - file_); }
  void put(Ins op, std::uint32_t at) { written_.put(ExpressionCell::of(op, address_, at)); }

  PlainValue values(PlainValue read, int brackets);
  PlainValue bracketed(const char* at, int brackets);
  PlainValue opened(const char* at, int brackets);
  Opening opening(const char* at) const;
  PlainValue operand(const char* at, int brackets);
  PlainValue plain_operand(const char* at);
  PlainValue constant(const char* at);
  PlainValue written_variable(const char* at);
  PlainValue arc_tangent(const char* at, std::uint32_t of, int brackets);
  Value with_sign(bool negative, Value value, std::uint32_t at);
  void pass_gap(const char*& at);
  const char* behind_gap(const char* at);
  const OperatorName* next_operator(const char*& at);
  Value join(const Waiting* first, Waiting*& last, Value value, int level);
  Logic logic_behind(const OperatorName& of, const Waiting* first, Waiting* last, Value value);
  Value apply(const OperatorName& of, std::uint32_t at, Value left, Value right);

  ValueWriter& out_;
  OpenInstructions& written_;
  const ExpressionRules& rules_;
  const char *end_ = nullptr, *file_ = nullptr;
  std::uint32_t address_ = 0;
  bool comments_ = false;
};

}  // namespace cncsub
