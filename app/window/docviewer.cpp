#include "app/window/docviewer.h"

#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"
#include "editors/words/shipped.h"

#include <QDesktopServices>
#include <QDirIterator>
#include <QFileInfo>
#include <QListWidget>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextList>
#include <QTextTable>
#include <QVBoxLayout>

namespace camwright {

namespace {

QString titleOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine()).trimmed();
        if (line.startsWith(QLatin1String("# ")))
            return line.mid(2);
    }
    return QFileInfo(path).baseName();
}

/// Markdown arrives without space between its paragraphs; this gives them some, and code its ground.
void spaceOut(QTextDocument& document)
{
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat format = block.blockFormat();
        const bool isCode = format.hasProperty(QTextFormat::BlockCodeFence) || format.hasProperty(QTextFormat::BlockCodeLanguage);
        const bool goesOn = isCode && block.next().isValid() && block.next().blockFormat().hasProperty(QTextFormat::BlockCodeFence);
        if (format.headingLevel() > 0) {
            format.setTopMargin(block == document.begin() ? 0 : 16);
            format.setBottomMargin(8);
        } else if (isCode) {
            format.setBackground(theme().color(Role::Raised));
            format.setBottomMargin(goesOn ? 0 : 10);
        } else if (!cursor.currentTable()) {
            format.setLineHeight(130, QTextBlockFormat::ProportionalHeight);
            format.setBottomMargin(block.textList() ? 3 : 10);
        }
        cursor.setBlockFormat(format);
    }
}

} // namespace

QList<DocPage> docPages()
{
    QList<DocPage> out;
    const QString folder = sharedPath(QStringLiteral("docs"));
    if (folder.isEmpty())
        return out;
    QDirIterator it(folder, {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories | QDirIterator::FollowSymlinks);
    while (it.hasNext()) {
        const QString path = it.next();
        out.append({titleOf(path), path});
    }
    std::sort(out.begin(), out.end(), [](const DocPage& a, const DocPage& b) {
        const bool learnA = a.path.contains(QLatin1String("/learn/"));
        const bool learnB = b.path.contains(QLatin1String("/learn/"));
        return std::tuple(!learnA, a.path) < std::tuple(!learnB, b.path);
    });
    return out;
}

DocViewer::DocViewer(const QString& path, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("docViewer"));
    setWindowTitle(tr("Documentation"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(980, 680);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* split = new QSplitter(this);
    split->setHandleWidth(1);
    m_list = new QListWidget(split);
    describe(m_list, "docList", tr("Pages"));
    m_text = new QTextBrowser(split);
    describe(m_text, "docText", tr("Page"));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setStyleSheet(QStringLiteral("border: none; padding: 16px 28px;"));
    m_text->setOpenLinks(false);
    split->setStretchFactor(1, 1);
    split->setSizes({240, 740});
    column->addWidget(split);
    for (const DocPage& page : docPages())
        addItem(page, m_list->count());
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item)
            showPage(item->data(Qt::UserRole).toString());
    });
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (!url.isRelative()) {
            QDesktopServices::openUrl(url);
            return;
        }
        const QString target = QFileInfo(m_path).dir().filePath(url.path());
        if (QFileInfo::exists(target))
            showPage(target);
    });
    if (!path.isEmpty())
        showPage(path);
    else if (m_list->count() > 0)
        m_list->setCurrentRow(0);
    m_text->setFocus(); // the arrow keys scroll
}

QListWidgetItem* DocViewer::addItem(const DocPage& page, int row)
{
    auto* item = new QListWidgetItem(page.title);
    item->setData(Qt::UserRole, page.path);
    item->setToolTip(page.title);
    item->setSizeHint({100, Theme::TreeRow + 4});
    m_list->insertItem(row, item);
    return item;
}

QListWidgetItem* DocViewer::itemOf(const QString& path)
{
    for (int row = 0; row < m_list->count(); ++row) {
        if (QDir::cleanPath(m_list->item(row)->data(Qt::UserRole).toString()) == QDir::cleanPath(path))
            return m_list->item(row);
    }
    delete m_extra;
    m_extra = addItem({titleOf(path), path}, 0);
    return m_extra;
}

void DocViewer::showPage(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return;
    m_path = path;
    const QSignalBlocker quiet(m_list);
    m_list->setCurrentItem(itemOf(path));
    m_text->setSearchPaths({QFileInfo(path).path()});
    m_text->setMarkdown(QString::fromUtf8(file.readAll()));
    spaceOut(*m_text->document());
    m_text->moveCursor(QTextCursor::Start);
}

} // namespace camwright
