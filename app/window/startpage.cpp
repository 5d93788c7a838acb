#include "app/window/startpage.h"

#include "app/window/docviewer.h"
#include "app/window/drawing.h"
#include "app/window/familycard.h"
#include "app/window/recentlist.h"
#include "editors/shell/icons.h"
#include "editors/shell/widgets.h"
#include "editors/words/shipped.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace camwright {

namespace {

QLabel* heading(const QString& text, QWidget* parent)
{
    auto* out = new QLabel(text, parent);
    QFont font = theme().boldFont();
    font.setPixelSize(14);
    out->setFont(font);
    out->setFixedHeight(20);
    return out;
}

QLabel* dim(const QString& text, QWidget* parent, const char* tone = "dim")
{
    auto* out = new QLabel(text, parent);
    out->setProperty("tone", tone);
    out->setWordWrap(true);
    return out;
}

/// A number in a ring: the three steps to a moving axis.
class StepRing : public QWidget {
public:
    StepRing(int number, QWidget* parent) : QWidget(parent), m_number(number) { setFixedSize(19, 19); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(theme().color(Role::Line));
        painter.drawEllipse(QRectF(0.5, 0.5, 18, 18));
        QFont font = theme().boldFont();
        font.setPixelSize(11);
        painter.setFont(font);
        painter.setPen(theme().color(Role::Dim));
        painter.drawText(rect(), Qt::AlignCenter, QString::number(m_number));
    }

private:
    int m_number;
};

struct Lesson {
    const char* file;
    const char* icon;
    QString title;
    QString sentence;
};

} // namespace

StartPage::StartPage(Settings& settings, QWidget* parent) : QScrollArea(parent), m_settings(settings)
{
    setObjectName(QStringLiteral("startPage"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    auto* page = new QWidget;
    auto* across = new QHBoxLayout(page);
    across->setContentsMargins(24, 32, 24, 24);
    across->setSpacing(48);
    across->addStretch();
    auto* main = new QWidget(page);
    main->setFixedWidth(904);
    auto* column = new QVBoxLayout(main);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(hero());
    column->addSpacing(24);
    column->addWidget(heading(tr("New project"), main));
    column->addSpacing(8);
    column->addWidget(familyCards());
    column->addSpacing(24);
    column->addWidget(recentHeader());
    column->addSpacing(8);
    auto* card = new QFrame(main);
    card->setProperty("surface", "card");
    card->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto* inside = new QVBoxLayout(card);
    inside->setContentsMargins(1, 1, 1, 1);
    m_recent = new RecentList(card);
    inside->addWidget(m_recent);
    m_recentCard = card;
    m_recentEmpty = dim(tr("Projects you open are listed here with the state they were left in."), main);
    column->addWidget(m_recentCard);
    column->addWidget(m_recentEmpty);
    column->addStretch();
    across->addWidget(main);
    across->addWidget(learnColumn(), 0, Qt::AlignTop);
    across->addStretch();
    setWidget(page);
    connect(m_recent, &RecentList::chosen, this, &StartPage::openRequested);
    connect(m_recent, &RecentList::forgetRequested, this, [this](const QString& path) {
        m_settings.forget(path);
        refresh();
    });
    refresh();
}

void StartPage::refresh()
{
    const QList<RecentProject> projects = m_settings.recentProjects();
    m_recent->fill(projects);
    m_recentCard->setVisible(!projects.isEmpty());
    m_recentEmpty->setVisible(projects.isEmpty());
}

QWidget* StartPage::hero()
{
    auto* card = new QFrame(this);
    card->setProperty("surface", "card");
    card->setFixedSize(904, 230);
    card->setObjectName(QStringLiteral("hero"));
    auto* row = new QHBoxLayout(card);
    row->setContentsMargins(1, 1, 1, 1);
    row->setSpacing(0);
    auto* left = new QWidget(card);
    auto* text = new QVBoxLayout(left);
    text->setContentsMargins(28, 32, 24, 0);
    text->setSpacing(0);
    auto* title = new QLabel(tr("Open the demo machine"), left);
    QFont font = theme().boldFont();
    font.setPixelSize(20);
    title->setFont(font);
    text->addWidget(title);
    text->addSpacing(8);
    text->addWidget(dim(tr("Two simulated drives on a Kinco KS101M: Feed pushes the strip, Turn indexes it. Nothing real moves."), left));
    text->addSpacing(14);
    auto* steps = new QHBoxLayout;
    steps->setSpacing(8);
    const QStringList words{tr("Open"), tr("Run"), tr("Hold jog: the axis moves")};
    for (int i = 0; i < words.size(); ++i) {
        if (i > 0)
            steps->addWidget(dim(QStringLiteral("→"), left));
        steps->addWidget(new StepRing(i + 1, left));
        steps->addWidget(new QLabel(words[i], left));
    }
    steps->addStretch();
    text->addLayout(steps);
    text->addSpacing(20);
    auto* go = new QHBoxLayout;
    go->setSpacing(12);
    auto* button = new QPushButton(icon(QStringLiteral("run"), Role::OnAccent), QLatin1Char(' ') + tr("Open the demo machine"), left);
    describe(button, "openDemo", tr("Open the demo machine"), tr("Opens a machine with two simulated axes and connects to its virtual controller."));
    makePrimary(button);
    button->setStyleSheet(QStringLiteral("QPushButton { min-height: 34px; max-height: 34px; padding: 0 16px; }"));
    go->addWidget(button);
    go->addWidget(dim(tr("Enter"), left, "caption"));
    go->addStretch();
    text->addLayout(go);
    text->addStretch();
    row->addWidget(left, 1);
    auto* picture = new QFrame(card);
    picture->setObjectName(QStringLiteral("heroPicture"));
    const auto colour = [picture] {
        picture->setStyleSheet(QStringLiteral("#heroPicture { background: %1; border: none; border-left: 1px solid %2; "
                                              "border-top-right-radius: 6px; border-bottom-right-radius: 6px; }")
                                   .arg(theme().name(Role::Raised), theme().name(Role::FineLine)));
    };
    colour();
    connect(&theme(), &Theme::changed, picture, colour);
    auto* inside = new QHBoxLayout(picture);
    inside->setContentsMargins(1, 0, 0, 0);
    inside->addWidget(new DemoDrawing(picture));
    row->addWidget(picture);
    connect(button, &QPushButton::clicked, this, &StartPage::demoRequested);
    return card;
}

QWidget* StartPage::familyCards()
{
    auto* out = new QWidget(this);
    auto* row = new QHBoxLayout(out);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    const auto card = [&](const char* drawing, const QString& name, const QString& sentence, const QString& buses, const char* busIcon = "network") {
        auto* made = new FamilyCard(QString::fromLatin1(drawing), name, sentence, buses, QString::fromLatin1(busIcon), out);
        made->setObjectName(QString::fromLatin1(drawing));
        row->addWidget(made);
        return made;
    };
    connect(card("family-kinco", QStringLiteral("Kinco KS"), tr("Compact controller with up to 32 CANopen axes."), QStringLiteral("CANopen")),
        &QAbstractButton::clicked, this, [this] { emit newRequested(QStringLiteral("kinco")); });
    connect(card("family-invt", QStringLiteral("INVT TS600"), tr("Logic of the TS600 in instruction list, with its timers and counters."), tr("Virtual terminals"), "terminals"),
        &QAbstractButton::clicked, this, [this] { emit newRequested(QStringLiteral("invt")); });
    connect(card("family-koyo", QStringLiteral("Koyo D2-MLINK"), tr("Logic of the DL205 in instruction list; I-boxes are checked only."), tr("Virtual terminals"), "terminals"),
        &QAbstractButton::clicked, this, [this] { emit newRequested(QStringLiteral("koyo")); });
    card("family-soft", tr("Soft controller"), tr("Camwright's own controller on this or another PC."), {})->setMissing(tr("Not in this version."));
    row->addStretch();
    return out;
}

QWidget* StartPage::recentHeader()
{
    auto* out = new QWidget(this);
    auto* row = new QHBoxLayout(out);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addWidget(heading(tr("Recent projects"), out));
    row->addStretch();
    auto* open = new LinkLabel(tr("Open a folder"), out);
    describe(open, "openFolder", tr("Open a folder"), tr("Opens a project folder (Ctrl+O)."));
    row->addWidget(open);
    row->addWidget(dim(QStringLiteral("Ctrl+O"), out, "caption"));
    connect(open, &LinkLabel::activated, this, [this] { emit openRequested({}); });
    return out;
}

QWidget* StartPage::learnColumn()
{
    auto* out = new QFrame(this);
    out->setObjectName(QStringLiteral("learn"));
    out->setFixedWidth(248);
    const auto colour = [out] { out->setStyleSheet(QStringLiteral("#learn { border: none; border-left: 1px solid %1; }").arg(theme().name(Role::Line))); };
    colour();
    connect(&theme(), &Theme::changed, out, colour);
    auto* column = new QVBoxLayout(out);
    column->setContentsMargins(24, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(heading(tr("Learn"), out));
    const Lesson lessons[] = {
        {"learn/first-axis.md", "jog", tr("Move an axis for the first time"), tr("Enable, home and jog a simulated drive. 5 minutes")},
        {"learn/first-program.md", "program", tr("Write and run a program"), tr("Instructions, variables, watch and force. 10 minutes")},
        {"learn/canopen-axis.md", "network", tr("Add a CANopen drive"), tr("An axis of the motion network and its fields. 10 minutes")},
        {"learn/going-online.md", "plug", tr("Go online"), tr("Addresses, the download plan, who has control. 8 minutes")},
    };
    bool first = true;
    for (const Lesson& lesson : lessons) {
        const QString path = sharedPath(QStringLiteral("docs/") + QLatin1String(lesson.file));
        if (path.isEmpty())
            continue;
        if (!first) {
            auto* line = new QFrame(out);
            line->setProperty("surface", "line");
            line->setFixedHeight(1);
            column->addWidget(line);
        }
        first = false;
        auto* row = new QHBoxLayout;
        row->setContentsMargins(0, 12, 0, 12);
        row->setSpacing(12);
        auto* sign = new QLabel(out);
        const auto draw = [this, sign, name = QString::fromLatin1(lesson.icon)] { sign->setPixmap(iconPixmap(name, 16, Role::Dim, devicePixelRatioF())); };
        draw();
        connect(&theme(), &Theme::changed, sign, draw);
        auto* texts = new QVBoxLayout;
        texts->setSpacing(2);
        auto* link = new LinkLabel(lesson.title, out);
        link->setToolTip(lesson.sentence);
        link->setWordWrap(true);
        texts->addWidget(link);
        texts->addWidget(dim(lesson.sentence, out, "caption"));
        row->addWidget(sign, 0, Qt::AlignTop);
        row->addLayout(texts, 1);
        column->addLayout(row);
        connect(link, &LinkLabel::activated, this, [this, path] { emit pageRequested(path); });
    }
    column->addStretch();
    out->setVisible(!first);
    return out;
}

void StartPage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        emit demoRequested();
    else
        QScrollArea::keyPressEvent(event);
}

} // namespace camwright
