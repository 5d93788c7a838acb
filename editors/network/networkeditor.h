#pragma once

#include "editors/network/motionnetworkdraft.h"
#include "editors/document/projectchange.h"
#include "editors/shell/editor.h"

#include <set>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableView;
class QTreeWidget;
class QTreeWidgetItem;

namespace camwright {

class AxisForm;
class AxisListModel;
class QuantityField;

/// The Kinco motion network's window (KS-MCN): a tree of master and axes, the fields of what is selected, the list of all
/// axes; Apply, OK and Cancel as the manual has them. What is not applied is a draft that survives a crash.
class NetworkEditor : public Editor {
    Q_OBJECT
public:
    NetworkEditor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    QString iconName() const override { return QStringLiteral("network"); }
    void setKey(const ObjectKey& key) override;
    void reveal(const Place& place) override;
    Place place() const override;
    bool can(const QString& actionId) const override;
    void perform(const QString& actionId) override;
    bool mayClose() override;

    const MotionNetworkDraft& draft() const { return m_draft; }
    bool hasUnapplied() const;

private:
    QWidget* buildTree();
    QWidget* buildPages();
    QWidget* buildMasterPage();
    QWidget* buildAxisPage();
    QWidget* buildListPage();
    QWidget* buildButtons();
    void addShortcut(const QKeySequence& keys, void (NetworkEditor::*slot)());

    void addAxis();
    void removeAxis();
    void copyAxis();
    void pasteAxis();
    void renumber();
    bool applyDraft();
    void applyAndClose();
    void dropDraft();

    void documentChanged(const ProjectChange& change);
    void change(MotionNetworkDraft draft);
    void keepDraft();
    void showRecovered();
    void rebuildTree();
    void selectRow(int row);
    void selectionMoved();
    void refreshPages();
    void refreshState();
    int currentAxis() const; ///< -1: the master

    MotionNetworkDraft m_applied;
    MotionNetworkDraft m_draft;
    std::set<ObjectKey> m_kept; ///< what of the draft the document keeps against a crash
    int m_row = 0;           ///< 0 the master, else axis m_row - 1
    bool m_building = false;

    QTreeWidget* m_tree = nullptr;
    QStackedWidget* m_pages = nullptr;
    QComboBox* m_baudrate = nullptr;
    QuantityField* m_sdoTimeout = nullptr;
    AxisForm* m_axisForm = nullptr;
    AxisListModel* m_listModel = nullptr;
    QTableView* m_list = nullptr;
    QLabel* m_message = nullptr;
    QPushButton *m_ok = nullptr, *m_apply = nullptr, *m_cancel = nullptr, *m_renumber = nullptr;
    QPushButton *m_add = nullptr, *m_delete = nullptr, *m_copy = nullptr, *m_paste = nullptr;
};

} // namespace camwright
