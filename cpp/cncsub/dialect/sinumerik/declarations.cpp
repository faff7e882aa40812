#include "cncsub/dialect/sinumerik/declarations.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cncsub::sinumerik {

namespace {

constexpr std::size_t kLongestName = 31;  // [SONE p.383, naming rules]

struct TypeName {
  std::string_view word;
  Type type;
  const char* uncomputed;
};
constexpr TypeName kTypes[] = {
    {"INT", Type::Int, nullptr},          {"REAL", Type::Real, nullptr},
    {"BOOL", Type::Bool, nullptr},        {"CHAR", Type::Char, nullptr},
    {"STRING", Type::String, "a STRING"}, {"AXIS", Type::Axis, "an AXIS"},
    {"FRAME", Type::Frame, "a FRAME"}};

// Words after the list of PROC. Only SAVE changes what runs.
constexpr std::string_view kAttributes[] = {"SAVE",  "DISPLOF", "DISPLON", "ACTBLOCNO", "SBLOF",
                                            "SBLON", "PREPRO",  "ICYCOF",  "ICYCON"};

/// Pass over brackets, from the first one on, to the one that closes it.
bool pass_brackets(Line& line, char open, char close) {
  int depth = 0;
  for (char c = line.peek(); c != '\0'; c = line.peek()) {
    if (c == '"') {
      line.pass_quoted();
      continue;
    }
    line.pass(1);
    depth += c == open ? 1 : c == close ? -1 : 0;
    if (depth == 0) return true;
  }
  return false;
}

}  // namespace

std::optional<Type> type_named(std::string_view word) {
  for (const TypeName& of : kTypes)
    if (of.word == word) return of.type;
  return std::nullopt;
}

const char* Definition::uncomputed() const {
  if (array) return "an array";
  for (const TypeName& of : kTypes)
    if (of.type == type) return of.uncomputed;
  return nullptr;
}

bool DeclarationReader::refuse(Block& block, Cause cause, std::string detail, std::uint32_t at) {
  to_.refuse(block, {cause, at, line_.width_from(at), std::move(detail)});
  return false;
}

bool DeclarationReader::refuse(Block& block) {
  if (auto fault = std::exchange(expression_.fault, std::nullopt))
    to_.refuse(block, std::move(*fault));
  return false;
}

bool DeclarationReader::lacks_end(Block& block) {
  if (line_.at_end()) return false;
  const std::uint32_t at = line_.offset();
  line_.pass(first_character(line_.rest()).size());
  return !refuse(block, Cause::StatementFormat, "nothing may follow the declaration", at);
}

bool DeclarationReader::read(Block& block) {
  const std::string word = capitals(line_.name());
  if (word != "PROC" && word != "DEF" && word != "EXTERN") return false;
  const std::uint32_t at = line_.offset();
  line_.pass(word.size());
  if (word == "DEF") return def(block), true;
  if (word == "EXTERN") {  // says in advance what a PROC says
    line_.pass(line_.rest().size());
    to_.drop(at, line_.width_from(at));
    return write(block, {}), true;
  }
  if (to_.next_address() != to_.program().first)
    return refuse(block, Cause::StatementFormat, "PROC is the first block of its program", at),
           true;
  return proc(block), true;
}

// ---- PROC ----

bool DeclarationReader::proc(Block& block) {
  const std::uint32_t at = line_.offset();
  Program& program = to_.program();
  program.first_parameter = to_.next_parameter();
  if (line_.name().empty()) return refuse(block, Cause::StatementFormat, "PROC without a name", at);
  line_.pass(line_.name().size());
  std::vector<Statement> conversions;
  if (line_.take('(') && !line_.take(')')) {
    do
      if (!parameter(block, conversions)) return false;
    while (line_.take(','));
    if (!line_.take(')'))
      return refuse(block, Cause::BracketNotClosed, ") is missing", line_.offset());
  }
  if (!attributes(block)) return false;
  return write(block, conversions), true;
}

/// Read VAR REAL DEPTH, or INT COUNT=1.
bool DeclarationReader::parameter(Block& block, std::vector<Statement>& conversions) {
  FormalParameter formal;
  if (capitals(line_.name()) == "VAR") {
    line_.pass(3);
    formal.by_reference = true;
  }
  Declared declared;
  if (!type(block, declared.definition.type)) return false;
  if (!this->declared(block, declared, 1)) return false;
  const Definition& definition = declared.definition;
  formal.variable = definition.local;
  formal.is_text = definition.type == Type::String;
  if (declared.value && declared.value->computed)
    return refuse(block, Cause::CodeNotComputed, "a computed default value is not computed here",
                  declared.at);
  if (declared.value) formal.otherwise = declared.value->number;
  to_.parameter(formal);
  if (definition.type == Type::Real || definition.uncomputed() != nullptr) return true;
  Statement conversion = assignment_of(declared);
  to_.expressions().begin();
  expression_.push(definition);
  expression_.convert(definition.type);
  conversion.expression = to_.expressions().end(declared.at, declared.width);
  conversions.push_back(conversion);
  return true;
}

/// Read the words after the list: SAVE DISPLOF ACTBLOCNO SBLOF.
bool DeclarationReader::attributes(Block& block) {
  while (!line_.at_end()) {
    const std::string word = capitals(line_.name());
    if (std::find(std::begin(kAttributes), std::end(kAttributes), word) == std::end(kAttributes))
      return !lacks_end(block);
    line_.pass(word.size());
    if (word == "SAVE") to_.program().keeps_modes = true;
  }
  return true;
}

// ---- DEF ----

/// Read DEF INT COUNT=1, LAST. A variable without a value is 0.
bool DeclarationReader::def(Block& block) {
  const std::uint32_t at = line_.offset();
  const std::string first = capitals(line_.name());
  if (first == "NCK" || first == "CHAN") {
    line_.pass(first.size());
    return refuse(block, Cause::CodeNotComputed,
                  "DEF " + first + ", global user data, is not computed here", at);
  }
  Type of{};
  if (!type(block, of)) return false;
  std::vector<Statement> statements;
  do {
    Declared declared;
    declared.definition.type = of;
    if (!this->declared(block, declared, 2)) return false;
    if (declared.definition.uncomputed() == nullptr) statements.push_back(assignment_of(declared));
  } while (line_.take(','));
  if (lacks_end(block)) return false;
  return write(block, statements), true;
}

// ---- both ----

/// Read a type, and the length of a STRING.
bool DeclarationReader::type(Block& block, Type& type) {
  const std::uint32_t at = line_.offset();
  const std::string word = capitals(line_.name());
  const std::optional<Type> found = type_named(word);
  line_.pass(word.size());
  if (!found) return refuse(block, Cause::StatementFormat, "a type is missing: INT, REAL, ...", at);
  type = *found;
  if (type == Type::String && line_.peek() == '[' && !pass_brackets(line_, '[', ']'))
    return refuse(block, Cause::BracketNotClosed, "] is missing", at);
  return true;
}

/// Read a name, of at least so many characters, and its value. The name is defined from here on.
bool DeclarationReader::declared(Block& block, Declared& declared, std::size_t shortest) {
  declared.at = line_.offset();
  const std::string_view name = line_.name();
  declared.name = capitals(name);
  line_.pass(name.size());
  declared.width = line_.width_from(declared.at);
  if (name.size() < shortest || name.size() > kLongestName ||
      (name.size() > 1 && is_digit(name[1])))
    return refuse(block, Cause::IllegalVariableName,
                  "a name has 2 to 31 characters, the first two are letters or _", declared.at);
  if (definitions_.find(declared.name) != nullptr)
    return refuse(block, Cause::VariableGivenTwice, declared.name + " is defined already",
                  declared.at);
  Definition& definition = declared.definition;
  definition.array = line_.peek() == '[';
  if (definition.array && !pass_brackets(line_, '[', ']'))
    return refuse(block, Cause::BracketNotClosed, "] is missing", declared.at);
  if (line_.take('=') && !initial_value(block, declared)) return false;
  const std::uint32_t place = to_.names().variable(declared.name, false);
  definition.local = to_.code().named_variables[place].index;
  definitions_.add(declared.name, definition);
  return true;
}

/// Read the value after the equals sign. What is not computed is passed over: its use is refused.
bool DeclarationReader::initial_value(Block& block, Declared& declared) {
  const std::uint32_t at = line_.offset();
  const Definition& definition = declared.definition;
  if (definition.uncomputed() == nullptr) {
    Value value;
    if (!expression_.value_of(definition.type, value)) return refuse(block);
    declared.value = value;
    return true;
  }
  if (line_.peek() == '"') {
    line_.pass_quoted();
  } else {
    const std::string_view name = line_.name();
    line_.pass(name.size());
    const bool closed = line_.peek() != '(' || pass_brackets(line_, '(', ')');
    if (name.empty() || !closed)
      return refuse(block, Cause::CodeNotComputed, "this value is not computed here", at);
  }
  return true;
}

Statement DeclarationReader::assignment_of(const Declared& declared) {
  Value nothing;
  nothing.at = declared.at;
  nothing.width = declared.width;
  const Value& value = declared.value ? *declared.value : nothing;
  Statement statement;
  statement.target = Statement::Target::Local;
  statement.index = declared.definition.local;
  statement.variable_at = declared.at;
  statement.variable_width = declared.width;
  statement.expression = to_.expressions().expression_of(value);
  statement.at = value.at;
  statement.width = value.width;
  return statement;
}

void DeclarationReader::write(Block& block, const std::vector<Statement>& statements) {
  if (statements.empty())
    to_.words(block, {});
  else if (statements.size() == 1)
    assign(to_, block, statements.front());
  else
    to_.parallel_assign(block, statements, nullptr, nullptr);
}

}  // namespace cncsub::sinumerik
