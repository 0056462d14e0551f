/// Which instruction set the force kernels are run with.
#pragma once

#include <cstdint>
#include <string_view>

namespace wale {

/// Kernels give the same bits whichever set they are run with.
enum class InstructionSet : std::uint8_t {
  scalar,  ///< whatever the library is built for, one number at a time
  avx2,    ///< and FMA: four numbers at a time
  avx512   ///< F, VL, DQ, BW, CD: eight numbers at a time
};

/// "scalar", "avx2", "avx512".
std::string_view name(InstructionSet);
/// Whether this machine has it.
bool supports(InstructionSet);
/// The one in use: the widest that this machine has, unless the environment variable WALE_INSTRUCTIONS names another
/// that it has.
InstructionSet instruction_set();
/// Uses another one from now on; not while forces are evaluated. It must be supported.
void set_instruction_set(InstructionSet);

}  // namespace wale
