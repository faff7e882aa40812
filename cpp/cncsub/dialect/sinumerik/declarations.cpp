#include "cncsub/dialect/sinumerik/declarations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cncsub/dialect/sinumerik/keywords.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr std::size_t kLongestName = 31;  // [SONE p.383, naming rules]

struct TypeName {
  std::string_view word;
  Type type;
};
constexpr TypeName kTypes[] = {
    {"INT", Type::Int},       {"REAL", Type::Real}, {"BOOL", Type::Bool},  {"CHAR", Type::Char},
    {"STRING", Type::String}, {"AXIS", Type::Axis}, {"FRAME", Type::Frame}};

constexpr std::int32_t kMostElements = 100'000;  // of the arrays of a program

// Words after the list of PROC. Only SAVE changes what runs.
constexpr std::string_view kAttributes[] = {"SAVE",  "DISPLOF", "DISPLON", "ACTBLOCNO", "SBLOF",
                                            "SBLON", "PREPRO",  "ICYCOF",  "ICYCON"};

}  // namespace

DefinedVariable::Type shown_type(Type type) {
  switch (type) {
    case Type::Int:
      return DefinedVariable::Type::Int;
    case Type::Bool:
      return DefinedVariable::Type::Bool;
    case Type::Char:
      return DefinedVariable::Type::Char;
    case Type::String:
      return DefinedVariable::Type::Text;
    case Type::Axis:
      return DefinedVariable::Type::Axis;
    case Type::Frame:
      return DefinedVariable::Type::Frame;
    default:
      return DefinedVariable::Type::Real;
  }
}

std::optional<Type> type_named(std::string_view word) {
  for (const TypeName& of : kTypes)
    if (of.word == word) return of.type;
  return std::nullopt;
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
  if (word == "DEFINE") return macro(block);
  if (word != "PROC" && word != "DEF" && word != "EXTERN" && word != "REDEF") return false;
  const std::uint32_t at = line_.offset();
  line_.pass(word.size());
  if (word == "DEF" && definitions_over_)
    return refuse(block, Cause::DefinitionLate,
                  "definitions stand at the beginning of their program", at),
           true;
  if (word == "DEF") return def(block), true;
  // EXTERN says in advance what a PROC says, and REDEF who may write a variable and when it is
  // reset.
  if (word == "EXTERN" || word == "REDEF") {
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
  declared.is_parameter = true;
  declared.by_reference = formal.by_reference;
  const Definition& definition = declared.definition;
  if (!type(block, declared.definition)) return false;
  if (!this->declared(block, declared, 1)) return false;
  formal.variable = definition.local;
  formal.reference = definition.reference;
  formal.extents = declared.declared_extents;
  formal.type = shown_type(definition.type);
  if (declared.value && declared.value->computed)
    return refuse(block, Cause::CodeNotComputed, "a computed default value is not computed here",
                  declared.at);
  if (declared.value) formal.otherwise = declared.value->number;
  to_.parameter(formal);
  if (declared.value && definition.reference >= 0)
    return refuse(block, Cause::StatementFormat, "a variable of the caller has its own value",
                  declared.value->at);
  if (definition.type == Type::Real || definition.reference >= 0 || definition.type == Type::Frame)
    return true;
  Statement conversion = assignment_of(declared);
  to_.expressions().begin();
  expression_.push_converted(definition);
  conversion.expression = to_.expressions().end(declared.at, declared.width);
  conversions.push_back(conversion);
  return true;
}

/// Read the words after the list: SAVE DISPLOF ACTBLOCNO SBLOF.
bool DeclarationReader::attributes(Block& block) {
  while (!line_.at_end()) {
    const std::string word = capitals(line_.name());
    if (!is_among(kAttributes, word)) return !lacks_end(block);
    line_.pass(word.size());
    if (word == "SAVE") to_.program().keeps_modes = true;
  }
  return true;
}

// ---- both ----

/// Read a type, and the length of a STRING.
bool DeclarationReader::type(Block& block, Definition& definition) {
  const std::uint32_t at = line_.offset();
  const std::string word = capitals(line_.name());
  const std::optional<Type> found = type_named(word);
  line_.pass(word.size());
  if (!found) return refuse(block, Cause::StatementFormat, "a type is missing: INT, REAL, ...", at);
  definition.type = *found;
  if (*found != Type::String || !line_.take('[')) return true;
  Value length;
  if (line_.peek() == ']') return line_.take(']');  // of a parameter: as long as the text
  if (!expression_.value(length)) return refuse(block);
  if (!line_.take(']')) return refuse(block, Cause::BracketNotClosed, "] is missing", at);
  if (length.computed || length.number < 1 || length.number > kLongestText)
    return refuse(block, Cause::ValueOutOfRange, "a STRING has 1 to 200 characters", at);
  definition.length = to_whole<std::int32_t>(length.number);
  return true;
}

/// Read a name of at least so many characters.
bool DeclarationReader::name(Block& block, Declared& declared, std::size_t shortest) {
  declared.at = line_.offset();
  const std::string_view name = line_.name();
  declared.name = capitals(name);
  line_.pass(name.size());
  declared.width = line_.width_from(declared.at);
  if (name.size() < shortest || name.size() > kLongestName ||
      (name.size() > 1 && is_digit(name[1])))
    return refuse(block, Cause::IllegalVariableName,
                  "a name has 2 to 31 characters, the first two are letters or _", declared.at);
  // A cycle may name its parameters as it likes.
  if (shortest > 1 && is_keyword(declared.name))
    return refuse(block, Cause::IllegalVariableName,
                  declared.name + " is a word of the language, and no name of a variable",
                  declared.at);
  if (!definitions_.defines(declared.name, declared.definition.global)) return true;
  return refuse(block, Cause::VariableGivenTwice, declared.name + " is defined already",
                declared.at);
}

/// Read one extent of an array; 0 where a parameter takes any.
bool DeclarationReader::extent(Block& block, const Declared& declared, std::uint32_t at,
                               std::int32_t& extent) {
  extent = 0;
  if (line_.peek() == ']' || line_.peek() == ',')
    return declared.is_parameter ||
           refuse(block, Cause::StatementFormat, "the size of the array is missing", at);
  Value value;
  if (!expression_.value(value)) return refuse(block);
  if (value.computed)
    return refuse(block, Cause::CodeNotComputed, "a computed size is not computed here", at);
  const double whole = std::round(value.number);
  if (!(whole >= 1)) return refuse(block, Cause::ValueOutOfRange, "an array has elements", at);
  extent = to_whole<std::int32_t>(whole);
  return true;
}

/// Read the extents of an array, whose bracket stands here.
bool DeclarationReader::extents(Block& block, Declared& declared) {
  const std::uint32_t at = line_.offset();
  Definition& definition = declared.definition;
  line_.take('[');
  double elements = 1;
  do {
    std::int32_t one = 0;
    if (!extent(block, declared, at, one)) return false;
    if (definition.dimensions == Definition::kMostDimensions)
      return refuse(block, Cause::StatementFormat, "an array has at most three dimensions", at);
    elements *= std::max(one, 1);
    if (definitions_.elements + elements > kMostElements)
      return refuse(block, Cause::CodeNotComputed,
                    "cncsub holds 100,000 elements of the arrays of a program", at);
    definition.extents[definition.dimensions++] = one;
  } while (line_.take(','));
  return line_.take(']') || refuse(block, Cause::BracketNotClosed, "] is missing", at);
}

/// Read a name, of at least so many characters, and its value. The name is defined from here on.
bool DeclarationReader::declared(Block& block, Declared& declared, std::size_t shortest) {
  if (!name(block, declared, shortest)) return false;
  if (line_.peek() == '[' && !extents(block, declared)) return false;
  if (declared.is_parameter)
    place_parameter(declared);
  else
    place(declared);
  if (line_.take('=') && !initial_value(block, declared)) return false;
  if (declared.definition.type != Type::Frame)
    to_.names().defined({shown_type(declared.definition.type), declared.definition.global,
                         declared.definition.local, declared.definition.shape(), declared.name,
                         declared.definition.reference},
                        declared.definition.global);
  definitions_.add(declared.name, declared.definition);
  if (declared.value) expression_.note_assigned(declared.definition);
  return true;
}

/// Give a parameter its place, and one that stands for a variable or an array of the caller the
/// locals that say for which.
void DeclarationReader::place_parameter(Declared& declared) {
  Definition& definition = declared.definition;
  const std::uint32_t named = to_.names().variable(declared.name, false);
  definition.local = to_.code().named_variables[named].index;
  if (definition.is_array()) {
    declared.declared_extents = definition.shape();
    definition.extents = {};
    constexpr auto kExtents = static_cast<std::int32_t>(Definition::kMostDimensions);
    definition.reference = to_.names().hidden(declared.name + "[]", 2 + kExtents);
  } else if (declared.by_reference) {
    definition.reference = to_.names().hidden(declared.name, 1);
  }
}

/// Give a variable its place.
void DeclarationReader::place(Declared& declared) {
  Definition& definition = declared.definition;
  const std::uint32_t named =
      to_.names().variable(declared.name, definition.global && !definition.is_array());
  if (!definition.is_array()) {
    definition.local = to_.code().named_variables[named].index;
  } else if (definition.global) {
    definition.local = to_.names().commons(definition.size());
  } else {
    definition.local = definitions_.elements;
    definitions_.elements += definition.size();
    to_.names().elements(definitions_.elements);
  }
}

/// Read the value after the equals sign. What is not computed is passed over: its use is refused.
bool DeclarationReader::initial_value(Block& block, Declared& declared) {
  const Definition& definition = declared.definition;
  const std::uint32_t at = line_.offset();
  if (definition.is_array()) {
    Statement first = assignment_of(declared);
    if (!expression_.is_list(true))
      return refuse(block, Cause::CodeNotComputed,
                    "one value for an array is not computed here: write REP(...)", at);
    return expression_.elements(definition, first, declared.elements) || refuse(block);
  }
  Value value;
  if (!expression_.value_of(definition, value)) return refuse(block);
  declared.value = value;
  return true;
}

Statement DeclarationReader::assignment_of(const Declared& declared) {
  const Definition& definition = declared.definition;
  Value nothing;
  nothing.at = declared.at;
  nothing.width = declared.width;
  const Value& value = declared.value ? *declared.value : nothing;
  using Target = Statement::Target;
  Statement statement;
  statement.target = definition.is_array() ? Target::Element : Target::Local;
  statement.index = definition.local;
  statement.variable_at = declared.at;
  statement.variable_width = declared.width;
  statement.expression = to_.expressions().expression_of(value);
  statement.at = value.at;
  statement.width = value.width;
  if (!definition.is_array()) return statement;
  statement.number = definition.size();
  statement.variable = statement.expression;  // the first element: 0
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
