#include "core/language/image/container.h"
#include "core/language/image/imageparts.h"
#include "tests/core/runtime/native/comparison.h"
#include "tests/core/runtime/native/irgenerator.h"

#include <algorithm>
#include <cstdio>
#include <memory>

using namespace camwright;

namespace {

/// A generated program whose routines and tables the fuzzer rewrote; or one that it only chose the seed of.
Bytes forged(std::uint64_t seed, ByteSpan data)
{
    test::IrGenerator generator(seed);
    std::vector<ImagePart> parts = imageParts(*generator.generate().share());
    ByteReader reader(data);
    while (reader.remaining() > 5) {
        ImagePart& part = parts[reader.get<std::uint8_t>() % parts.size()];
        if (part.bytes.empty())
            continue;
        const std::size_t at = reader.get<std::uint16_t>() % part.bytes.size();
        const std::size_t size = std::min({std::size_t{reader.get<std::uint8_t>()}, part.bytes.size() - at, reader.remaining()});
        const ByteSpan bytes = reader.getBytes(size);
        std::copy(bytes.begin(), bytes.end(), part.bytes.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return writeContainer(parts);
}

} // namespace

/// Whatever the verifier takes does the same in both executors.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 2)
        return 0;
    const auto seed = static_cast<std::uint64_t>(data[0] | data[1] << 8);
    const Result<ControllerImage> image = readImage(forged(seed, ByteSpan(data + 2, size - 2)));
    if (!image)
        return 0;
    test::BothExecutors both(std::make_shared<const ControllerImage>(*image));
    for (int scan = 0; scan < 3; ++scan) {
        ScanInput input;
        input.now = scan * 13ms;
        input.operations = 2000;
        if (const auto different = both.scan(input)) {
            std::fputs((*different + "\n").c_str(), stderr);
            __builtin_trap();
        }
    }
    return 0;
}
