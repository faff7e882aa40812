// The compiler of the blocks that declare: PROC, DEF and EXTERN.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cncsub/dialect/sinumerik/expression.hpp"

namespace cncsub::sinumerik {

/// A type and a name as they are declared, and the value after their equals sign.
struct Declared {
  Definition definition;
  std::string name;  // in capitals
  std::uint32_t at = 0, width = 1;
  std::optional<Value> value;
  std::vector<Statement> elements;  // of an array: the assignments of its list
  bool is_parameter = false, by_reference = false;
  std::vector<std::int32_t> declared_extents;  // of a parameter; 0: any
};

class DeclarationReader {
 public:
  DeclarationReader(Builder& to, Line& line, ExpressionReader& expression, Definitions& definitions)
      : to_(to), line_(line), expression_(expression), definitions_(definitions) {}

  /// Return whether a declaration stands here. It is compiled into the block.
  bool read(Block& block);
  /// Begin a program, whose definitions come first; end them by a block that defines nothing.
  void begin_definitions() { definitions_over_ = false; }
  void end_definitions() { definitions_over_ = true; }

 private:
  bool proc(Block& block);
  bool parameter(Block& block, std::vector<Statement>& conversions);
  bool attributes(Block& block);
  bool def(Block& block);
  bool macro(Block& block);
  bool is_of_definitions();
  bool is_global(Block& block, bool& global);
  void attributes_of_data();
  bool add(Block& block, Declared& declared, std::vector<Statement>& statements);
  bool type(Block& block, Definition& definition);
  bool name(Block& block, Declared& declared, std::size_t shortest);
  bool extents(Block& block, Declared& declared);
  bool declared(Block& block, Declared& declared, std::size_t shortest);
  bool initial_value(Block& block, Declared& declared);
  void place(Declared& declared);
  void place_parameter(Declared& declared);
  bool extent(Block& block, const Declared& declared, std::uint32_t at, std::int32_t& extent);
  bool lacks_end(Block& block);
  bool refuse(Block& block, Cause cause, std::string detail, std::uint32_t at);
  bool refuse(Block& block);
  Statement assignment_of(const Declared& declared);
  bool first_value(Block& block, const Declared& declared);
  void write(Block& block, const std::vector<Statement>& statements);

  Builder& to_;
  Line& line_;
  ExpressionReader& expression_;
  Definitions& definitions_;
  bool definitions_over_ = false;
};

}  // namespace cncsub::sinumerik
