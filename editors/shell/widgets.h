#pragma once

#include "core/base/codes.h"
#include "editors/shell/theme.h"

#include <QAbstractButton>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

class QVBoxLayout;

namespace camwright {

/// Two to four choices side by side; one is on. Left and right arrows move.
class SegmentedControl : public QWidget {
    Q_OBJECT
public:
    explicit SegmentedControl(const QString& accessibleName, QWidget* parent = nullptr);
    void addSegment(const QString& text, const QString& iconName = {}, const QString& toolTip = {});
    int currentIndex() const { return m_current; }
    void setCurrentIndex(int index); ///< does not emit chosen()

signals:
    void chosen(int index);          ///< by the user

private:
    std::vector<QAbstractButton*> m_buttons;
    int m_current = -1;
};

/// An on/off switch.
class Switch : public QAbstractButton {
    Q_OBJECT
public:
    explicit Switch(const QString& accessibleName, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {40, 22}; }
    void setOnRole(Role role) { m_onRole = role; update(); }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    Role m_onRole = Role::Accent;
};

/// A word in a rounded, tinted shape: RUN, "2 errors". With a glyph before it where it tells a state.
class Pill : public QWidget {
    Q_OBJECT
public:
    explicit Pill(QWidget* parent = nullptr);
    void setContent(const QString& text, Role ink, Role fill, const QString& iconName = {});
    QString text() const { return m_text; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString m_text, m_icon;
    Role m_ink = Role::Dim, m_fill = Role::FineLine;
};

/// A button that acts while it is held: by mouse or by Space. Emits released() exactly once for every pressed(), also when the
/// focus leaves, the window is deactivated, the button is hidden or disabled.
class HoldButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit HoldButton(const QString& accessibleName, QWidget* parent = nullptr);
    bool isHeld() const { return m_held; }
    void setCaption(const QString& big, const QString& small, const QString& key = {});
    /// For keys handled elsewhere (F1 … F4 while armed).
    void hold();
    void letGo();
    QSize sizeHint() const override { return {112, 52}; }

signals:
    void held();
    void letGone();

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void hideEvent(QHideEvent*) override;
    void changeEvent(QEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    bool m_held = false;
    QString m_big, m_small, m_key;
};

/// A heading of a group: text, an optional dim explanation, and room for widgets at the right.
class SectionHeader : public QWidget {
    Q_OBJECT
public:
    explicit SectionHeader(const QString& title, const QString& explanation = {}, QWidget* parent = nullptr);
    void addWidget(QWidget* widget);
    void setTitle(const QString& title);
    void setExplanation(const QString& text);

private:
    QLabel* m_title;
    QLabel* m_explanation;
};

/// What an empty view shows: an icon, one sentence, what to do next as buttons.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    EmptyState(const QString& iconName, const QString& sentence, QWidget* parent = nullptr);
    void setSentence(const QString& sentence);
    QPushButton* addButton(const QString& text, bool primary = false);

private:
    QLabel* m_icon;
    QLabel* m_label;
    QVBoxLayout* m_layout;
};

/// A coloured bar across a page with an icon, a sentence and buttons for the ways out.
class Banner : public QFrame {
    Q_OBJECT
public:
    Banner(Severity severity, const QString& sentence, QWidget* parent = nullptr);
    void setSentence(const QString& sentence);
    QPushButton* addButton(const QString& text, bool primary = false);

private:
    QLabel* m_text;
    QLayout* m_buttons;
};

/// A text that behaves like a link: Enter and click activate it.
class LinkLabel : public QLabel {
    Q_OBJECT
public:
    LinkLabel(const QString& text, QWidget* parent = nullptr);
    void setLinkText(const QString& text);

signals:
    void activated();

protected:
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
};

/// The one filled button of a page.
void makePrimary(QPushButton* button);
/// Object name, accessible name and tool tip in one go.
void describe(QWidget* widget, const char* objectName, const QString& accessibleName, const QString& toolTip = {});

} // namespace camwright
