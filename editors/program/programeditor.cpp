#include "editors/program/programeditor.h"

#include "core/language/exchange/ilpfile.h"
#include "core/language/exchange/pastedtext.h"
#include "editors/document/editcommands.h"
#include "editors/program/findbar.h"
#include "editors/program/ilcodeview.h"
#include "editors/program/livetext.h"
#include "editors/program/programassist.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/fixes.h"
#include "editors/shell/widgets.h"
#include "editors/words/words.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QClipboard>
#include <QMenu>
#include <QToolTip>
#include <QVBoxLayout>

namespace camwright {

namespace {

constexpr int CompletionList = 1;

const Dialect& dialectFor(const Project& project)
{
    const Dialect* dialect = dialectOfFamily(project.controller().family);
    return dialect ? *dialect : kincoIl();
}

} // namespace

ProgramEditor::ProgramEditor(Context& context, ObjectKey key, QWidget* parent)
    : Editor(context, std::move(key), parent)
{
    buildView();
    connectView();
    loadSource();
    showProblems();
}

void ProgramEditor::buildView()
{
    m_view = new IlCodeView(dialectFor(context().document().project()), this);
    m_view->setObjectName(QStringLiteral("programText"));
    m_view->setAccessibleName(tr("Program text"));
    m_find = new FindBar(this);
    m_find->hide();
    m_notice = new Banner(Severity::Warning, QString(), this);
    m_notice->hide();
    m_live = new LiveText(context(), *m_view, key());
    m_liveNotice = new Banner(Severity::Information, QString(), this);
    m_liveNotice->setObjectName(QStringLiteral("liveNotice"));
    m_liveNotice->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_notice);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_liveNotice);
    layout->addWidget(m_find);
    setFocusProxy(m_view);
}

void ProgramEditor::connectView()
{
    ProjectDocument& document = context().document();
    connect(&document, &ProjectDocument::changed, this, &ProgramEditor::documentChanged);
    connect(&document, &ProjectDocument::diagnosticsChanged, this, &ProgramEditor::showProblems);
    connect(m_view, &IlCodeView::edited, this, &ProgramEditor::textEdited);
    connect(m_view, &IlCodeView::hovered, this, &ProgramEditor::showHover);
    connect(m_view, &QsciScintilla::cursorPositionChanged, this, &ProgramEditor::cursorMoved);
    connect(m_view, &QsciScintilla::selectionChanged, this, &ProgramEditor::abilitiesChanged);
    connect(m_view, &QsciScintillaBase::SCN_CHARADDED, this, [this](int) { complete(false); });
    connect(m_view, qOverload<const char*, int>(&QsciScintillaBase::SCN_USERLISTSELECTION), this,
        [this](const char* text, int) { acceptCompletion(QByteArray(text)); });
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this, [this](const QPoint& point) { showMenu(m_view->mapToGlobal(point)); });

    connect(m_view, &IlCodeView::fixesRequested, this, [this](int line) {
        m_view->setCursorPosition(line, 0);
        showQuickFixes();
    });
    connect(m_live, &LiveText::noticeChanged, this, &ProgramEditor::showLiveNotice);

    connect(m_find, &FindBar::queryChanged, this, &ProgramEditor::updateSearch);
    connect(m_find, &FindBar::findRequested, this, &ProgramEditor::findNext);
    connect(m_find, &FindBar::replaceRequested, this, &ProgramEditor::replaceOne);
    connect(m_find, &FindBar::replaceAllRequested, this, &ProgramEditor::replaceAll);
    connect(m_find, &FindBar::closed, this, &ProgramEditor::closeFind);
}

// The document and the text

void ProgramEditor::documentChanged(const ProjectChange& change)
{
    if (change.touches(key()) && !m_applying)
        loadSource();
}

void ProgramEditor::loadSource()
{
    if (const Program* program = context().document().content<Program>(key()))
        m_view->setSource(QByteArray::fromStdString(program->source));
    if (m_find->isVisible())
        updateSearch();
}

void ProgramEditor::textEdited(std::size_t offset, std::size_t removed, const QByteArray& inserted)
{
    m_applying = true;
    editText(context().document(), key(), offset, removed, inserted.toStdString());
    m_applying = false;
    if (m_find->isVisible())
        updateSearch();
}

void ProgramEditor::cursorMoved()
{
    if (!m_applying)
        context().document().closeMerge();
    const QByteArray word = m_view->wordAt(m_view->position());
    context().select({place(), QString::fromUtf8(word)});
    m_view->setFixLine(problemsHere().empty() ? -1 : static_cast<int>(m_view->selectedRange().line) - 1);
    emit positionChanged();
}

void ProgramEditor::setKey(const ObjectKey& key)
{
    Editor::setKey(key);
    m_live->setKey(key);
}

void ProgramEditor::showEvent(QShowEvent* event)
{
    Editor::showEvent(event);
    m_live->setActive(true);
}

void ProgramEditor::hideEvent(QHideEvent* event)
{
    Editor::hideEvent(event);
    m_live->setActive(false);
}

void ProgramEditor::showLiveNotice()
{
    m_liveNotice->setSentence(m_live->notice());
    m_liveNotice->setVisible(!m_live->notice().isEmpty());
}

// Places

void ProgramEditor::reveal(const Place& place)
{
    if (place.range.isValid())
        m_view->selectRange(place.range);
    m_view->setFocus();
}

Place ProgramEditor::place() const
{
    return Place{key(), "source", m_view->selectedRange(), {}};
}

QString ProgramEditor::positionText() const
{
    const TextRange range = m_view->selectedRange();
    return tr("line %1, column %2").arg(range.line).arg(range.column);
}

// Problems and help

void ProgramEditor::showProblems()
{
    m_view->showDiagnostics(context().document().diagnosticsOf(key()));
    m_view->setFixLine(problemsHere().empty() ? -1 : static_cast<int>(m_view->selectedRange().line) - 1);
    emit abilitiesChanged();
}

/// Problems that may have a fix: those under the cursor, else those of its line.
Diagnostics ProgramEditor::problemsHere() const
{
    Diagnostics out;
    for (const Diagnostic* d : m_view->diagnosticsAt(m_view->position()))
        if (mayFix(context(), d->code))
            out.push_back(*d);
    const std::uint32_t line = m_view->selectedRange().line;
    if (out.empty())
        for (const Diagnostic& d : context().document().diagnosticsOf(key()))
            if (d.place.range.line <= line && d.place.range.endLine >= line && mayFix(context(), d.code))
                out.push_back(d);
    return out;
}

void ProgramEditor::showQuickFixes()
{
    showFixes(context(), problemsHere(), m_view, m_view->pointOf(m_view->position()));
}

void ProgramEditor::findReferences()
{
    context().findReferences({place(), QString::fromUtf8(m_view->wordAt(m_view->position()))});
}

void ProgramEditor::showHover(int position, const QPoint& globalPoint)
{
    if (position < 0) {
        QToolTip::hideText();
        return;
    }
    QStringList parts;
    if (const QString value = m_live->valueAt(position); !value.isEmpty())
        parts << QStringLiteral("<p><b>%1</b></p>").arg(value.toHtmlEscaped());
    for (const Diagnostic* d : m_view->diagnosticsAt(position))
        parts << QStringLiteral("<p><b>%1</b> %2</p>").arg(words::codeId(d->code), words::sentence(*d).toHtmlEscaped());
    const QString help = assist::hover(context().document().project(), m_view->source(), position);
    if (!help.isEmpty())
        parts << help;
    if (!parts.isEmpty())
        QToolTip::showText(globalPoint, parts.join(QStringLiteral("<hr>")), m_view);
}

// Completion

void ProgramEditor::complete(bool asked)
{
    const assist::Completions found = assist::complete(context().document().project(), m_view->source(), m_view->position(), asked);
    if (found.entries.isEmpty()) {
        m_view->SendScintilla(QsciScintilla::SCI_AUTOCCANCEL);
        return;
    }
    m_view->SendScintilla(QsciScintilla::SCI_AUTOCSETSEPARATOR, static_cast<unsigned long>('\n'));
    m_view->SendScintilla(QsciScintilla::SCI_AUTOCSETORDER, 1UL);
    m_view->SendScintilla(QsciScintilla::SCI_USERLISTSHOW, static_cast<uintptr_t>(CompletionList), found.entries.join(QLatin1Char('\n')).toUtf8().constData());
}

void ProgramEditor::acceptCompletion(const QByteArray& chosen)
{
    const QByteArray text = assist::insertionOf(chosen);
    const assist::Completions now = assist::complete(context().document().project(), m_view->source(), m_view->position(), true);
    m_view->SendScintilla(QsciScintilla::SCI_SETTARGETSTART, static_cast<unsigned long>(now.begin));
    m_view->SendScintilla(QsciScintilla::SCI_SETTARGETEND, static_cast<unsigned long>(now.end));
    m_view->SendScintilla(QsciScintilla::SCI_REPLACETARGET, static_cast<uintptr_t>(text.size()), text.constData());
    m_view->SendScintilla(QsciScintilla::SCI_GOTOPOS, static_cast<unsigned long>(now.begin + text.size()));
}

// Editing

void ProgramEditor::pasteText()
{
    const std::string pasted = QApplication::clipboard()->text().toStdString();
    if (pasted.empty())
        return;
    const RepairedText repaired = repairPastedText(dialectFor(context().document().project()), pasted);
    m_view->replaceSelectedText(QString::fromStdString(pasted));
    m_notice->hide();
    if (repaired.repairs.empty())
        return;
    // Offered, never done unasked: what was pasted stands in the text as it came.
    auto* notice = new Banner(Severity::Warning, tr("The pasted text has marks of a document, not of a program: %n place(s). It can be cleaned.", nullptr,
        static_cast<int>(repaired.repairs.size())), this);
    static_cast<QVBoxLayout*>(layout())->replaceWidget(m_notice, notice);
    m_notice->deleteLater();
    m_notice = notice;
    connect(notice->addButton(tr("Clean the Pasted Text"), true), &QPushButton::clicked, this, [this, pasted, text = repaired.text] {
        const QByteArray source = m_view->source();
        const qsizetype at = source.lastIndexOf(QByteArray::fromStdString(pasted), m_view->position());
        if (at >= 0)
            editText(context().document(), key(), static_cast<std::size_t>(at), pasted.size(), text);
        m_notice->hide();
    });
    connect(notice->addButton(tr("Keep It")), &QPushButton::clicked, m_notice, &QWidget::hide);
}

void ProgramEditor::importFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Import Kinco Program Text"), QString(), tr("KincoBuilder programs (*.ilp *.il *.txt);;All files (*)"));
    if (path.isEmpty())
        return;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        context().notify(Severity::Error, tr("\"%1\" cannot be read: %2.").arg(path, file.errorString()));
        return;
    }
    importText(file.readAll().toStdString(), QFileInfo(path).fileName().toStdString());
}

void ProgramEditor::importText(const std::string& text, const std::string& name)
{
    const IlpImport imported = importIlp(text, name);
    for (const Diagnostic& d : imported.diagnostics)
        context().notify(d);
    context().document().closeMerge();
    editText(context().document(), key(), 0, static_cast<std::size_t>(m_view->source().size()), imported.source);
    context().document().closeMerge();
    context().notify(Severity::Information, tr("The program was replaced by the text of \"%1\". Ctrl+Z takes it back.").arg(QString::fromStdString(name)));
}

void ProgramEditor::toggleComment()
{
    const TextRange range = m_view->selectedRange();
    const auto change = assist::toggleComment(m_view->source(), range.line, range.endColumn == 1 && range.endLine > range.line ? range.endLine - 1 : range.endLine);
    editText(context().document(), key(), change.offset, change.removed, change.inserted.toStdString());
}

void ProgramEditor::moveToDefinition()
{
    if (const auto place = assist::definitionOf(context().document().project(), m_view->wordAt(m_view->position())))
        context().reveal(*place);
    else
        context().notify(Severity::Information, tr("\"%1\" has no definition in this project.").arg(QString::fromUtf8(m_view->wordAt(m_view->position()))));
}

bool ProgramEditor::can(const QString& actionId) const
{
    if (actionId == QLatin1String("edit.cut") || actionId == QLatin1String("edit.copy"))
        return m_view->hasSelectedText();
    static const QStringList always{QStringLiteral("edit.paste"), QStringLiteral("edit.selectAll"), QStringLiteral("edit.find"),
        QStringLiteral("edit.replace"), QStringLiteral("edit.findNext"), QStringLiteral("edit.findPrevious"), QStringLiteral("edit.comment"),
        QStringLiteral("edit.complete"), QStringLiteral("go.definition"), QStringLiteral("edit.delete")};
    if (actionId == QLatin1String("edit.quickFix"))
        return !problemsHere().empty();
    if (actionId == QLatin1String("go.references"))
        return !m_view->wordAt(m_view->position()).isEmpty();
    if (actionId == QLatin1String("program.import"))
        return context().document().project().controller().family == "kinco";
    return always.contains(actionId);
}

void ProgramEditor::perform(const QString& id)
{
    if (id == QLatin1String("edit.cut"))
        m_view->cut();
    else if (id == QLatin1String("edit.copy"))
        m_view->copy();
    else if (id == QLatin1String("edit.paste"))
        pasteText();
    else if (id == QLatin1String("edit.delete"))
        m_view->removeSelectedText();
    else if (id == QLatin1String("edit.selectAll"))
        m_view->selectAll();
    else if (id == QLatin1String("edit.find"))
        m_find->open(m_view->selectedText(), false);
    else if (id == QLatin1String("edit.replace"))
        m_find->open(m_view->selectedText(), true);
    else if (id == QLatin1String("edit.findNext"))
        findNext(true);
    else if (id == QLatin1String("edit.findPrevious"))
        findNext(false);
    else if (id == QLatin1String("edit.comment"))
        toggleComment();
    else if (id == QLatin1String("edit.complete"))
        complete(true);
    else if (id == QLatin1String("go.definition"))
        moveToDefinition();
    else if (id == QLatin1String("go.references"))
        findReferences();
    else if (id == QLatin1String("edit.quickFix"))
        showQuickFixes();
    else if (id == QLatin1String("program.import"))
        importFile();
}

void ProgramEditor::showMenu(const QPoint& globalPoint)
{
    QMenu menu(this);
    for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "", "edit.find", "edit.replace", "", "edit.comment", "edit.complete", "edit.quickFix", "", "go.definition", "go.references", "", "program.import"}) {
        QAction* action = context().actions().action(QString::fromLatin1(id));
        if (!*id)
            menu.addSeparator();
        else if (action)
            menu.addAction(action);
    }
    menu.exec(globalPoint);
}

} // namespace camwright
