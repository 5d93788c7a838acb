#pragma once

#include <QKeySequence>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace camwright {

class ActionCatalogue;
class Banner;
class KeyBook;
class KeyField;

/// The settings' page of keys: which map, every action with its keys, and what to press instead. Takes effect at once.
class KeysPage : public QWidget {
    Q_OBJECT
public:
    KeysPage(KeyBook& keys, const ActionCatalogue& actions, QWidget* parent = nullptr);

private:
    QWidget* makeMapRow();
    QWidget* makeTable();
    QWidget* makeFields();
    QString currentAction() const;
    QString nameOf(const QString& action) const;
    void refresh();
    void pressed(int field, const QKeySequence& key);
    void assign(int field, const QKeySequence& key);
    void say(const QString& sentence, bool offerTaking);

    KeyBook& m_keys;
    const ActionCatalogue& m_actions;
    QComboBox* m_map = nullptr;
    QLabel* m_mapWords = nullptr;
    QLineEdit* m_filter = nullptr;
    QSortFilterProxyModel* m_rows = nullptr;
    QTableView* m_table = nullptr;
    QLabel* m_name = nullptr;
    KeyField* m_fields[2] = {nullptr, nullptr};
    QPushButton* m_remove = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_resetAll = nullptr;
    Banner* m_banner = nullptr;
    QPushButton* m_take = nullptr;
    int m_wantedField = 0;
    QKeySequence m_wanted;                 ///< waits for the user's word
};

} // namespace camwright
