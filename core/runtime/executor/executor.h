#pragma once

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/language/image/controllerimage.h"
#include "core/runtime/executor/blockhost.h"
#include "core/runtime/executor/translation.h"
#include "core/runtime/memory/memory.h"

#include <cstdint>
#include <memory>
#include <span>

namespace camwright {

enum class ScanEnd : std::uint8_t { Completed, OutOfOperations };

struct ScanInput {
    Time now{};                            ///< controller time at which the scan runs; timers advance by it
    std::uint64_t operations = UINT64_MAX; ///< the watchdog: IR instructions the scan may execute
    BlockHost* host = nullptr;             ///< may be null only if the program calls no blocks
    std::span<const Force> forces;         ///< applied before the first and after the last instruction
};

struct ScanReport {
    ScanEnd end = ScanEnd::Completed;
    std::uint64_t operations = 0;          ///< IR instructions executed; the same on every machine
    std::uint32_t faults = 0;              ///< failed instructions, such as a division by zero
    std::uint32_t routine = 0;             ///< where the scan ended early, or of the first fault; see sourceOf()
    std::uint32_t instruction = 0;
};

/// Runs the program of an image, by the reference interpreter or a translation of it. Owns the memory it runs on.
/// Deterministic: the same image, memory and inputs give the same bytes and reports, whichever runs. (The name leaves
/// `Executor` to core/online.)
class ScanExecutor {
public:
    /// Verifies the image, makes it runnable, and makes the memory as after power-on. With a translation its program runs
    /// instead of the interpreter; where there is none, or it cannot, the interpreter.
    static Result<ScanExecutor> load(std::shared_ptr<const ControllerImage> image, Translate translate = nullptr);

    ScanExecutor(ScanExecutor&&) noexcept;
    ScanExecutor& operator=(ScanExecutor&&) noexcept;
    ~ScanExecutor();

    const ControllerImage& image() const { return *m_image; }
    bool isTranslated() const { return m_translated != nullptr; }
    Memory& memory() { return m_memory; }
    const Memory& memory() const { return m_memory; }

    /// One pass of the main program.
    ScanReport scan(const ScanInput& input);
    /// One pass of another routine (an interrupt), by its index in the image. Forces are not applied.
    ScanReport run(std::uint32_t routine, const ScanInput& input);

    /// Everything the program can remember: memory areas, timers, counters, edges. Only for the same image.
    void save(ByteWriter& writer) const { m_memory.save(writer); }
    bool restore(ByteReader& reader) { return m_memory.restore(reader); }

private:
    ScanExecutor(std::shared_ptr<const ControllerImage> image, std::unique_ptr<const Bytecode> code,
                 std::unique_ptr<const TranslatedProgram> translated, Memory memory);

    std::shared_ptr<const ControllerImage> m_image;
    std::unique_ptr<const Bytecode> m_code;                    ///< without steps where a translation runs
    std::unique_ptr<const TranslatedProgram> m_translated;     ///< null: the interpreter runs
    Memory m_memory;
    std::uint32_t m_main = 0;
};

} // namespace camwright
