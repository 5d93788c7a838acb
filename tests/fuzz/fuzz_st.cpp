#include "core/language/st/check/checker.h"
#include "core/language/st/lowering/lowerst.h"

#include <cstddef>
#include <cstdint>

/// Any bytes are read, checked and, where nothing is wrong, lowered to a program that the verifier accepts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace camwright;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    st::Environment environment;
    environment.isLoose = true;
    const auto compilation = st::check({{{ObjectKind::Program, "Main"}, text, true}}, environment);
    for (const Diagnostic& d : compilation->diagnostics[0]) {
        if (d.severity() == Severity::Error && d.code != Code::TooManyDiagnostics && !d.place.range.isValid())
            __builtin_trap();
    }
    if (compilation->hasErrors())
        return 0;
    ControllerImage image;
    LoweredPrograms lowered;
    st::lowerSt(*compilation, nullptr, [](std::string_view) { return 0u; }, lowered);
    image.program = std::move(lowered.program);
    image.layout.areas.push_back({VariablesArea, "", lowered.variableBytes, 0, 0});
    image.layout.initialValues = std::move(lowered.initialValues);
    if (const auto safe = verify(image); !safe && image.program.routines.size() < MaximumCallDepth)
        __builtin_trap();
    return 0;
}
