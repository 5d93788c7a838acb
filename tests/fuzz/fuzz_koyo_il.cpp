#include "tests/fuzz/language_roundtrip.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const camwright::LanguageContext context = camwright::fuzzContext("koyo", nullptr);
    camwright::holdLanguageToItsWord(context, {reinterpret_cast<const char*>(data), size});
    return 0;
}
