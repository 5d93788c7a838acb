#include "editors/shell/actions.h"

#include "editors/shell/icons.h"
#include "editors/words/words.h"

#include <QCoreApplication>

#include <algorithm>

namespace camwright {

namespace {

QString translated(const char* text)
{
    return text && *text ? QCoreApplication::translate("Actions", text) : QString();
}

} // namespace

ActionCatalogue::ActionCatalogue(QObject* parent) : QObject(parent) {}

void ActionCatalogue::add(const ActionRow& row)
{
    const QString id = QString::fromLatin1(row.id);
    if (m_actions.contains(id))
        return;
    m_rows.push_back(row);
    auto* made = new QAction(icon(QString::fromLatin1(row.icon)), translated(row.text), this);
    made->setObjectName(id);
    made->setCheckable(row.checkable);
    made->setShortcutContext(Qt::WindowShortcut);
    m_actions.emplace(id, made);
    m_keys[id] = defaultKeys(row);
    applyKeys(id);
    made->setToolTip(toolTip(row));
    made->setStatusTip(translated(row.toolTip));
    emit actionAdded(made);
}

void ActionCatalogue::add(std::initializer_list<ActionRow> rows)
{
    for (const ActionRow& row : rows)
        add(row);
}

QAction* ActionCatalogue::action(const QString& id) const
{
    const auto it = m_actions.find(id);
    return it == m_actions.end() ? nullptr : it->second;
}

QString ActionCatalogue::plainName(const ActionRow& row)
{
    return words::plainName(translated(row.text));
}

QString ActionCatalogue::sentence(const ActionRow& row)
{
    return translated(row.toolTip);
}

QString ActionCatalogue::toolTip(const ActionRow& row) const
{
    QString name = plainName(row);
    if (const auto own = keys(QString::fromLatin1(row.id)); !own.isEmpty())
        name += QStringLiteral(" (%1)").arg(own.first().toString(QKeySequence::NativeText));
    QString out = QStringLiteral("<b>%1</b><br>%2").arg(name.toHtmlEscaped(), translated(row.toolTip).toHtmlEscaped());
    const auto reason = m_reasons.find(QString::fromLatin1(row.id));
    if (reason != m_reasons.end() && !reason->second.isEmpty())
        out += QStringLiteral("<br><i>%1</i>").arg(reason->second.toHtmlEscaped());
    return out;
}

QString ActionCatalogue::whyDisabled(const ActionRow& row, Availability missing) const
{
    Q_UNUSED(row);
    if (missing & Availability::ProjectOpen)
        return tr("No project is open.");
    if (missing & Availability::Online)
        return tr("No controller is connected.");
    if (missing & Availability::Offline)
        return tr("A controller is connected already.");
    if (missing & Availability::Running)
        return tr("The controller does not run.");
    if (missing & Availability::Stopped)
        return tr("The controller runs already.");
    if (missing & Availability::Idle)
        return tr("A build or download is running.");
    if (missing & Availability::CanUndo)
        return tr("There is no step to undo.");
    if (missing & Availability::CanRedo)
        return tr("There is no step to redo.");
    if (missing & Availability::Modified)
        return tr("Everything is saved.");
    if (missing & Availability::Problems)
        return tr("There is no problem.");
    if (missing & Availability::TabOpen)
        return tr("No tab is open.");
    if (missing & Availability::TabMovable)
        return tr("There is no other place for the tab. Split the editors first.");
    if (missing & Availability::SeveralGroups)
        return tr("There is one group of tabs only.");
    return tr("The current view does not offer it.");
}

void ActionCatalogue::setState(Availability holding, const std::function<bool(const QString&)>& editorCan)
{
    for (const ActionRow& row : m_rows) {
        const QString id = QString::fromLatin1(row.id);
        unsigned missing = unsigned(row.availability) & ~unsigned(holding);
        if (row.availability & Availability::Editor)
            missing = editorCan(id) ? missing & ~unsigned(Availability::Editor) : missing | unsigned(Availability::Editor);
        m_reasons[id] = missing ? whyDisabled(row, Availability(missing)) : QString();
        QAction* made = m_actions.at(id);
        made->setEnabled(missing == 0);
        made->setToolTip(toolTip(row));
    }
}

void ActionCatalogue::retranslate()
{
    for (const ActionRow& row : m_rows) {
        QAction* made = m_actions.at(QString::fromLatin1(row.id));
        made->setText(translated(row.text));
        made->setToolTip(toolTip(row));
        made->setStatusTip(translated(row.toolTip));
    }
}

// --- keys

QList<QKeySequence> ActionCatalogue::defaultKeys(const ActionRow& row)
{
    QList<QKeySequence> out;
    for (const QString& key : QString::fromLatin1(row.keys).split(QStringLiteral(", "), Qt::SkipEmptyParts))
        out << QKeySequence::fromString(key, QKeySequence::PortableText);
    return out;
}

QList<QKeySequence> ActionCatalogue::keys(const QString& id) const
{
    const auto found = m_keys.find(id);
    return found == m_keys.end() ? QList<QKeySequence>() : found->second;
}

void ActionCatalogue::setKeys(const QString& id, const QList<QKeySequence>& keys)
{
    if (!action(id) || keys == this->keys(id))
        return;
    m_keys[id] = keys;
    applyKeys(id);
    const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const ActionRow& each) { return id == QLatin1String(each.id); });
    action(id)->setToolTip(toolTip(*row));
    emit keysChanged();
}

void ActionCatalogue::withhold(const QList<QKeySequence>& keys)
{
    m_withheld = keys;
    for (const auto& [id, own] : m_keys)
        applyKeys(id);
}

void ActionCatalogue::applyKeys(const QString& id)
{
    QList<QKeySequence> free = m_keys.at(id);
    free.removeIf([this](const QKeySequence& key) { return m_withheld.contains(key); });
    m_actions.at(id)->setShortcuts(free);
}

} // namespace camwright
