#include "tests/fuzz/language_roundtrip.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const camwright::LanguageContext context = camwright::fuzzContext("kinco", "KS105C2-16DT");
    camwright::holdLanguageToItsWord(context, {reinterpret_cast<const char*>(data), size});
    return 0;
}
