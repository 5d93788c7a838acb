#pragma once

#include "core/online/tracebuffer.h"
#include "editors/trace/statenames.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace camwright {

/// A stretch of time in which a channel has one value.
struct StateBand {
    double from = 0, to = 0;         ///< seconds
    std::optional<double> value;     ///< none: it changes faster than the columns tell apart
    bool operator==(const StateBand&) const = default;
};

/// The bands behind pixel columns that begin at `start` and are `step` seconds wide. A gap ends a band; what lies between
/// two samples belongs to the earlier one.
std::vector<StateBand> bandsOf(const std::vector<TraceColumn>& columns, double start, double step);

/// The text of a band that is `width` pixels wide: all of it, its beginning, or nothing.
QString bandText(const QString& name, const QFontMetrics& metrics, double width);

/// A lane of named bands in place of a curve.
class StateLane : public QCPAbstractPlottable {
public:
    StateLane(QCPAxis* time, QCPAxis* value);

    void setNames(const StateNames& names) { m_names = names; }
    void setBands(std::vector<StateBand> bands) { m_bands = std::move(bands); }
    const std::vector<StateBand>& bands() const { return m_bands; }
    const StateNames& names() const { return m_names; }

    double selectTest(const QPointF& position, bool onlySelectable, QVariant* details) const override;
    QCPRange getKeyRange(bool& found, QCP::SignDomain domain) const override;
    QCPRange getValueRange(bool& found, QCP::SignDomain domain, const QCPRange& keys) const override;

protected:
    void draw(QCPPainter* painter) override;
    void drawLegendIcon(QCPPainter*, const QRectF&) const override {}

private:
    void drawBand(QCPPainter& painter, const QRectF& area, const StateBand& band) const;

    StateNames m_names;
    std::vector<StateBand> m_bands;
};

} // namespace camwright
