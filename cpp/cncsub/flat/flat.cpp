#include "cncsub/flat/flat.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cncsub/control/g_codes.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/motion/state/facts.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kPiece = 1 << 20;  // bytes of a piece of text

/// Return whether a modal call takes the words of the block that comes next.
bool takes_words(const State& s) {
  return !s.modals.empty() && s.modals.back().every_block && s.frames.back().modal < 0;
}

bool is_user_alarm(const Code& code, std::int64_t number) {
  return code.place(number).kind == VariableKind::UserAlarm;
}

/// Return whether a comment may hold a character on every control. It is no bracket, quote or line
/// end, which end it or begin another, no % that ends a tape, no comma that makes an order of it.
bool stands_in_comments(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || is_letter(c) || is_digit(c) ||
         std::string_view(" _-+.#").find(c) != std::string_view::npos;
}

/// Return a comment that says where a block comes from. A character of the program's name that
/// could end the comment is written as _.
std::string comment_of(const Code& code, const Block& block, std::int32_t program,
                       const Spelling::Around& around) {
  std::string text = " ";
  text += around.before;
  for (const char c : code.name_of(program)) text += stands_in_comments(c) ? c : '_';
  if (block.n >= 0) text += " N" + std::to_string(block.n);
  text += " LINE " + std::to_string(block.line);
  text += around.behind;
  return text;
}

/// Return what is written for words that are all vacant: their block counts as one without a move.
std::string idle_words(const MotionState& state, const Block& block) {
  const int code = state.modal[at(Group::Distance)].code;
  return block.mask != 0 && compensating(state) && code >= 0 ? code_name(code) : "";
}

/// Return the code that starts the program over or, where that ends it, ends it; empty where
/// another control has none.
std::string return_of(const Machine& machine, const OtherWriter* other) {
  const CallRules& calls = (other != nullptr ? other->machine() : machine).code().control->calls;
  const bool ends = machine.stop() == Stop::End;
  if (other != nullptr && ends) return other->end();
  const auto code = calls.roles.value.code_of(Role::Return);
  if (other != nullptr && (!code || calls.main_return.value == MainReturn::Ends)) return "";
  return code ? code->text() : "M99";
}

}  // namespace

FlatRun::FlatRun(const Machine& at_its_head, bool comments, const Machine* other)
    : machine_(at_its_head),
      blocks_(machine_),
      for_(other != nullptr ? &other->code() : &machine_.code()),
      comments_(comments) {
  if (other != nullptr) other_.emplace(machine_, *other);
  machine_.tell(&observer_);
  program_ = machine_.state().frames.front().program;
  const auto& programs = machine_.code().programs;
  has_parts_ = std::any_of(programs.begin(), programs.end(),
                           [](const Program& of) { return of.inside != kNoProgram; });
}

bool FlatRun::refuse(std::string reason) {
  if (!refusal_) refusal_ = {std::move(reason), coming_.at};
  return false;
}

std::int32_t FlatRun::program_at(Address at) {
  const Code& code = machine_.code();
  const Program& last = code.programs[static_cast<std::size_t>(program_)];
  if (has_parts_ || at < last.first || at > last.last) program_ = code.program_at(at);
  return program_;
}

const BlockCodes& codes_of(const Machine& machine, const Observer& observer, const Block& block) {
  if (observer.computed) return *observer.values.codes;
  if ((block.flags & Block::kListed) == 0) return kNoCodes;
  return machine.motion().view().facts.meanings->blocks[block.list];
}

bool FlatRun::ends() const {
  if (machine_.stop() != Stop::Alarm)
    return machine_.stop() == Stop::End || machine_.stop() == Stop::Cycles;
  // An alarm that the program may not raise ends no flat program either: it is refused.
  if (!machine_.alarm() || machine_.alarm()->cause != Cause::UserAlarm) return false;
  if (observer_.raised != nullptr) return true;
  return !observer_.assigned.empty() &&
         is_user_alarm(machine_.code(), observer_.assigned.back().number);
}

// ---- the run ----

bool FlatRun::next(const std::function<bool()>& interrupted, std::string& text,
                   FlatOrigins& origins) {
  text.clear();
  origins.clear();
  if (over_) return false;
  if (!begun_ && other_ && !other_->refusal().empty()) refuse(other_->refusal());
  if (!begun_) write_head(text, origins);
  begun_ = true;
  machine_.run(interrupted, [&](const Machine&) { return before_block(text, origins); });
  if (machine_.stop() == Stop::Alarm && observer_.print != nullptr && observer_.print->alarms)
    refuse("the program raises an alarm with a text of its own");
  over_ = machine_.stop() != Stop::Running || refusal_;
  if (over_ && !refusal_) {
    write_done(text, origins);
    if (!refusal_) write_end(text, origins);
  }
  machine_.take();
  return true;
}

/// Write the name of the program as it is written, with what a control puts around it: <NAME>,
/// %_N_NAME_MPF.
void FlatRun::write_head(std::string& text, FlatOrigins& origins) {
  const Code& code = machine_.code();
  const Program& main = code.programs[static_cast<std::size_t>(program_)];
  if (other_) {
    const std::string modes = other_->modes();
    text += other_->head(code.name_of(main)) + modes;
    for (const char c : modes)
      if (c == '\n') origins.add(program_, -1, main.line, -1, 1);
    return;
  }
  const std::string_view file = code.files[main.file].text.view();
  if (main.name_length == Program::kOfFile) {
    const std::size_t first = file.find_first_not_of(" \t\n", main.text);
    taped_ = first != std::string_view::npos && file[first] == '%';
    if (taped_) text += "%\n";
    return;
  }
  if (main.name_length == 0 || code.spelling->head.before.empty()) return;
  const std::string_view before = file.substr(main.text, main.name_at - main.text);
  const std::size_t end = main.name_at + main.name_length;
  text += before;
  text += file.substr(main.name_at, main.name_length);
  if (before.ends_with('<')) text += '>';
  if (before.starts_with("%_"))
    text += file.substr(end, std::min(file.find_first_of(" \t\r\n;", end), file.size()) - end);
  text += '\n';
}

/// Write the last block; return whether the piece is full, or the run cannot be written.
bool FlatRun::before_block(std::string& text, FlatOrigins& origins) {
  write_done(text, origins);
  const State& s = machine_.state();
  const Op op = machine_.code().blocks[s.pc].op;
  coming_.at = s.pc;
  coming_.executed = s.executed;
  coming_.call = s.frames.back().call;
  coming_.repeat = s.frames.back().repeat;
  coming_.plain = (op == Op::Linear || op == Op::Arc) && !takes_words(s);
  observer_.forget();
  if (other_) other_->begin_block();
  return refusal_ || text.size() >= kPiece;
}

/// Write what the last block did, if it is a step.
void FlatRun::write_done(std::string& text, FlatOrigins& origins) {
  if (coming_.executed < 0 || machine_.state().executed == coming_.executed) return;
  coming_.executed = -1;
  const bool goes_on = machine_.stop() == Stop::Running;
  if (starts_over_)
    refuse("a code starts the program over, and the flat program goes on after it");
  else if (goes_on && observer_.words != nullptr && observer_.words->op == Op::EndProgram)
    refuse("M02 or M30 returns from a subprogram, and the flat program would end there");
  else if (coming_.plain || observer_.any())
    write_block(text, origins);
}

/// Write the end, after the run has stopped.
void FlatRun::write_end(std::string& text, FlatOrigins& origins) {
  const bool cycles = machine_.stop() == Stop::Cycles;
  const bool returns = cycles || (machine_.stop() == Stop::End && observer_.returned);
  const bool said = observer_.words != nullptr && observer_.words->op == Op::EndProgram;
  if (returns && !starts_over_) {
    const std::string code = return_of(machine_, other_ ? &*other_ : nullptr);
    if (code.empty())
      refuse("the program starts over at its end, and " + for_->control->name +
             " does not do that");
    else
      end_line(text += code, origins);
  } else if (!said && !starts_over_ && machine_.stop() == Stop::End && !late_.empty()) {
    refuse("the profile of a cycle would follow a program that has no end");
  }
  for (const Late& profile : late_) write_profile(text, origins, profile);
  if (taped_) text += "%\n";
}

// ---- lines ----

/// Return where the last block comes from, where that is asked for.
std::string FlatRun::origin() {
  if (!comments_) return "";
  const Block& block = machine_.code().blocks[coming_.at];
  return comment_of(machine_.code(), block, program_at(coming_.at), for_->spelling->comment);
}

/// End a line that comes from the last block. `has_origin`: the line says so already.
void FlatRun::end_line(std::string& text, FlatOrigins& origins, bool has_origin) {
  if (!has_origin) text += origin();
  const Block& block = machine_.code().blocks[coming_.at];
  const std::int32_t program = program_at(coming_.at);
  text += '\n';
  origins.add(program, block.n, block.line, coming_.call, coming_.repeat);
}

namespace {

/// Return whether an M code saves or restores modes.
bool keeps_modes(const BlockCodes& codes) {
  return codes.has(Role::SaveModes) || codes.has(Role::ForgetModes) ||
         codes.has(Role::RestoreModes) || codes.has(Role::KeepModes);
}

/// Return the frame of the program as an assignment gives it; nothing where the control has none,
/// or in inches, in which frames as values are not computed.
std::optional<std::string> assigned_frame(const Machine& machine) {
  if (g20(machine.motion().state())) return std::nullopt;
  for (const Machine::ControlFrame& of : machine.control_frames())
    if (of.role == FrameInForce::Program && of.text.has_value())
      return of.name + "=" + of.text.value_or("");
  return std::nullopt;
}

}  // namespace

bool FlatRun::write_block(std::string& text, FlatOrigins& origins) {
  return write_own(text, origins) && write_restored(text, origins);
}

/// Write the codes and the frame that the return from a call has put in force again.
bool FlatRun::write_restored(std::string& text, FlatOrigins& origins) {
  for (const BlockCodes& codes : observer_.restored) {
    const std::size_t before = text.size();
    NcWords words;
    words.codes = &codes;
    if (other_ && !other_->write(text, Block(), words)) return refuse(other_->refused());
    for (const int code : codes.g())
      if (!other_) text += (text.size() == before ? "" : " ") + code_name(code);
    if (text.size() > before) end_line(text, origins);
  }
  if (!observer_.frame_restored) return true;
  const auto frame = other_ ? std::nullopt : assigned_frame(machine_);
  if (!frame)
    return refuse("a return brings back the frame of the caller, and a flat program has no calls");
  text += *frame;
  end_line(text, origins);
  return true;
}

bool FlatRun::write_own(std::string& text, FlatOrigins& origins) {
  if (!write_assigned(text, origins) || !write_print(text, origins)) return false;
  write_raised(text, origins);
  const Block* block = coming_.plain ? &machine_.code().blocks[coming_.at] : observer_.words;
  if (block == nullptr) return true;
  if (observer_.profile) return write_with_profile(text, origins, *block, *observer_.profile);
  const std::size_t before = text.size();
  if ((coming_.call >= 0 || other_) && keeps_modes(codes_of(machine_, observer_, *block)))
    return refuse(
        "M70 to M73 save and restore the modes of each call, and a flat program has no "
        "calls");
  if (!write_words(text, origins, *block)) return false;
  if (text.size() == before) return true;
  end_line(text, origins);
  starts_over_ = codes_of(machine_, observer_, *block).has(Role::StartOver);
  return true;
}

bool FlatRun::write_words(std::string& text, FlatOrigins& origins, const Block& block,
                          const std::array<std::int64_t, 2>* profile) {
  if (other_) return write_for_other(text, origins, block, *other_);
  const std::size_t before = text.size();
  const NcWords* values = observer_.computed ? &observer_.values : nullptr;
  const std::int32_t program = program_at(coming_.at);
  const bool written = profile != nullptr
                           ? blocks_.write_cycle(text, block, program, values, *profile)
                           : blocks_.write(text, block, program, values);
  if (!written)
    return refuse("the value of " + blocks_.failed() + " cannot be written as a number");
  if (text.size() == before) text += idle_words(machine_.motion().state(), block);
  const int most = machine_.code().control->reading.max_block_length.value;
  return most <= 0 || text.size() - before <= static_cast<std::size_t>(most) ||
         refuse("the block would be longer than the control allows");
}

bool FlatRun::write_for_other(std::string& text, FlatOrigins& origins, const Block& block,
                              OtherWriter& other) {
  const NcWords words = observer_.computed ? observer_.values : constant_words(machine_, block);
  std::string lines;
  if (!other.write(lines, block, words)) return refuse(other.refused());
  for (std::size_t end; (end = lines.find('\n')) != std::string::npos; lines.erase(0, end + 1)) {
    text.append(lines, 0, end);
    end_line(text, origins);
  }
  text += lines;
  return true;
}

}  // namespace cncsub
