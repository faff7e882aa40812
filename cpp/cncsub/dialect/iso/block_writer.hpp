// The writer of a block's code: its words, and its call with operands and arguments.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/block_meaning.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"

namespace cncsub {

class BlockWriter {
 public:
  BlockWriter(Builder& to, const BlockRules& rules, const Tokens& tokens,
              const BlockMeaning& meaning, Block& block)
      : to_(to),
        rules_(rules),
        control_(rules.control),
        tokens_(tokens),
        meaning_(meaning),
        macro_(meaning.calls_macro()),
        block_(block) {}
  void write();

 private:
  void words();
  void values(WordList& words);
  void codes(WordList& words);
  bool executed(const Token& token) const;
  bool belongs_to_call(const Token& token) const;
  bool is_unheard(const Token& token) const;
  void drop_unheard();
  void drop_plain_p();
  WordValue value_of(const Operand& operand, int place);

  void call();
  void program_by_code(CallRecord& call) const;
  std::optional<Fault> operand(CallRecord& call, const Token& token) const;
  std::optional<Fault> given(Operand& place, const Token& token) const;
  std::optional<Fault> arguments(CallRecord& call);
  bool is_h_code() const;
  void h_code();
  void back();
  void jump();
  std::optional<Fault> input_of_jump(JumpRecord& jump);
  void refuse(Fault fault) { to_.refuse(block_, std::move(fault)); }

  Builder& to_;
  const BlockRules& rules_;
  const Control& control_;
  const Tokens& tokens_;
  const BlockMeaning& meaning_;
  bool macro_;  // the block calls a macro
  Block& block_;
};

}  // namespace cncsub
