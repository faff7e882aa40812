// Writes what a run executes as one program without calls, jumps and loops: in pieces, while it
// runs, so that neither the text nor the run has to be kept.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/flat/blocks.hpp"
#include "cncsub/flat/other.hpp"
#include "cncsub/machine/machine.hpp"
#include "cncsub/machine/state/observer.hpp"

namespace cncsub {

/// Where the blocks of a flat program come from: columns of one length.
struct FlatOrigins {
  std::vector<std::int32_t> program, n, line, call, repeat;

  std::size_t size() const { return program.size(); }
  void add(std::int32_t of, std::int32_t number, std::uint32_t at_line, std::int32_t of_call,
           std::int32_t pass) {
    program.push_back(of);
    n.push_back(number);
    line.push_back(static_cast<std::int32_t>(at_line));
    call.push_back(of_call);
    repeat.push_back(pass);
  }
  void clear() {
    for (auto* column : {&program, &n, &line, &call, &repeat}) column->clear();
  }
};

/// Why there is no flat program, or none that can be written, and at which block.
struct FlatRefusal {
  std::string reason;
  Address at = kNowhere;
};

/// Return what the codes of a block mean that `machine` executed last and `observer` kept.
const BlockCodes& codes_of(const Machine& machine, const Observer& observer, const Block& block);

class FlatRun {
 public:
  /// `at_its_head`: a machine that has executed nothing. `comments`: each block says in a comment
  /// where it comes from. `other`: a machine of another control, in whose words the program is
  /// written; null where the program's own words stay.
  FlatRun(const Machine& at_its_head, bool comments, const Machine* other = nullptr);
  FlatRun(const FlatRun&) = delete;
  FlatRun& operator=(const FlatRun&) = delete;

  /// Run on and write the next piece over `text` and `origins`, about a megabyte. Return false
  /// where nothing more comes: the run has stopped, or `refusal` says why the text ends here. Where
  /// `interrupted` stops the run, the machine says so.
  bool next(const std::function<bool()>& interrupted, std::string& text, FlatOrigins& origins);

  const Machine& machine() const { return machine_; }
  const std::optional<FlatRefusal>& refusal() const { return refusal_; }
  /// Return whether the run has come to an end that the text has too.
  bool ends() const;

 private:
  /// The block that is about to be executed.
  struct Coming {
    Address at = kNowhere;
    std::int64_t executed = -1;
    std::int32_t call = -1, repeat = 1;
    bool plain = false;  // a plain move, which is not observed
  };

  /// The blocks of a profile.
  struct Late {
    std::array<std::int64_t, 2> numbers{};
    std::vector<std::string> lines;
    std::vector<Address> blocks;
    std::int32_t call = -1, repeat = 1;
  };

  bool before_block(std::string& text, FlatOrigins& origins);
  void write_done(std::string& text, FlatOrigins& origins);
  bool write_block(std::string& text, FlatOrigins& origins);
  bool write_own(std::string& text, FlatOrigins& origins);
  bool write_restored(std::string& text, FlatOrigins& origins);
  bool write_words(std::string& text, FlatOrigins& origins, const Block& block,
                   const std::array<std::int64_t, 2>* profile = nullptr);
  bool write_for_other(std::string& text, FlatOrigins& origins, const Block& block,
                       OtherWriter& other);
  std::string assigned_name(std::int64_t number) const;
  std::optional<std::string> assigned_text(const Observer::Assigned& of) const;
  bool write_assigned(std::string& text, FlatOrigins& origins);
  void write_raised(std::string& text, FlatOrigins& origins);
  bool write_print(std::string& text, FlatOrigins& origins);
  void write_message(std::string& text, FlatOrigins& origins, bool same);
  bool print_fields(std::string& text, FlatOrigins& origins, std::string& statement);
  bool write_with_profile(std::string& text, FlatOrigins& origins, const Block& block,
                          const Profile& profile);
  bool number_profile(bool behind, std::array<std::int64_t, 2>& numbers, bool& is_new);
  void write_profile(std::string& text, FlatOrigins& origins, const Late& profile);
  void write_head(std::string& text, FlatOrigins& origins);
  void write_end(std::string& text, FlatOrigins& origins);
  std::string origin();
  void end_line(std::string& text, FlatOrigins& origins, bool has_origin = false);
  bool refuse(std::string reason);
  std::int32_t program_at(Address at);

  Machine machine_;
  BlockWriter blocks_;
  std::optional<OtherWriter> other_;
  const Code* for_;  // the control that the text is for: what it has and how it writes
  Observer observer_;
  bool comments_;
  Coming coming_;
  bool has_parts_ = false;  // some programs are a part of others
  bool over_ = false, begun_ = false;
  bool starts_over_ = false;          // the last block starts the program over by a code of its own
  std::int32_t program_ = 0;          // of the last block
  std::int64_t last_n_ = 0;           // the last number that was given to a block of a profile
  std::vector<std::string> profile_;  // the lines of the profile that the last block follows
  std::map<std::vector<std::string>, std::array<std::int64_t, 2>> profiles_;
  std::vector<Late> late_;  // profiles that stand after the end of the program
  bool taped_ = false;      // the text stands between two %
  std::optional<FlatRefusal> refusal_;
};

}  // namespace cncsub
