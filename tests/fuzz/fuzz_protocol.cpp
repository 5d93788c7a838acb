// Any bytes as the body of a frame, and as a stream of frames: refused, or read and written again to the same value.
#include "devices/protocol/codec.h"
#include "devices/protocol/framing.h"

#include <cstdlib>

using namespace camwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const ByteSpan bytes(data, size);
    if (const auto envelope = decode(bytes)) {
        // NaN is unequal to itself, so bytes are compared, not values.
        const Bytes again = encode(*envelope);
        const auto back = decode(again);
        if (!back || encode(*back) != again)
            std::abort();
    }
    FrameReader frames(message::MaximumFrame);
    for (std::size_t from = 0; from < size; from += 7) {
        frames.feed(bytes.subspan(from, std::min<std::size_t>(7, size - from)));
        for (auto frame = frames.next(); frame && *frame; frame = frames.next())
            (void)decode(**frame);
    }
    return 0;
}
