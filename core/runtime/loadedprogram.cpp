#include "core/runtime/loadedprogram.h"

#include "core/runtime/kinco/kincomotion.h"
#include "core/runtime/nomotion.h"

namespace camwright {

namespace {

using ImagePtr = std::shared_ptr<const ControllerImage>;

std::unique_ptr<MotionSystem> makeMotion(const ImagePtr& image, std::uint64_t seed, ControllerLog& log, Time now)
{
    if (image->target.family == "kinco")
        return std::make_unique<kinco::KincoMotion>(image, seed, log, now);
    return std::make_unique<NoMotion>();
}

/// The network must be what the window lets people make: node numbers 1, 2, 3 … (KS-MCN-06), a usable scale.
bool hasUsableAxes(const Configuration& configuration)
{
    for (std::size_t i = 0; i < configuration.axes.size(); ++i) {
        const AxisConfiguration& axis = configuration.axes[i];
        const AxisScale scale{static_cast<double>(axis.encoderResolution), axis.mechanicalEquivalent};
        if (axis.number != i + 1 || !scale.isValid())
            return false;
    }
    return true;
}

} // namespace

Result<PreparedImage> PreparedImage::from(ByteSpan bytes, ExecutorChoice choice)
{
    Result<ControllerImage> read = readImage(bytes);
    if (!read)
        return std::move(read).error();
    auto image = std::make_shared<const ControllerImage>(std::move(read).value());
    const Family* const family = findFamily(image->target.family);
    const ControllerModel* const model = family ? family->findModel(image->target.model) : nullptr;
    if (!model || !hasUsableAxes(image->configuration))
        return diagnostic(Code::FamilyMismatch, {image->target.family, image->target.model});
    Result<ScanExecutor> executor = loadExecutor(image, choice);
    if (!executor)
        return std::move(executor).error();
    return PreparedImage{{bytes.begin(), bytes.end()}, std::move(image), family, model, std::move(executor).value()};
}

LoadedProgram::LoadedProgram(PreparedImage prepared, std::uint64_t seed, ControllerLog& log, Time now)
    : bytes(std::move(prepared.bytes))
    , image(std::move(prepared.image))
    , family(*prepared.family)
    , model(*prepared.model)
    , hash(programHash(*image))
    , scan(family, std::move(prepared.executor))
    , motion(makeMotion(image, seed, log, now))
    , blocks(*image, motion->blocks())
    , names(*image, family, model, *motion)
{
}

} // namespace camwright
