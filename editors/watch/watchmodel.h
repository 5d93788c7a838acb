#pragma once

#include "core/model/objects.h"
#include "core/online/controllerlink.h"
#include "editors/document/projectchange.h"
#include "editors/document/rowsmodel.h"

#include <deque>
#include <map>
#include <optional>

namespace camwright {

class ProjectDocument;

/// What is known of one watched expression at the controller.
struct WatchedValue {
    std::optional<DataType> type;     ///< once the controller has told it
    std::optional<Diagnostic> problem; ///< why it cannot be watched
    std::optional<MonitoredValue> value;
    std::deque<double> history;       ///< the last ten seconds, for the small curve
};

/// Rows of a watch table of the project with the controller's values. Editing a name or a format is a command; a new value
/// is not part of the project: it is announced for whoever writes it.
class WatchModel : public RowsModel<WatchRow> {
    Q_OBJECT
public:
    enum Column { Name, Type, CurrentValue, NewValue, History, Comment, ColumnCount };
    static constexpr std::size_t HistoryLength = 100;

    WatchModel(ProjectDocument& document, ObjectKey key, QObject* parent = nullptr);

    const ObjectKey& key() const { return m_key; }
    void setKey(const ObjectKey& key);
    const WatchedValue* watched(int row) const;
    QString typedValue(int row) const;

    void add(int row, const std::vector<WatchRow>& rows);
    void remove(const std::vector<int>& rows);
    void setFormat(const std::vector<int>& rows, const std::string& format);

    // From the controller
    void setType(const std::string& expression, Result<DataType> type);
    void update(const std::vector<MonitoredValue>& values);
    void setStale(bool stale);
    void forgetValues();

    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void expressionsChanged();
    void writeRequested(const QString& expression, const camwright::Value& value);

private:
    void documentChanged(const ProjectChange& change);
    std::vector<WatchRow> storedRows() const;
    void replace(const std::vector<WatchRow>& rows, const QString& label);
    QString text(int row, int column) const;
    QVariant color(int row, int column) const;
    bool enterNewValue(int row, const QString& text);
    /// The value that was typed for an expression; else why there is none is kept beside the text.
    std::optional<Value> judgeTyped(const std::string& expression, const std::optional<DataType>& type);

    ProjectDocument& m_document;
    ObjectKey m_key;
    std::map<std::string, WatchedValue> m_watched;
    std::map<std::string, QString> m_typed;          ///< new values as typed, by expression
    std::map<std::string, Diagnostic> m_typedWrong;
    bool m_stale = true;
};

} // namespace camwright
