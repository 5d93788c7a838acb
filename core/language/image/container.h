#pragma once

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace camwright {

inline constexpr std::uint16_t ImageFormatVersion = 1;

/// The sections of an image; the numbers are permanent.
enum class ImageSection : std::uint8_t {
    Target = 1, Program = 2, Layout = 3, Configuration = 4, Symbols = 5, DebugMap = 6, Source = 7,
};

/// One object of a section: what the container hashes, and what a download plan compares.
struct ImagePart {
    ImageSection section = ImageSection::Target;
    std::string name;   ///< "Main" (a routine), "axis Feed", "programs/Main.il"; empty for what has no name
    Bytes bytes;
};

struct ImagePartInfo {
    ImageSection section = ImageSection::Target;
    std::string name;
    std::uint32_t size = 0;
    Hash hash;

    bool operator==(const ImagePartInfo&) const = default;
};

/// Header, table of parts with their hashes, hash of both, then the parts' bytes.
Bytes writeContainer(const std::vector<ImagePart>& parts);

/// Checks magic, version, lengths and every hash. Parts come in the order of the file.
Result<std::vector<ImagePart>> readContainer(ByteSpan bytes);

/// Only the table, verified by its hash: cheap, for plans and for asking what a file holds.
Result<std::vector<ImagePartInfo>> readPartTable(ByteSpan bytes);

/// What names a program: every part of the sections Target … Symbols.
Hash programHash(const std::vector<ImagePartInfo>& parts);

std::vector<ImagePartInfo> partTable(const std::vector<ImagePart>& parts);

} // namespace camwright
