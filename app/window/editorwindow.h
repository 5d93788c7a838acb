#pragma once

#include <QWidget>

class QVBoxLayout;

namespace camwright {

class EditorGroup;
class GroupTree;

/// A window beside the main one, for tabs that were dragged out. It has the same document, the same undo and the same keys;
/// closing it brings its tabs back.
class EditorWindow : public QWidget {
    Q_OBJECT
public:
    explicit EditorWindow(EditorGroup* first);

    GroupTree& tree() const { return *m_tree; }
    /// A strip above the tabs that the main window gives.
    void setHead(QWidget* head);
    /// There, or as near as a screen that is plugged in allows.
    void place(const QRect& wanted);

signals:
    void closing();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    QVBoxLayout* m_column;
    GroupTree* m_tree;
};

} // namespace camwright
