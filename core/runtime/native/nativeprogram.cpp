#include "core/runtime/native/nativeprogram.h"

#include "core/runtime/native/codepages.h"
#include "core/runtime/native/routinetranslator.h"

#include <algorithm>

namespace camwright {

namespace {

using namespace native;

/// Longer routines would not fit the constants of the instructions that count; none is that long.
constexpr std::size_t GreatestRoutine = std::size_t{1} << 30;

/// Offsets must fit a signed displacement, with room for the scratch space.
constexpr std::uint32_t GreatestMemory = std::uint32_t{1} << 30;

/// As many operations are never done, so that much is as good as no limit and leaves room for the sign.
constexpr std::uint64_t GreatestBudget = std::uint64_t{1} << 62;

/// Returns what is left of the budget.
using Entry = std::int64_t (*)(Frame* frame, std::uint8_t* bytes, const std::uint8_t* routine, std::uint64_t budget);

// The sanitizer looks for the type of a called function in the bytes before it. Ours has none there, and no page.
#ifdef __clang__
#define CAMWRIGHT_CALLS_MACHINE_CODE __attribute__((no_sanitize("function")))
#else
#define CAMWRIGHT_CALLS_MACHINE_CODE
#endif

class ErrorFlag : public asmjit::ErrorHandler {
public:
    void handleError(asmjit::Error, const char*, asmjit::BaseEmitter*) override { m_failed = true; }
    bool failed() const { return m_failed; }

private:
    bool m_failed = false;
};

void countFault(Frame* frame, std::uint32_t instruction)
{
    frame->fault(instruction);
}

ConstantPool floatConstants(const IrProgram& program, std::uint32_t offset)
{
    ConstantPool pool(offset);
    for (const IrRoutine& routine : program.routines) {
        for (const IrInstruction& i : routine.code) {
            if (i.op == IrOp::Const && isFloat(i.type))
                pool.add(i.constant);
        }
    }
    return pool;
}

/// Code that all routines share, and the way in and out.
class CommonCode {
public:
    CommonCode(x86::Assembler& assembler, ProgramTranslation& program, std::uint32_t savedStack)
        : m_asm(assembler), m_program(program), m_savedStack(savedStack), m_exit(assembler.newLabel())
    {
    }

    void write()
    {
        writeEntry();
        writeOutOfOperations();
        writeFault();
    }

private:
    void writeEntry()
    {
        for (const x86::Gpq& saved : Saved)
            m_asm.push(saved);
        m_asm.sub(x86::rsp, 8);
        m_asm.mov(FramePointer, x86::rdi);
        m_asm.mov(Base, x86::rsi);
        m_asm.mov(Budget, x86::rcx);
        m_asm.mov(stackPlace(), x86::rsp);
        m_asm.call(x86::rdx);
        m_asm.bind(m_exit);
        m_asm.mov(x86::rax, Budget);
        m_asm.add(x86::rsp, 8);
        for (std::size_t k = std::size(Saved); k-- > 0;)
            m_asm.pop(Saved[k]);
        m_asm.ret();
    }

    /// From any depth of calls.
    void writeOutOfOperations()
    {
        m_asm.bind(m_program.outOfOperations);
        m_asm.mov(field(offsetof(Frame, stopInstruction), 4), x86::eax);
        m_asm.mov(x86::eax, field(offsetof(Frame, routine), 4));
        m_asm.mov(field(offsetof(Frame, stopRoutine), 4), x86::eax);
        m_asm.mov(field(offsetof(Frame, outOfOperations), 1), 1);
        m_asm.mov(x86::rsp, stackPlace());
        m_asm.jmp(m_exit);
    }

    /// Keeps every register, for it is called from the middle of instructions.
    void writeFault()
    {
        m_asm.bind(m_program.fault);
        for (const x86::Gpq& changed : Changed)
            m_asm.push(changed);
        constexpr std::int32_t FloatBytes = 16 * 16;
        constexpr std::int32_t Frame = FloatBytes + 8; // 8 to align
        m_asm.sub(x86::rsp, Frame);
        for (unsigned k = 0; k < 16; ++k)
            m_asm.movaps(x86::ptr(x86::rsp, static_cast<std::int32_t>(16 * k), 16), x86::xmm(k));
        constexpr auto Argument = static_cast<std::int32_t>(Frame + 8 * std::size(Changed) + 8);
        m_asm.mov(x86::esi, x86::ptr(x86::rsp, Argument, 4));
        m_asm.mov(x86::rdi, FramePointer);
        m_asm.mov(x86::rax, reinterpret_cast<std::uintptr_t>(&countFault));
        m_asm.call(x86::rax);
        for (unsigned k = 0; k < 16; ++k)
            m_asm.movaps(x86::xmm(k), x86::ptr(x86::rsp, static_cast<std::int32_t>(16 * k), 16));
        m_asm.add(x86::rsp, Frame);
        for (std::size_t k = std::size(Changed); k-- > 0;)
            m_asm.pop(Changed[k]);
        m_asm.ret();
    }

    x86::Mem field(std::size_t offset, unsigned bytes) const
    {
        return x86::ptr(FramePointer, static_cast<std::int32_t>(offset), bytes);
    }
    x86::Mem stackPlace() const { return x86::ptr(Base, static_cast<std::int32_t>(m_savedStack), 8); }

    static constexpr x86::Gpq Saved[] = {x86::rbx, x86::rbp, x86::r12, x86::r13, x86::r14, x86::r15};
    static constexpr x86::Gpq Changed[] = {x86::rax, x86::rcx, x86::rdx, x86::rsi, x86::rdi, x86::r8, x86::r9, x86::r10, x86::r11};

    x86::Assembler& m_asm;
    ProgramTranslation& m_program;
    std::uint32_t m_savedStack;
    asmjit::Label m_exit;
};

class NativeProgram : public TranslatedProgram {
public:
    NativeProgram(const ControllerImage& image, const Memory& memory)
        : m_constants(floatConstants(image.program, memory.scratchOffset() + FixedBytes)), m_scratch(memory.scratchOffset())
    {
    }

    bool translate(const ControllerImage& image, const Memory& memory, const Bytecode& tables);

    std::uint32_t scratchBytes() const override { return m_scratchBytes; }
    void placeConstants(Memory& memory) const override
    {
        if (!m_constants.bits().empty())
            std::memcpy(memory.data() + m_scratch + FixedBytes, m_constants.bits().data(), 8 * m_constants.bits().size());
    }
    CAMWRIGHT_CALLS_MACHINE_CODE void run(std::uint32_t routine, Frame& frame) const override
    {
        const std::uint64_t budget = std::min(frame.budget, GreatestBudget);
        const std::uint8_t* const code = m_pages.data();
        const auto entry = reinterpret_cast<Entry>(reinterpret_cast<std::uintptr_t>(code));
        frame.operations = budget - static_cast<std::uint64_t>(entry(&frame, frame.bytes, code + m_entries[routine], budget));
    }

private:
    static constexpr std::uint32_t FixedBytes = 32; ///< stack pointer, two arguments, a result

    ConstantPool m_constants;
    std::uint32_t m_scratch = 0;
    std::uint32_t m_scratchBytes = 0;
    std::deque<Step> m_steps;
    std::vector<std::uint64_t> m_entries; ///< offsets of the routines in the code
    CodePages m_pages;
};

bool NativeProgram::translate(const ControllerImage& image, const Memory& memory, const Bytecode& tables)
{
    asmjit::CodeHolder code;
    ErrorFlag errors;
    code.init(asmjit::Environment::host());
    code.setErrorHandler(&errors);
    x86::Assembler assembler(&code);
    SlotAllocator slots(m_constants.end());
    ProgramTranslation program{assembler, memory, tables, slots, m_constants, m_steps, {}, assembler.newLabel(), assembler.newLabel(),
                               m_scratch + 8, m_scratch + 16, m_scratch + 24,
                               asmjit::CpuInfo::host().features().x86().hasBMI()};
    for (std::size_t r = 0; r < image.program.routines.size(); ++r)
        program.entries.push_back(assembler.newLabel());
    CommonCode(assembler, program, m_scratch).write();
    for (std::uint32_t r = 0; r < image.program.routines.size(); ++r)
        RoutineTranslator(program, image.program.routines[r], r).run();
    if (errors.failed() || !m_pages.fill(code))
        return false;
    for (const asmjit::Label& entry : program.entries)
        m_entries.push_back(code.labelOffset(entry));
    m_scratchBytes = slots.end() - m_scratch;
    return true;
}

} // namespace

bool hasNativeTranslation()
{
    return true;
}

std::unique_ptr<const TranslatedProgram> translateToNative(const ControllerImage& image, const Memory& memory, const Bytecode& tables)
{
    if (memory.scratchOffset() >= GreatestMemory)
        return nullptr;
    for (const IrRoutine& routine : image.program.routines) {
        if (routine.code.size() >= GreatestRoutine || !RoutineTranslator::canTranslate(routine))
            return nullptr;
    }
    auto program = std::make_unique<NativeProgram>(image, memory);
    return program->translate(image, memory, tables) ? std::move(program) : nullptr;
}

} // namespace camwright
