#pragma once

#include "core/base/bytes.h"
#include "core/family/family.h"
#include "core/language/image/controllerimage.h"
#include "core/runtime/blocks/programblocks.h"
#include "core/runtime/log/controllerlog.h"
#include "core/runtime/motionsystem.h"
#include "core/runtime/native/loadexecutor.h"
#include "core/runtime/scantask.h"
#include "core/runtime/valuenames.h"

#include <memory>

namespace camwright {

/// An image that has been verified against what this controller can be, ready to be switched in.
struct PreparedImage {
    Bytes bytes;
    std::shared_ptr<const ControllerImage> image;
    const Family* family = nullptr;
    const ControllerModel* model = nullptr;
    ScanExecutor executor;

    /// Everything is checked; any bytes give a usable image or the reason.
    static Result<PreparedImage> from(ByteSpan bytes, ExecutorChoice choice = ExecutorChoice::Automatic);
};

/// An image in its place: its memory and scan, its motion, its names.
struct LoadedProgram {
    LoadedProgram(PreparedImage prepared, std::uint64_t seed, ControllerLog& log, Time now);

    Bytes bytes;
    std::shared_ptr<const ControllerImage> image;
    const Family& family;
    const ControllerModel& model;
    Hash hash;
    ScanTask scan;
    std::unique_ptr<MotionSystem> motion;
    ProgramBlocks blocks;
    ValueNames names;
};

} // namespace camwright
