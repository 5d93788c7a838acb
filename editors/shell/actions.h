#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <vector>

namespace camwright {

/// When an action can be used. Several may be combined; all must hold.
enum class Availability : unsigned {
    Always = 0,
    ProjectOpen = 1,
    Online = 2,
    Offline = 4,
    Running = 8,
    Stopped = 16,
    Editor = 32,          ///< the current editor says it can (Editor::can)
    CanUndo = 64,
    CanRedo = 128,
    Modified = 256,
    Idle = 512,           ///< no check, build or download is running
    Problems = 1024,
    TabOpen = 2048,       ///< the active group of editors has a tab
    TabMovable = 4096,    ///< and the tab has somewhere to go
    SeveralGroups = 8192,
};
inline Availability operator|(Availability a, Availability b) { return Availability(unsigned(a) | unsigned(b)); }
inline bool operator&(Availability a, Availability b) { return (unsigned(a) & unsigned(b)) != 0; }

/// One row of the catalogue. Menus, tool bars, the palette of Ctrl+Shift+P and the key settings come from it. Texts are
/// given with QT_TRANSLATE_NOOP("Actions", …); text in Title Case with `...` when a dialog follows, the tool tip one sentence.
struct ActionRow {
    const char* id;             ///< "project.save"
    const char* text;
    const char* toolTip;
    const char* icon;           ///< name in icons.h, or ""
    const char* keys;           ///< "Ctrl+S", several separated by ", "; "" for none
    Availability availability = Availability::Always;
    bool checkable = false;
};

/// All actions of the window by id. Editors and panels add their rows and connect to their actions; the window enables
/// them by availability and builds the menus.
class ActionCatalogue : public QObject {
    Q_OBJECT
public:
    explicit ActionCatalogue(QObject* parent = nullptr);

    void add(const ActionRow& row);
    void add(std::initializer_list<ActionRow> rows);
    /// Null when there is no such id.
    QAction* action(const QString& id) const;
    const std::vector<ActionRow>& rows() const { return m_rows; }
    QString toolTip(const ActionRow& row) const;    ///< name, key and one sentence
    static QString plainName(const ActionRow& row);
    static QString sentence(const ActionRow& row);  ///< what it does
    /// Which states hold now; enables and disables. `reasonFor` fills the tool tip of what is off.
    void setState(Availability holding, const std::function<bool(const QString& id)>& editorCan);
    void retranslate();

    /// The keys as the catalogue's rows give them.
    static QList<QKeySequence> defaultKeys(const ActionRow& row);
    QList<QKeySequence> keys(const QString& id) const;
    void setKeys(const QString& id, const QList<QKeySequence>& keys);
    /// These keys belong to somebody else for now: no action answers to them until the list is emptied.
    void withhold(const QList<QKeySequence>& keys);

    template <class Receiver, class Slot>
    void on(const QString& id, Receiver* receiver, Slot slot)
    {
        QObject::connect(action(id), &QAction::triggered, receiver, slot);
    }

signals:
    void actionAdded(QAction* action);
    void keysChanged();

private:
    void applyKeys(const QString& id);
    QString whyDisabled(const ActionRow& row, Availability missing) const;

    std::vector<ActionRow> m_rows;
    std::map<QString, QAction*> m_actions;
    std::map<QString, QString> m_reasons;
    std::map<QString, QList<QKeySequence>> m_keys;
    QList<QKeySequence> m_withheld;
};

} // namespace camwright
