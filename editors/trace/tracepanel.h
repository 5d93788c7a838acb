#pragma once

#include "core/online/tracebuffer.h"
#include "editors/shell/panel.h"
#include "editors/trace/statenames.h"

#include <QTimer>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QTableView;

namespace camwright {

class ChannelListModel;
class EmptyState;
class Pill;
class ScopePlot;
class SegmentedControl;
class TriggerBar;

/// The oscilloscope: records values in every motion cycle, shows them live, measures between two cursors, writes CSV.
class TracePanel : public Panel {
    Q_OBJECT
public:
    explicit TracePanel(Context& context, QWidget* parent = nullptr);

    const TraceBuffer& buffer() const { return m_buffer; }
    ScopePlot& plot() const { return *m_plot; }
    void addChannels(const QStringList& names);
    void start();
    void stop();
    QByteArray toCsv() const;
    /// Writes the recording to a file; tells the user how it went.
    bool exportTo(const QString& file);

private:
    QWidget* buildTopBar();
    QWidget* buildChannels();
    QWidget* buildCurves();
    QWidget* buildStatistics();
    void connectParts();
    void presetChosen(int index);
    void refreshPresets();
    void addChannelsAnew(const QStringList& names);
    void take(const SampleBlock& block);
    void refreshPlot();
    void refreshState();
    void refreshStatistics();
    void refreshEmpty();
    QString stateSummary(std::size_t channel, const StateNames& names) const;
    void setLive(bool live);
    void removeSelectedChannels();
    void exportCsv();
    int selectedChannel() const;

    TraceBuffer m_buffer;
    std::string m_family;                  ///< of the controller that records
    ScopePlot* m_plot;
    ChannelListModel* m_channels;
    QStackedWidget* m_curves = nullptr;
    EmptyState* m_empty = nullptr;
    QTableView* m_list = nullptr;
    TriggerBar* m_trigger = nullptr;
    QComboBox* m_presets = nullptr;
    QLineEdit* m_newChannel = nullptr;
    QPushButton* m_record = nullptr;
    QPushButton* m_export = nullptr;
    SegmentedControl* m_live = nullptr;
    SegmentedControl* m_arrangement = nullptr;
    Pill* m_state = nullptr;
    QLabel* m_statistics = nullptr;
    QTimer m_redraw;
    bool m_recording = false;
    bool m_following = true;
    bool m_dirty = false;
    bool m_isFirstLook = false; ///< the recording has begun and was not drawn yet
};

} // namespace camwright
