// What a flat program writes of variables, messages and alarms.
#include "cncsub/flat/flat.hpp"
#include "cncsub/motion/query.hpp"

namespace cncsub {

namespace {

/// Return whether the value of a variable is seen from outside the program.
bool has_effect(const Code& code, std::int64_t number) {
  const VariablePlace place = code.place(number);
  switch (place.kind) {
    case VariableKind::Local:
    case VariableKind::Common:
    case VariableKind::Kept:
    case VariableKind::LevelImage:
    case VariableKind::Vacant:
    case VariableKind::Milliseconds:
    case VariableKind::Hours:
      return false;
    default:
      return place.range != nullptr;
  }
}

bool is_frame(VariableKind kind) {
  return kind == VariableKind::StoredFrame || kind == VariableKind::FrameInForce;
}

}  // namespace

/// Write the alarm of G65 H99.
void FlatRun::write_raised(std::string& text, FlatOrigins& origins) {
  if (observer_.raised == nullptr) return;
  const HCode& h = *observer_.raised;
  const Code& code = machine_.code();
  const Program& program = code.programs[static_cast<std::size_t>(program_at(coming_.at))];
  text += "G65 H99 P" + std::string(NumberText(observer_.raised_number).text());
  if (h.text_length > 0)
    text +=
        "(" + std::string(code.files[program.file].text.view().substr(h.text, h.text_length)) + ")";
  end_line(text, origins);
}

/// Return how a program of the other control writes a variable; nothing where it has none, or no
/// statement that assigns it.
std::string FlatRun::assigned_name(std::int64_t number) const {
  const Code& there = *for_;
  const Spelling& spelling = *there.spelling;
  const bool numbered =
      spelling.numbered || (spelling.variable_name != nullptr &&
                            !spelling.variable_name(*there.control, number).empty());
  if (!numbered || there.place(number).kind != machine_.code().place(number).kind ||
      there.lacking.test(static_cast<std::size_t>(StatementKind::Variables)))
    return "";
  return spelling.name_of_variable(*there.control, number);
}

/// Return what a variable gets: of a frame what it is after the block, which may have written a
/// part of it. Nothing where it cannot be written.
std::optional<std::string> FlatRun::assigned_text(const Observer::Assigned& of) const {
  const VariableKind kind = machine_.code().place(of.number).kind;
  if (is_frame(kind)) return machine_.frame_text(of.number);
  if (kind == VariableKind::ToolName) return "\"" + machine_.text(of.value) + "\"";
  return value_text(of.value, *for_);
}

bool FlatRun::write_assigned(std::string& text, FlatOrigins& origins) {
  const Code& code = machine_.code();
  for (const Observer::Assigned& of : observer_.assigned) {
    if (!has_effect(code, of.number)) continue;
    const std::string name = assigned_name(of.number);
    if (name.empty())
      return refuse(code.spelling->name_of_variable(*code.control, of.number) +
                    " gets a value, and the control has no statement that assigns it");
    const VariableKind kind = code.place(of.number).kind;
    const auto value = assigned_text(of);
    if (!value)
      return refuse("a frame of the control gets a value that no functions make: it shears");
    text += name + "=" + *value;
    if (kind == VariableKind::UserAlarm || kind == VariableKind::Message)
      text += "(" + of.comment + ")";
    end_line(text, origins);
  }
  return true;
}

/// Write the fields of DPRNT. Their values go to locals, for it prints no numbers.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
bool FlatRun::print_fields(std::string& text, FlatOrigins& origins, std::string& statement) {
  const Code& code = machine_.code();
  std::size_t printed = 0;
  for (const PrintField& field : observer_.print->fields) {
    if (!field.is_variable) {
      for (const char c : field.text) statement += c == ' ' ? '*' : c;
      continue;
    }
    const double value = observer_.printed[printed++];
    if (field.is_text) {
      for (const char c : machine_.text(value)) statement += c == ' ' ? '*' : c;
      continue;
    }
    const auto local = static_cast<std::int64_t>(printed);
    if (!code.place(local).is_local())
      return refuse("what is printed has more values than there are local variables");
    const std::string name = "#" + std::to_string(local);
    text += name + "=" + value_text(value, code);
    end_line(text, origins);
    const int digits = field.whole_digits * 10 + field.decimals;
    statement += name + "[" + (digits < 10 && !observer_.print->binary ? "0" : "") +
                 std::to_string(digits) + "]";
  }
  return true;
}

bool FlatRun::write_print(std::string& text, FlatOrigins& origins) {
  const Spelling::Around& message = for_->spelling->message;
  if (observer_.device != Op::Words) {
    text += observer_.device == Op::OpenOutput ? "POPEN" : "PCLOS";
    end_line(text, origins);
  }
  if (observer_.print == nullptr) return true;
  if (observer_.print->last_number > 0)
    return refuse("the program raises an alarm with a number of its own");
  const std::string_view command = observer_.print->command;
  const bool same = !command.empty() && machine_.code().spelling == for_->spelling;
  if (observer_.print->logs() && !same)
    return refuse("a log is written, and the other control has none");
  std::string statement = observer_.print->binary ? "BPRNT[" : "DPRNT[";
  if (message.before.empty()) {
    const auto lacking = for_->lacks(StatementKind::Dprnt, 0);
    if (lacking && lacking->cause == Cause::StatementNotAvailable)
      return refuse("a message is shown, and the flat program has no statement for it");
    if (!print_fields(text, origins, statement)) return false;
    text += statement + "]";
    end_line(text, origins);
    return true;
  }
  write_message(text, origins, same);
  return true;
}

/// Write the message that was shown; `same`: in the language of the program.
void FlatRun::write_message(std::string& text, FlatOrigins& origins, bool same) {
  const Spelling::Around& message = for_->spelling->message;
  // Where a message is a comment, the last comment of a line counts.
  const bool last = message.before.starts_with(for_->spelling->comment.before);
  if (const std::string comment = last ? origin() : ""; !comment.empty())
    text += comment.substr(1) + " ";
  const auto& messages = machine_.trace().messages;
  // The text of a log begins with its command.
  if (!same)
    text += message.before;
  else
    text += "(" + std::string(observer_.print->logs() ? "" : observer_.print->command);
  text += messages[messages.size() - 1];
  text += message.behind;
  end_line(text, origins, last);
}

}  // namespace cncsub
