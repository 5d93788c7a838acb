#include "core/base/codes.h"

namespace camwright {

namespace {
using enum Severity;
constexpr CodeInfo Table[] = {
#define CAMWRIGHT_CODE(name, id, severity, text) {Code::name, id, severity, text},
#include "core/base/codes/all.h"
#undef CAMWRIGHT_CODE
};
} // namespace

const CodeInfo& codeInfo(Code code)
{
    return Table[static_cast<std::size_t>(code)];
}

std::span<const CodeInfo> allCodes()
{
    return Table;
}

} // namespace camwright
