// Expressions that stand in no program, compiled beside the programs of a library.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/library.hpp"

namespace cncsub {

namespace {

/// Return what an expression needs that the programs do not have: it must not add a variable, of
/// which a run has no value, nor a text, whose number a run may have given to another one.
std::optional<Fault> adds_to(const Code& code, const Code& with, std::uint32_t at) {
  const auto refused = [at](std::string detail) {
    return Fault{Cause::IllegalVariable, at, 1, std::move(detail)};
  };
  if (with.locals != code.locals || with.commons != code.commons || with.elements != code.elements)
    return refused("the programs have no variable of this name");
  if (with.texts.size() != code.texts.size())
    return refused("it makes a text of constants, which stands in none of the programs");
  return std::nullopt;
}

/// Read expressions into a code of their own.
ExpressionList read_expressions(std::shared_ptr<Code> with,
                                const std::vector<std::pair<std::string, std::int32_t>>& texts) {
  InterruptCheck never;
  Builder to(*with, never);
  std::string all = "\n";
  for (const auto& [text, program] : texts) all += text + '\n';
  Program holder;
  holder.file = static_cast<std::uint32_t>(with->files.size());
  holder.line = 1;
  with->files.push_back({"expression", "expression", FileText(all), false});
  const std::string_view file = with->files.back().text.view();
  const Dialect& dialect = *find_dialect(with->control->dialect);  // it has read the programs
  to.begin_program(holder);
  ExpressionList compiled;
  Block block;
  block.text = 1;
  for (const auto& [text, program] : texts) {
    ++block.line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), kLookedAt));
    ExpressionList::One& one = compiled.list.emplace_back();
    one.block = to.next_address();
    one.fault = dialect.read_expression(
        to, {file.substr(block.text, text.size()), holder.file, block.text, program},
        one.expression, one.type);
    to.append(block);
    block.text += static_cast<std::uint32_t>(text.size() + 1);
  }
  to.end_program(block.text, block.line + 1);
  compiled.code = std::move(with);
  return compiled;
}

/// Return the code with the names that another one has more, each as the local #0, which is vacant:
/// what no program names nobody has set.
std::shared_ptr<Code> with_vacant_names(const Code& code, const Code& more) {
  auto with = std::make_shared<Code>(code);
  with->named_variables = more.named_variables;
  with->named_places = more.named_places;
  for (std::size_t i = code.named_variables.size(); i < with->named_variables.size(); ++i) {
    with->named_variables[i].common = false;
    with->named_variables[i].index = 0;
  }
  return with;
}

}  // namespace

ExpressionList compile_expressions(const Code& code,
                                   const std::vector<std::pair<std::string, std::int32_t>>& texts) {
  if (texts.empty()) return {};
  ExpressionList compiled = read_expressions(std::make_shared<Code>(code), texts);
  if (compiled.code->named_variables.size() > code.named_variables.size())
    compiled = read_expressions(with_vacant_names(code, *compiled.code), texts);
  for (ExpressionList::One& one : compiled.list)
    if (!one.fault)
      one.fault = adds_to(code, *compiled.code, compiled.code->blocks[one.block].text);
  return compiled;
}

}  // namespace cncsub
