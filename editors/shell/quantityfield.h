#pragma once

#include "core/model/field.h"

#include <QString>
#include <QWidget>

#include <cstdint>
#include <limits>
#include <optional>

class QLabel;
class QLineEdit;
class QToolButton;

namespace camwright {

/// What a field of numbers accepts and says.
struct QuantitySpec {
    QString name;                                   ///< accessible name: "Guard time"
    QString unit;                                   ///< "mm", "°", "ms", "mm/s", "%", "" …
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool integer = false;
    int decimals = -1;                              ///< digits shown after the point; -1: as many as needed
    std::optional<double> defaultValue;             ///< shown as placeholder; another value has a dot that returns to it
    double perTurn = 0;                             ///< user units per motor turn, so that "0.5 turn" can be typed; 0: not
    QString help;                                   ///< one sentence for the tool tip
    QString reference;                              ///< "KS-MCN-09"
    double step = 1;                                ///< wheel and arrow keys
    int base = 10;                                  ///< 16 shows 0x1A0
};

/// A field with its unit inside. Typed units are converted, a decimal comma is understood, illegal text is kept and told
/// below. Edits are announced when the user leaves the field, presses Enter or turns the wheel.
class QuantityField : public QWidget {
    Q_OBJECT
public:
    explicit QuantityField(const QuantitySpec& spec, QWidget* parent = nullptr);

    const QuantitySpec& spec() const { return m_spec; }
    void setSpec(const QuantitySpec& spec);

    void setField(const Field<double>& field);
    void setField(const Field<std::int64_t>& field);
    Field<double> realField() const { return m_field; }
    Field<std::int64_t> integerField() const;
    double valueOr(double fallback) const { return m_field.valueOr(fallback); }
    void setValue(double value) { setField(Field<double>(value)); }

    /// A sentence below the field, from a check; the field's own range error goes first.
    void setProblem(const QString& sentence, bool warning = false);
    QString problem() const;
    void setReadOnly(bool readOnly);
    void setFieldWidth(int width);
    QLineEdit* lineEdit() const { return m_edit; }
    void selectAll();

signals:
    void edited();                                  ///< read realField() or integerField()
    void returnPressed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void commit();
    void stepBy(int steps);
    void refresh();
    void refreshToolTip();
    QString rangeError() const;
    QString formatted(double value) const;

    QuantitySpec m_spec;
    Field<double> m_field;
    QString m_checkProblem;
    bool m_checkWarning = false;
    bool m_edited = false;
    QLineEdit* m_edit = nullptr;
    QLabel* m_unit = nullptr;
    QToolButton* m_dot = nullptr;
    QLabel* m_error = nullptr;
};

} // namespace camwright
