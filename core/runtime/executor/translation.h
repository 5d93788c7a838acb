#pragma once

#include "core/runtime/executor/bytecode.h"

#include <cstdint>
#include <memory>

namespace camwright {

/// A program in a form that runs without the interpreter's steps, machine code for instance. It does to memory and to the
/// frame, byte for byte, what the interpreter does.
class TranslatedProgram {
public:
    virtual ~TranslatedProgram() = default;

    /// What it needs behind the memory areas and the hidden state; see Memory::reserveScratch().
    virtual std::uint32_t scratchBytes() const = 0;
    /// Writes its constants into the scratch space, once.
    virtual void placeConstants(Memory& memory) const = 0;
    /// One pass of a routine. On return the frame tells operations, faults, and whether the budget was used up.
    virtual void run(std::uint32_t routine, Frame& frame) const = 0;
};

/// Translates a verified image for a memory made from its layout. `tables` are those of the frames it will run with and
/// outlive the result, as the image does. Null where it cannot.
using Translate = std::unique_ptr<const TranslatedProgram> (*)(const ControllerImage& image, const Memory& memory, const Bytecode& tables);

} // namespace camwright
