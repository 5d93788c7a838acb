#pragma once

#include "editors/program/textsearch.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace camwright {

/// Find and replace below a text. It knows no editor: it says what is asked for, and is told how many hits there are.
class FindBar : public QWidget {
    Q_OBJECT
public:
    explicit FindBar(QWidget* parent = nullptr);

    SearchQuery query() const;
    QString replacement() const;
    /// Opens it, with the selected text as what is looked for.
    void open(const QString& text, bool withReplace);
    /// `current` from 1; 0 when the cursor is at none of them.
    void showCount(int current, int total);
    void showError(const QString& sentence);

signals:
    void queryChanged();
    void findRequested(bool forward);
    void replaceRequested();
    void replaceAllRequested();
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QToolButton* option(const QString& text, const QString& name, const QString& toolTip);
    QToolButton* button(const QString& iconName, const QString& name, const QString& toolTip);

    QLineEdit* m_find;
    QLineEdit* m_replace;
    QToolButton* m_case;
    QToolButton* m_word;
    QToolButton* m_expression;
    QLabel* m_count;
    QWidget* m_replaceRow;
};

} // namespace camwright
