// Find and replace in the program editor.
#include "editors/program/indicators.h"

#include "editors/document/editcommands.h"
#include "editors/program/findbar.h"
#include "editors/program/ilcodeview.h"
#include "editors/program/programeditor.h"
#include "editors/shell/context.h"

namespace camwright {

void ProgramEditor::updateSearch()
{
    const TextSearch search(m_find->query());
    const QByteArray source = m_view->source();
    m_hits = search.findAll(source);
    m_view->SendScintilla(QsciScintilla::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(SearchIndicator));
    m_view->SendScintilla(QsciScintilla::SCI_INDICATORCLEARRANGE, 0UL, static_cast<long>(source.size()));
    for (const SearchHit& hit : m_hits)
        m_view->SendScintilla(QsciScintilla::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(hit.offset), static_cast<long>(hit.length));
    if (!search.error().isEmpty())
        m_find->showError(search.error());
    else
        m_find->showCount(0, static_cast<int>(m_hits.size()));
}

void ProgramEditor::findNext(bool forward)
{
    updateSearch();
    if (m_hits.empty())
        return;
    const auto from = static_cast<qsizetype>(m_view->SendScintilla(forward ? QsciScintilla::SCI_GETSELECTIONEND : QsciScintilla::SCI_GETSELECTIONSTART));
    std::size_t index = 0;
    if (forward) {
        while (index < m_hits.size() && m_hits[index].offset < from)
            ++index;
        index %= m_hits.size(); // behind the last hit it goes on at the first
    } else {
        index = m_hits.size();
        while (index > 0 && m_hits[index - 1].offset >= from)
            --index;
        index = index == 0 ? m_hits.size() - 1 : index - 1;
    }
    const SearchHit& hit = m_hits[index];
    m_view->SendScintilla(QsciScintilla::SCI_SETSEL, static_cast<unsigned long>(hit.offset), static_cast<long>(hit.offset + hit.length));
    m_find->showCount(static_cast<int>(index) + 1, static_cast<int>(m_hits.size()));
}

void ProgramEditor::replaceOne()
{
    const TextSearch search(m_find->query());
    const QByteArray source = m_view->source();
    const auto from = static_cast<qsizetype>(m_view->SendScintilla(QsciScintilla::SCI_GETSELECTIONSTART));
    const auto to = static_cast<qsizetype>(m_view->SendScintilla(QsciScintilla::SCI_GETSELECTIONEND));
    for (const SearchHit& hit : search.findAll(source)) {
        if (hit != SearchHit{from, to - from})
            continue;
        const QByteArray with = search.replacement(source, hit, m_find->replacement());
        context().document().closeMerge();
        editText(context().document(), key(), static_cast<std::size_t>(hit.offset), static_cast<std::size_t>(hit.length), with.toStdString());
        m_view->SendScintilla(QsciScintilla::SCI_GOTOPOS, static_cast<unsigned long>(hit.offset + with.size()));
        break;
    }
    findNext(true);
}

void ProgramEditor::replaceAll()
{
    const QByteArray source = m_view->source();
    int count = 0;
    const QByteArray replaced = TextSearch(m_find->query()).replaceAll(source, m_find->replacement(), count);
    if (count == 0)
        return;
    context().document().closeMerge();
    editText(context().document(), key(), 0, static_cast<std::size_t>(source.size()), replaced.toStdString());
    context().document().closeMerge();
    context().notify(Severity::Information, tr("%n place(s) replaced. Ctrl+Z takes them back.", nullptr, count));
}

void ProgramEditor::closeFind()
{
    m_find->hide();
    m_hits.clear();
    m_view->SendScintilla(QsciScintilla::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(SearchIndicator));
    m_view->SendScintilla(QsciScintilla::SCI_INDICATORCLEARRANGE, 0UL, static_cast<long>(m_view->source().size()));
    m_view->setFocus();
}

} // namespace camwright
