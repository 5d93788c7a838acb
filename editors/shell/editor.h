#pragma once

#include "core/base/place.h"

#include <QIcon>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

class QAction;

namespace camwright {

class Context;

/// The view of one object, in a tab. It listens to ProjectDocument::changed itself and closes when its object is gone (the
/// window does that). Edits go through the document at once; a page with Apply keeps its draft in the document.
class Editor : public QWidget {
    Q_OBJECT
public:
    Editor(Context& context, ObjectKey key, QWidget* parent = nullptr);

    Context& context() const { return m_context; }
    const ObjectKey& key() const { return m_key; }
    /// The window calls it after a rename.
    virtual void setKey(const ObjectKey& key) { m_key = key; }

    virtual QString title() const;                       ///< the tab's; the object's name unless overridden
    virtual QString iconName() const = 0;
    /// Shows and marks a place of this object: a field, a line, a token.
    virtual void reveal(const Place& place) = 0;
    /// Where the user is, for back and forward.
    virtual Place place() const { return Place{m_key, {}, {}, {}}; }
    virtual QString positionText() const { return {}; }  ///< right part of the status bar: "line 12, column 5"
    /// Edit actions of the window ("edit.copy", "edit.find", "edit.rename", "go.definition"): can it, and do it.
    virtual bool can(const QString& actionId) const { Q_UNUSED(actionId); return false; }
    virtual void perform(const QString& actionId) { Q_UNUSED(actionId); }
    /// Widgets for the right end of the tab row while this editor is current, for example a Ladder/IL switch. May be null.
    virtual QWidget* tabRowWidget() { return nullptr; }
    /// A page for the right dock's Properties tab while this editor is current. May be null. Owned by the editor.
    virtual QWidget* propertiesWidget() { return nullptr; }
    /// False: the editor has an unapplied page and asked the user, who wants to stay.
    virtual bool mayClose() { return true; }

signals:
    void titleChanged();
    void closeRequested();                               ///< the window closes the tab, after mayClose()
    void positionChanged();
    void abilitiesChanged();                             ///< can() answers differently now

private:
    Context& m_context;
    ObjectKey m_key;
};

/// Makes the editors of one kind of object. A kind may have several views; the first registered is what Enter opens.
struct EditorFactory {
    QString viewId;                                      ///< "axis", "axis.commissioning"
    ObjectKind kind = ObjectKind::Project;
    QString name;                                        ///< translated: "Commissioning"
    QString iconName;
    std::function<Editor*(Context&, const ObjectKey&)> create;
    bool wantsLink = false;                              ///< offered only while online
};

} // namespace camwright
