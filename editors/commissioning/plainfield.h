#pragma once

class QWidget;

namespace camwright {

class QuantityField;

/// The field in a holder without the room that fields keep for their dot: here none has a default, and the columns align
/// with buttons.
QWidget* plainField(QuantityField* field, QWidget* parent);

} // namespace camwright
