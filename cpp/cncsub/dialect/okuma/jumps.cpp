#include "cncsub/dialect/okuma/jumps.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/text/scan.hpp"

namespace cncsub::okuma {

namespace {

/// Return a name without the leading zeros of its number: N10 for N0010.
std::string without_zeros(const std::string& name) {
  std::size_t zeros = 1;
  while (zeros + 1 < name.size() && name[zeros] == '0') ++zeros;
  return "N" + name.substr(zeros);
}

}  // namespace

std::string Jumps::key_of(const std::string& name, std::size_t program) {
  return name + '\n' + std::to_string(program);
}

void Jumps::begin() {
  named_.clear();
  names_.clear();
  numbers_.clear();
  jumps_.clear();
}

void Jumps::add(const std::string& name, const Jump& jump) {
  const Address address = to_.next_address();
  if (!name.empty()) {
    Named& of = named_[key_of(name, program())];
    of.again = of.first != kNowhere;
    if (!of.again) of.first = address;
    names_.insert(name);
    numbers_.insert(without_zeros(name));
  }
  if (jump.is) jumps_.push_back({address, program(), jump});
}

void Jumps::resolve() {
  for (const Met& met : jumps_) {
    if (to_.interrupt().requested(InterruptCheck::kBlock)) return;
    resolve(met);
  }
}

void Jumps::resolve(const Met& met) {
  const std::string& name = met.jump.target.name;
  if (to_.block(met.address).op == Op::Fault) return;
  const auto found = named_.find(key_of(name, met.program));
  if (found != named_.end() && !found->second.again) {
    to_.record<Statement>(to_.block(met.address).aux).to = found->second.first;
    return;
  }
  if (found != named_.end())
    return refuse(met, Cause::CodeNotComputed,
                  "several blocks have this name: no source says which of them is meant");
  if (names_.contains(name))
    return refuse(met, Cause::CodeNotComputed,
                  "the block stands in another program of the file: no source says whether a jump "
                  "goes there");
  if (numbers_.contains(without_zeros(name)))
    return refuse(met, Cause::CodeNotComputed,
                  "a block has the name with other zeros: no source says whether it is the same");
  refuse(met, Cause::JumpTargetNotFound, "no block of the program has this name");
}

/// Refuse a jump where it is made.
void Jumps::refuse(const Met& met, Cause cause, std::string detail) {
  Block& block = to_.block(met.address);
  Block instead = block;
  instead.op = Op::Words;
  to_.refuse(instead, {cause, met.jump.target.at, met.jump.target.width, std::move(detail)});
  if (!met.jump.conditional) {
    block = instead;
    return;
  }
  Statement condition = to_.record<Statement>(block.aux);
  condition.then = to_.keep(instead);
  to_.become(block, Op::IfThen, condition);
}

}  // namespace cncsub::okuma
