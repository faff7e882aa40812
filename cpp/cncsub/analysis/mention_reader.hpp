// The reader of mentions: what blocks and heads name, and the variables in them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/analysis/mentions.hpp"
#include "cncsub/analysis/name_pieces.hpp"

namespace cncsub {

class MentionReader {
 public:
  MentionReader(const Code& code, GCodes codes, const MentionsAsked& asked)
      : code_(code), codes_(std::move(codes)), asked_(asked) {}

  std::vector<Mention> read(InterruptCheck& interrupt);

 private:
  /// A block that calls.
  struct Site {
    std::int32_t program;
    Address at;
  };

  const Program& own() const { return code_.programs[static_cast<std::size_t>(program_)]; }
  std::string_view text() const { return code_.files[own().file].text.view(); }
  Mention& add(Mention::Kind kind, TextPlace place);
  Mention& number(TextPlace place, std::int64_t n);
  void computed(Mention::Kind kind, TextPlace place, std::int32_t to_program);
  std::optional<TextPlace> word(std::string_view address, double value) const;

  void collect_calls(InterruptCheck& interrupt);
  void collect_labels();
  bool is_asked(const Mention& mention) const;
  bool may_be_asked(const Block& block) const;
  void drop_unasked(std::size_t from);
  void program(std::int32_t index, InterruptCheck& interrupt);
  void head();
  void block(const Block& block);

  void definitions(const Block& block);
  void references(const Block& block);
  void unnumbered(const Block& block);
  void sequence_number(const Block& block);
  void profile(const Block& block);
  void unknown_profile(const Block& block);
  void target(TextPlace place, Address to, bool in_caller, std::int32_t to_program);
  void jump(const JumpReference& jump);
  void back(const JumpReference& jump);
  void return_by_values(const CallRecord& back);
  void searched_part(const CallRecord& call);
  void part(const CallRecord& call);
  void fault(const Fault& fault);

  void call(const CallReference& call);
  void declared(const Block& block);
  void start_of(const CallReference& call);
  std::optional<TextPlace> program_digits(TextPlace place, std::int64_t n) const;
  std::optional<TextPlace> last_in(TextPlace place, std::string_view name) const;
  std::optional<TextPlace> label_in(TextPlace place, std::string_view label) const;
  std::string_view bare(std::string_view name) const;

  void label_of(Address at);
  void o_word(const OWord& own_word);

  /// Return whether a variable is defined by this name in the program, or in all.
  bool is_defined(std::string_view name) const;
  bool may_name_variable(const Block& block, std::string_view text) const;
  void variables(const Block& block);
  void variable(const NamePiece& piece, std::string_view text, std::uint32_t at);
  void arguments(const Block& block, const References& references);

  const Code& code_;
  const GCodes codes_;
  const MentionsAsked asked_;
  std::int32_t program_ = kNoProgram;
  Address at_ = kNowhere;
  std::vector<std::vector<Site>> callers_;                   // of each program
  std::vector<Site> computed_callers_;                       // of any program
  std::vector<std::pair<Address, std::uint32_t>> labelled_;  // blocks and their labels
  std::size_t looked_up_ = 0;
  std::vector<Mention> found_;
};

}  // namespace cncsub
