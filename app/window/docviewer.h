#pragma once

#include <QDialog>

class QListWidget;
class QListWidgetItem;
class QTextBrowser;

namespace camwright {

/// A page that comes with Camwright.
struct DocPage {
    QString title;
    QString path;
};

/// The pages in share/camwright/docs by their first headings.
QList<DocPage> docPages();

/// Reads the pages that come with Camwright: those of docPages(), and above them the latest other one it was asked for.
class DocViewer : public QDialog {
    Q_OBJECT
public:
    /// Begins with the first page of the list when `path` is empty.
    explicit DocViewer(const QString& path, QWidget* parent);
    void showPage(const QString& path);

private:
    QListWidgetItem* addItem(const DocPage& page, int row);
    QListWidgetItem* itemOf(const QString& path);

    QListWidget* m_list;
    QTextBrowser* m_text;
    QListWidgetItem* m_extra = nullptr; ///< the latest page that is not one of docPages(), at the top of the list
    QString m_path;
};

} // namespace camwright
