// Frames as values, and the frames of the control.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub::sinumerik {

/// Read CTRANS(X,10,Y,5), CFINE, CROT, CSCALE or CMIRROR(X), whose name stands here.
bool is_frame_function(std::string_view name);
Read read_frame_function(OpenExpression& open, std::string_view name, int depth);
/// Read the component of FRAME[X,TR] after the frame that was read last, or nothing: then it is the
/// whole frame.
Read read_frame_part(OpenExpression& open, int depth);
/// Read [X,TR]=5 after a variable: the frame with that value in it.
bool write_frame_part(OpenExpression& open, const Instruction& frame, Value& value);

/// Read $P_UIFR[1], $P_PFRAME[X,TR] or $P_UIFRNUM, whose name is passed.
bool is_frame_variable(std::string_view name);
/// Return the names of the frames that no machine here has, without their $.
std::vector<std::string_view> frames_of_no_machine();
/// Return the name of a frame of the control, $P_UIFR[1], by its place among those of a kind; empty
/// where the kind is none of frames.
std::string name_of_frame(VariableKind kind, std::int32_t index);
Read read_control_frame(OpenExpression& open, std::string_view name, std::uint32_t at, int depth);
/// Read the same and what is assigned to it.
bool assign_control_frame(OpenExpression& open, std::string_view name, std::uint32_t at,
                          Statement& statement);

}  // namespace cncsub::sinumerik
