#include "editors/commissioning/causetext.h"

#include "core/family/family.h"
#include "editors/words/words.h"

#include <QCoreApplication>

namespace camwright {

namespace {

// What the virtual controller writes into AxisStatus::lastCause.
constexpr const char* Causes[] = {
    QT_TRANSLATE_NOOP("AxisCause", "powered by the program"),
    QT_TRANSLATE_NOOP("AxisCause", "enabled by a panel"),
    QT_TRANSLATE_NOOP("AxisCause", "released by the program"),
    QT_TRANSLATE_NOOP("AxisCause", "released by a panel"),
    QT_TRANSLATE_NOOP("AxisCause", "stopped and released"),
    QT_TRANSLATE_NOOP("AxisCause", "alarm of the drive"),
    QT_TRANSLATE_NOOP("AxisCause", "no longer on the bus"),
    QT_TRANSLATE_NOOP("AxisCause", "reset"),
    QT_TRANSLATE_NOOP("AxisCause", "node restarted"),
    QT_TRANSLATE_NOOP("AxisCause", "motion of the program"),
    QT_TRANSLATE_NOOP("AxisCause", "motion of a panel"),
    QT_TRANSLATE_NOOP("AxisCause", "motion ended"),
    QT_TRANSLATE_NOOP("AxisCause", "stopped by command"),
    QT_TRANSLATE_NOOP("AxisCause", "stopped: no heartbeat from the panel"),
};

struct ErrorClass {
    std::uint32_t mask, code;
    const char* text;
};

// CiA 301 table of emergency error codes and CiA 402's additions, the narrower first.
constexpr ErrorClass ErrorClasses[] = {
    {0xFFFF, 0x8130, QT_TRANSLATE_NOOP("AxisError", "the drive no longer answers on the bus")},
    {0xFFFF, 0x8611, QT_TRANSLATE_NOOP("AxisError", "following error too large")},
    {0xFF00, 0x2300, QT_TRANSLATE_NOOP("AxisError", "current too high at the output of the drive")},
    {0xF000, 0x2000, QT_TRANSLATE_NOOP("AxisError", "current")},
    {0xF000, 0x3000, QT_TRANSLATE_NOOP("AxisError", "voltage")},
    {0xF000, 0x4000, QT_TRANSLATE_NOOP("AxisError", "temperature")},
    {0xF000, 0x5000, QT_TRANSLATE_NOOP("AxisError", "hardware of the drive")},
    {0xF000, 0x6000, QT_TRANSLATE_NOOP("AxisError", "software of the drive")},
    {0xFF00, 0x7300, QT_TRANSLATE_NOOP("AxisError", "encoder")},
    {0xF000, 0x7000, QT_TRANSLATE_NOOP("AxisError", "brake, motor or another module of the drive")},
    {0xFF00, 0x8100, QT_TRANSLATE_NOOP("AxisError", "communication")},
    {0xFF00, 0x8600, QT_TRANSLATE_NOOP("AxisError", "position control")},
    {0xF000, 0x8000, QT_TRANSLATE_NOOP("AxisError", "supervision")},
    {0xFF00, 0x1000, QT_TRANSLATE_NOOP("AxisError", "general error of the drive")},
};

} // namespace

QString causeText(const std::string& cause)
{
    for (const char* known : Causes) {
        if (cause == known)
            return QCoreApplication::translate("AxisCause", known);
    }
    return QString::fromStdString(cause);
}

QString axisErrorText(const std::string& family, std::uint32_t code)
{
    if (code == 0)
        return {};
    if (const Family* known = findFamily(family)) {
        const std::string text = known->errorText("axis", code, textLanguage(words::currentLanguage().toStdString()));
        if (!text.empty())
            return QString::fromStdString(text);
    }
    for (const ErrorClass& row : ErrorClasses) {
        if ((code & row.mask) == row.code)
            return QCoreApplication::translate("AxisError", row.text);
    }
    return QCoreApplication::translate("AxisError", "alarm of the drive; its manual explains the code");
}

QString errorCodeText(std::uint32_t code)
{
    return QStringLiteral("16#%1").arg(code, 4, 16, QLatin1Char('0')).toUpper();
}

} // namespace camwright
