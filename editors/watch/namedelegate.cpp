#include "editors/watch/namedelegate.h"

#include "editors/document/projectdocument.h"
#include "editors/shell/theme.h"
#include "editors/watch/variablelookup.h"

#include <QCompleter>
#include <QLineEdit>

namespace camwright {

NameDelegate::NameDelegate(ProjectDocument& document, QObject* parent)
    : QStyledItemDelegate(parent), m_document(document)
{
}

QWidget* NameDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const
{
    auto* edit = new QLineEdit(parent);
    edit->setFont(theme().monoFont());
    edit->setAccessibleName(tr("Name or address"));
    auto* completer = new QCompleter(watchableNames(m_document.project()), edit);
    completer->setFilterMode(Qt::MatchContains);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    edit->setCompleter(completer);
    return edit;
}

} // namespace camwright
