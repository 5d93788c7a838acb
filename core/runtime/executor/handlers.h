#pragma once

#include "core/runtime/executor/bytecode.h"

namespace camwright {

/// The handler for a computing operation on a type; null if computing is not its business or it does not exist.
/// Step: dest, a, b as in the IR; extra is the IR instruction, for faults.
Handler computingHandler(IrOp op, DataType type, DataType from);
/// Copies a value of the type from a to dest.
Handler copyHandler(DataType type);

/// What becomes of the result of a network. Step: a is the first contact.
enum class NetworkEnding : std::uint8_t {
    Byte,      ///< dest: offset of a byte, 0 or 1
    Bit,       ///< dest: offset, extra: mask
    JumpIf,    ///< dest: step to go to; b: this IR instruction; extra: the target's
    JumpIfNot,
};
/// The handler for a network of so many contacts, the last of them marked.
Handler networkHandler(NetworkEnding ending, std::size_t contacts);

// Control: b is the IR instruction.
const Step* jump(Frame& frame, const Step* step);             ///< dest: step; extra: target instruction
const Step* callRoutine(Frame& frame, const Step* step);      ///< dest: routine
const Step* enterRoutine(Frame& frame, const Step* step, std::uint32_t instance); ///< the same, with the instance the routine runs with
const Step* returnFromRoutine(Frame& frame, const Step* step);
const Step* callBlock(Frame& frame, const Step* step);        ///< a: EN; extra: block

/// dest := b if a, else extra.
Handler selectHandler(DataType type);
const Step* readClock(Frame& frame, const Step* step);        ///< dest: LINT, ns

// Computed places. Offsets of memory include the beginning of VariablesArea; `relative`: the instance's is added.
Handler callOnHandler(bool relative);                         ///< dest: routine; a: offset in VariablesArea or the instance
const Step* callAt(Frame& frame, const Step* step);           ///< dest: routine; a: pointer
Handler placeHandler(bool relative);                          ///< a: offset in VariablesArea or the instance
const Step* guard(Frame& frame, const Step* step);            ///< dest, a; extra: index into the guards
const Step* locateElement(Frame& frame, const Step* step);    ///< dest, a: pointer, b: index, extra: stride
Handler loadAtHandler(DataType type);                         ///< dest, a: pointer, extra: offset
Handler storeAtHandler(DataType type);                        ///< a: value, b: pointer, extra: offset
Handler loadElementHandler(DataType type, bool relative);     ///< dest, a: offset, b: index, extra: stride
Handler storeElementHandler(DataType type, bool relative);    ///< dest: offset, a: value, b: index, extra: stride
Handler loadInstanceHandler(DataType type);                   ///< dest, a: offset
Handler storeInstanceHandler(DataType type);                  ///< dest: offset, a: value
const Step* moveBytes(Frame& frame, const Step* step);        ///< dest, a: pointers, b: bytes, extra: begin of VariablesArea

const Step* risingEdge(Frame& frame, const Step* step);       ///< extra: offset of the remembered input
const Step* fallingEdge(Frame& frame, const Step* step);

// Timers and counters: extra is the index into the bytecode's table.
Handler timerHandler(TimerKind kind);
Handler koyoTimerHandler(TimerKind kind);
const Step* resetTimer(Frame& frame, const Step* step);       ///< a: whether
Handler counterHandler(bool isWide);
const Step* armCounter(Frame& frame, const Step* step);
const Step* resetCounter(Frame& frame, const Step* step);     ///< a: whether

} // namespace camwright
