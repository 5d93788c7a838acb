#pragma once

#include "editors/document/projectdocument.h"

#include <QAbstractItemModel>

#include <functional>
#include <vector>

namespace camwright {

/// The project as a tree: sections (axes, networks, programs …) with their objects, the controller first. One column; the
/// right-hand text of a row is DetailRole.
class ProjectTreeModel : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Role {
        KeyRole = Qt::UserRole,  ///< ObjectKey of an object row; a section has kind and an empty name
        IsSectionRole,
        IconRole,                ///< name of an icon
        DetailRole,              ///< count of a section, state of an object
        DetailIconRole,
        ProblemRole,             ///< int: Severity of the worst problem, -1 none
        ProblemCountRole,
    };
    struct Detail {
        QString text;
        QString icon;
        bool operator==(const Detail&) const = default;
    };

    explicit ProjectTreeModel(ProjectDocument& document, QObject* parent = nullptr);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override; ///< renames
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    QModelIndex indexOf(const ObjectKey& key) const;
    static ObjectKey keyOf(const QModelIndex& index);
    /// What stands at the right of an object: a live state while online. Called when rows are painted.
    void setDetails(std::function<Detail(const ObjectKey&)> details);
    void refreshDetails();

signals:
    void renameRefused(const camwright::Diagnostic& why);

private:
    struct Section {
        ObjectKind kind;
        std::vector<ObjectKey> keys;
    };
    void follow(const ProjectChange& change);
    void updateSection(int row);
    QVariant sectionData(const Section& section, int role) const;
    QVariant objectData(const ObjectKey& key, int role) const;
    QString iconOf(const ObjectKey& key) const;
    std::vector<ObjectKey> keysNow(ObjectKind kind) const;

    ProjectDocument& m_document;
    std::vector<Section> m_sections;
    std::function<Detail(const ObjectKey&)> m_details;
};

/// The title of a section: "Axes".
QString sectionTitle(ObjectKind kind);

} // namespace camwright
