#include "core/language/image/controllerimage.h"

#include "core/language/image/imageparts.h"

#include <algorithm>

namespace camwright {

namespace {

bool readPart(const ImagePart& part, ControllerImage& image)
{
    switch (part.section) {
    case ImageSection::Target: return readTargetPart(part, image.target);
    case ImageSection::Program: return readProgramPart(part, image.program);
    case ImageSection::Layout: return readLayoutPart(part, image.layout);
    case ImageSection::Configuration: return readConfigurationPart(part, image.configuration);
    case ImageSection::Symbols: return readSymbolsPart(part, image.symbols);
    case ImageSection::DebugMap: return readDebugPart(part, image);
    case ImageSection::Source: return readSourcePart(part, image.source);
    }
    return false;
}

void append(std::vector<ImagePart>& parts, std::vector<ImagePart> more)
{
    std::ranges::move(more, std::back_inserter(parts));
}

} // namespace

std::vector<ImagePart> imageParts(const ControllerImage& image)
{
    std::vector<ImagePart> parts{targetPart(image.target)};
    append(parts, programParts(image.program));
    parts.push_back(layoutPart(image.layout));
    append(parts, configurationParts(image.configuration));
    parts.push_back(symbolsPart(image.symbols));
    append(parts, debugParts(image));
    append(parts, sourceParts(image.source));
    return parts;
}

Bytes write(const ControllerImage& image)
{
    return writeContainer(imageParts(image));
}

Result<ControllerImage> readImage(ByteSpan bytes)
{
    Result<std::vector<ImagePart>> parts = readContainer(bytes);
    if (!parts)
        return parts.error();
    ControllerImage image;
    for (const ImagePart& part : *parts) {
        if (!readPart(part, image))
            return diagnostic(Code::ImageMalformed, {part.name.empty() ? "section " + std::to_string(static_cast<int>(part.section)) : part.name});
    }
    if (const Result<void> safe = verify(image); !safe)
        return safe.error();
    return image;
}

Hash programHash(const ControllerImage& image)
{
    return programHash(partTable(imageParts(image)));
}

const Symbol* findSymbol(const ControllerImage& image, std::string_view name)
{
    const auto found = std::ranges::lower_bound(image.symbols, name, {}, &Symbol::name);
    return found != image.symbols.end() && found->name == name ? &*found : nullptr;
}

Place sourceOf(const ControllerImage& image, std::uint32_t routine, std::uint32_t instruction)
{
    if (routine >= image.program.routines.size() || instruction >= image.program.routines[routine].code.size())
        return {};
    const std::uint32_t source = image.program.routines[routine].code[instruction].source;
    if (source == 0 || source > image.debug.sources.size())
        return {};
    const SourcePlace& place = image.debug.sources[source - 1];
    return {image.debug.objects[place.object], "source", place.range, {}};
}

} // namespace camwright
