#pragma once

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace camwright {

/// A page that comes with Camwright.
struct DocPage {
    QString title;
    QString path;
};

/// The pages in share/camwright/docs by their first headings.
QList<DocPage> docPages();

/// Reads the pages that come with Camwright.
class DocViewer : public QDialog {
    Q_OBJECT
public:
    explicit DocViewer(const QString& path, QWidget* parent);

private:
    void showPage(const QString& path);

    QListWidget* m_list;
    QTextBrowser* m_text;
};

} // namespace camwright
