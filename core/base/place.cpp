#include "core/base/place.h"

namespace camwright {

const char* kindName(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Project: return "project";
    case ObjectKind::Controller: return "controller";
    case ObjectKind::Axis: return "axis";
    case ObjectKind::Network: return "network";
    case ObjectKind::Program: return "program";
    case ObjectKind::VariableTable: return "variables";
    case ObjectKind::WatchTable: return "watch";
    }
    return "";
}

} // namespace camwright
