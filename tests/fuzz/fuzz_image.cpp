#include "core/language/image/container.h"
#include "core/language/image/imageparts.h"
#include "core/runtime/executor/executor.h"
#include "tests/core/language/image/sampleimage.h"

#include <memory>

using namespace camwright;

namespace {

/// Replaces parts of a good image by what the fuzzer made up, and puts the right hashes on them.
Bytes forged(ByteSpan data)
{
    static const std::vector<ImagePart> Parts = imageParts(test::sampleImage());
    std::vector<ImagePart> parts = Parts;
    ByteReader reader(data);
    while (reader.remaining() > 3) {
        ImagePart& part = parts[reader.get<std::uint8_t>() % parts.size()];
        const std::size_t size = std::min<std::size_t>(reader.get<std::uint16_t>(), reader.remaining());
        const ByteSpan bytes = reader.getBytes(size);
        part.bytes.assign(bytes.begin(), bytes.end());
    }
    return writeContainer(parts);
}

/// Whatever is taken must run, round-trip and keep its hash.
void use(ControllerImage image)
{
    const Bytes bytes = write(image);
    const Result<ControllerImage> again = readImage(bytes);
    if (!again || !(write(*again) == bytes))
        __builtin_trap();
    Result<ScanExecutor> executor = ScanExecutor::load(std::make_shared<const ControllerImage>(std::move(image)));
    if (!executor)
        __builtin_trap();
    for (int scan = 0; scan < 3; ++scan) {
        ScanInput input;
        input.now = scan * 13ms;
        input.operations = 2000;
        executor->scan(input);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const ByteSpan rest(data + 1, size - 1);
    Result<ControllerImage> image = data[0] % 2 == 0 ? readImage(rest) : readImage(forged(rest));
    if (image)
        use(std::move(image).value());
    return 0;
}
