#include "app/window/grouptree.h"

#include "app/window/editorgroup.h"

#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

namespace {

void collect(QWidget* widget, std::vector<EditorGroup*>& out)
{
    if (auto* group = qobject_cast<EditorGroup*>(widget)) {
        out.push_back(group);
    } else if (auto* splitter = qobject_cast<QSplitter*>(widget)) {
        for (int i = 0; i < splitter->count(); ++i)
            collect(splitter->widget(i), out);
    }
}

Arrangement::Node nodeOf(QWidget* widget)
{
    if (const auto* group = qobject_cast<EditorGroup*>(widget))
        return group->arrangement();
    Arrangement::Node out;
    if (auto* splitter = qobject_cast<QSplitter*>(widget)) {
        out.horizontal = splitter->orientation() == Qt::Horizontal;
        out.sizes = splitter->sizes();
        for (int i = 0; i < splitter->count(); ++i)
            out.parts.push_back(nodeOf(splitter->widget(i)));
    }
    return out;
}

QList<int> halves(const QSplitter& splitter)
{
    const int length = splitter.orientation() == Qt::Horizontal ? splitter.width() : splitter.height();
    return {std::max(1, length / 2), std::max(1, length / 2)};
}

} // namespace

GroupTree::GroupTree(EditorGroup* first, QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    setRoot(first);
}

void GroupTree::setRoot(QWidget* root)
{
    m_root = root;
    layout()->addWidget(root);
    root->show();
}

QSplitter* GroupTree::newSplitter(Qt::Orientation orientation)
{
    auto* out = new QSplitter(orientation, this);
    out->setObjectName(QStringLiteral("editorSplitter"));
    out->setHandleWidth(1);
    out->setChildrenCollapsible(false);
    return out;
}

std::vector<EditorGroup*> GroupTree::groups() const
{
    std::vector<EditorGroup*> out;
    collect(m_root, out);
    return out;
}

bool GroupTree::has(const EditorGroup* group) const
{
    return group && isAncestorOf(group);
}

void GroupTree::insert(EditorGroup* fresh, EditorGroup* beside, Side side)
{
    const Qt::Orientation wanted = side == Side::Left || side == Side::Right ? Qt::Horizontal : Qt::Vertical;
    const bool behind = side == Side::Right || side == Side::Below;
    auto* parent = qobject_cast<QSplitter*>(beside->parentWidget());
    if (parent && parent->orientation() == wanted) {
        QList<int> sizes = parent->sizes();
        const int at = parent->indexOf(beside);
        const int half = std::max(1, sizes[at] / 2);
        sizes[at] = half;
        sizes.insert(at, half);
        parent->insertWidget(at + (behind ? 1 : 0), fresh);
        fresh->show();
        parent->setSizes(sizes);
        return;
    }
    auto* splitter = newSplitter(wanted);
    if (parent) {
        const QList<int> sizes = parent->sizes();
        parent->replaceWidget(parent->indexOf(beside), splitter);
        parent->setSizes(sizes);
    } else {
        splitter->resize(size());
        setRoot(splitter);
    }
    splitter->addWidget(beside);
    splitter->insertWidget(behind ? 1 : 0, fresh);
    splitter->show();
    beside->show();
    fresh->show();
    splitter->setSizes(halves(*splitter));
}

void GroupTree::remove(EditorGroup* group)
{
    auto* splitter = qobject_cast<QSplitter*>(group->parentWidget());
    if (!splitter)
        return;
    group->hide();
    group->setParent(nullptr);
    if (splitter->count() != 1)
        return;
    // A line between one part and nothing goes away.
    QWidget* left = splitter->widget(0);
    if (auto* parent = qobject_cast<QSplitter*>(splitter->parentWidget())) {
        const QList<int> sizes = parent->sizes();
        parent->replaceWidget(parent->indexOf(splitter), left);
        left->show();
        parent->setSizes(sizes);
    } else {
        setRoot(left);
    }
    delete splitter;
}

Arrangement::Node GroupTree::arrangement() const
{
    return nodeOf(m_root);
}

QWidget* GroupTree::build(const Arrangement::Node& node, const std::function<EditorGroup*(const Arrangement::Node&)>& make)
{
    if (node.parts.empty())
        return make(node);
    auto* out = newSplitter(node.horizontal ? Qt::Horizontal : Qt::Vertical);
    for (const Arrangement::Node& part : node.parts)
        out->addWidget(build(part, make));
    out->setSizes(node.sizes);
    return out;
}

void GroupTree::rebuild(const Arrangement::Node& root, const std::function<EditorGroup*(const Arrangement::Node&)>& make)
{
    for (EditorGroup* group : groups()) {
        group->hide();
        group->setParent(nullptr);
    }
    if (qobject_cast<QSplitter*>(m_root))
        delete m_root;
    setRoot(build(root, make));
}

} // namespace camwright
