#include "app/window/docviewer.h"

#include "app/window/settings.h"
#include "editors/shell/theme.h"
#include "editors/shell/widgets.h"

#include <QDesktopServices>
#include <QDirIterator>
#include <QFileInfo>
#include <QListWidget>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocument>
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
    for (const DocPage& page : docPages()) {
        auto* item = new QListWidgetItem(page.title, m_list);
        item->setData(Qt::UserRole, page.path);
        item->setSizeHint({100, Theme::TreeRow + 4});
        if (page.path == path)
            m_list->setCurrentItem(item);
    }
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item)
            showPage(item->data(Qt::UserRole).toString());
    });
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (!url.isRelative()) {
            QDesktopServices::openUrl(url);
            return;
        }
        const QListWidgetItem* item = m_list->currentItem();
        const QString target = item ? QFileInfo(item->data(Qt::UserRole).toString()).dir().filePath(url.path()) : QString();
        if (QFileInfo::exists(target))
            showPage(target);
    });
    if (m_list->currentItem())
        showPage(m_list->currentItem()->data(Qt::UserRole).toString());
    else if (m_list->count() > 0)
        m_list->setCurrentRow(0);
}

void DocViewer::showPage(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return;
    m_text->setSearchPaths({QFileInfo(path).path()});
    m_text->setMarkdown(QString::fromUtf8(file.readAll()));
}

} // namespace camwright
