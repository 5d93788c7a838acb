#pragma once

#include "core/model/project.h"

#include <QString>
#include <QStringList>

namespace camwright {

/// The comment of the variable with this name or address; of an axis value, what it is. Empty if there is none.
QString commentOf(const Project& project, const std::string& expression);

/// What can be watched, for completion: variables, their addresses, axis values.
QStringList watchableNames(const Project& project);

} // namespace camwright
