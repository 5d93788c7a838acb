#include "editors/watch/variablelookup.h"

#include "core/online/valuename.h"

#include <QCoreApplication>

namespace camwright {

namespace {

constexpr const char* AxisValues[] = {"position", "velocity", "setPosition", "followingError", "torque", "state", "error"};

template <class Visit>
void forEachVariable(const Project& project, Visit visit)
{
    for (const ObjectPtr& table : project.objects(ObjectKind::VariableTable)) {
        for (const auto& chunk : std::get<VariableTable>(table->content).chunks) {
            for (const Variable& variable : *chunk)
                visit(variable);
        }
    }
}

} // namespace

QString commentOf(const Project& project, const std::string& expression)
{
    QString out;
    forEachVariable(project, [&](const Variable& variable) {
        if (out.isEmpty() && (variable.name == expression || variable.address == expression))
            out = QString::fromStdString(variable.comment.empty() && variable.address == expression ? variable.name : variable.comment);
    });
    if (!out.isEmpty() || !expression.starts_with("axis."))
        return out;
    const auto ends = [&](const char* name) { return expression.ends_with(name); };
    if (ends(".position"))
        return QCoreApplication::translate("Watch", "Actual position, from the drive");
    if (ends(".velocity"))
        return QCoreApplication::translate("Watch", "Actual velocity, units per second");
    if (ends(".setPosition"))
        return QCoreApplication::translate("Watch", "Position the drive is commanded to");
    if (ends(".followingError"))
        return QCoreApplication::translate("Watch", "Commanded less actual position");
    if (ends(".torque"))
        return QCoreApplication::translate("Watch", "Torque in per cent of rated");
    if (ends(".state"))
        return QCoreApplication::translate("Watch", "Number of the axis state");
    if (ends(".error"))
        return QCoreApplication::translate("Watch", "Error code of the axis, 0 for none");
    return {};
}

QStringList watchableNames(const Project& project)
{
    QStringList out;
    forEachVariable(project, [&](const Variable& variable) {
        if (!variable.name.empty())
            out << QString::fromStdString(variable.name);
        if (!variable.address.empty())
            out << QString::fromStdString(variable.address);
    });
    for (const ObjectPtr& axis : project.objects(ObjectKind::Axis)) {
        for (const char* value : AxisValues)
            out << QString::fromStdString(axisValueName(axis->key.name, value));
    }
    out.removeDuplicates();
    return out;
}

} // namespace camwright
