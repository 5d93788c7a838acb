#pragma once

#include <QDialog>

#include <functional>
#include <vector>

class QLineEdit;
class QListView;
class QStandardItemModel;

namespace camwright {

class Context;

/// One thing that can be found: what it is called, what it is, what happens on Enter.
struct PaletteEntry {
    QString text;
    QString detail;
    QString iconName;
    std::function<void()> go;
};

/// How well `typed` fits `text`, letters in order; negative: not at all. Starts of words and runs count more.
int matchScore(const QString& typed, const QString& text);

/// Find Anything (Ctrl+P) and Find Action (Ctrl+Shift+P): a line and the best fits below it.
class Palette : public QDialog {
    Q_OBJECT
public:
    Palette(const QString& title, const QString& placeholder, std::vector<PaletteEntry> entries, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refill();
    void choose();

    std::vector<PaletteEntry> m_entries;
    std::vector<std::size_t> m_shown;
    QLineEdit* m_line;
    QListView* m_list;
    QStandardItemModel* m_model;
};

/// Objects, variables and axis values of the project.
std::vector<PaletteEntry> findableObjects(Context& context);
/// Every action that can be used now.
std::vector<PaletteEntry> findableActions(Context& context);

} // namespace camwright
