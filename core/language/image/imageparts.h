#pragma once

#include "core/language/image/container.h"
#include "core/language/image/controllerimage.h"

#include <vector>

namespace camwright {

// Each section of an image as parts of the container, and back. The readers take a part of their own section, add it to
// the image, and return false on bytes that are not one.

std::vector<ImagePart> programParts(const IrProgram& program);
bool readProgramPart(const ImagePart& part, IrProgram& program);

/// Which place each instruction comes from: run lengths, one part per routine, kept apart from the program so that a
/// comment changes no hash of it.
std::vector<ImagePart> debugParts(const ControllerImage& image);
bool readDebugPart(const ImagePart& part, ControllerImage& image);

ImagePart targetPart(const ImageTarget& target);
bool readTargetPart(const ImagePart& part, ImageTarget& target);
ImagePart layoutPart(const MemoryLayout& layout);
bool readLayoutPart(const ImagePart& part, MemoryLayout& layout);
ImagePart symbolsPart(const std::vector<Symbol>& symbols);
bool readSymbolsPart(const ImagePart& part, std::vector<Symbol>& symbols);

/// "controller", "network", and "axis NAME" for each axis.
std::vector<ImagePart> configurationParts(const Configuration& configuration);
bool readConfigurationPart(const ImagePart& part, Configuration& configuration);

std::vector<ImagePart> sourceParts(const std::vector<ArchivedFile>& source);
bool readSourcePart(const ImagePart& part, std::vector<ArchivedFile>& source);

/// All of them in the order of the container.
std::vector<ImagePart> imageParts(const ControllerImage& image);

} // namespace camwright
