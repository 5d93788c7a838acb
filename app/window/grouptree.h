#pragma once

#include "app/window/arrangement.h"
#include "app/window/dropzone.h"

#include <QWidget>

#include <functional>
#include <vector>

class QSplitter;

namespace camwright {

class EditorGroup;

/// Groups of tabs beside and below one another, with lines between them to drag. There is always at least one.
class GroupTree : public QWidget {
    Q_OBJECT
public:
    explicit GroupTree(EditorGroup* first, QWidget* parent = nullptr);

    std::vector<EditorGroup*> groups() const;      ///< in reading order
    bool has(const EditorGroup* group) const;
    /// `fresh` takes half of the room of `beside`.
    void insert(EditorGroup* fresh, EditorGroup* beside, Side side);
    /// Not the last one. The group has no parent afterwards and belongs to the caller.
    void remove(EditorGroup* group);

    Arrangement::Node arrangement() const;
    /// Anew from `root`; `make` gives the group for each leaf. The former groups belong to the caller.
    void rebuild(const Arrangement::Node& root, const std::function<EditorGroup*(const Arrangement::Node&)>& make);

private:
    void setRoot(QWidget* root);
    QSplitter* newSplitter(Qt::Orientation orientation);
    QWidget* build(const Arrangement::Node& node, const std::function<EditorGroup*(const Arrangement::Node&)>& make);

    QWidget* m_root = nullptr;
};

} // namespace camwright
