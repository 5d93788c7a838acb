#include "app/window/panelstack.h"

#include "app/window/badgetabbar.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace camwright {

PanelStack::PanelStack(Context& context, const std::vector<PanelFactory>& panels, const QString& accessibleName, QWidget* parent)
    : QWidget(parent), m_context(context)
{
    for (const PanelFactory& factory : panels)
        m_entries.push_back({factory, nullptr});
    std::sort(m_entries.begin(), m_entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.factory.order, a.factory.id) < std::tie(b.factory.order, b.factory.id);
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* strip = new QFrame(this);
    strip->setProperty("surface", "plain");
    strip->setFixedHeight(30);
    m_row = new QHBoxLayout(strip);
    m_row->setContentsMargins(0, 0, 8, 0);
    m_row->setSpacing(6);
    m_bar = new BadgeTabBar(strip);
    m_bar->setAccessibleName(accessibleName);
    m_row->addWidget(m_bar);
    m_row->addStretch(1);
    column->addWidget(strip);
    auto* line = new QFrame(this);
    line->setProperty("surface", "fine");
    line->setFixedHeight(1);
    column->addWidget(line);
    m_pages = new QStackedWidget(this);
    column->addWidget(m_pages, 1);
    for (const Entry& entry : m_entries)
        m_bar->addTab(entry.factory.name);
    connect(m_bar, &QTabBar::currentChanged, this, &PanelStack::becameCurrent);
    if (!m_entries.empty())
        becameCurrent();
}

bool PanelStack::has(const QString& id) const
{
    return std::any_of(m_entries.begin(), m_entries.end(), [&](const Entry& entry) { return entry.factory.id == id; });
}

void PanelStack::showPanel(const QString& id)
{
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        if (m_entries[i].factory.id == id)
            m_bar->setCurrentIndex(int(i) + extraTabs());
    }
}

QString PanelStack::currentId() const
{
    const int index = m_bar->currentIndex() - extraTabs();
    return index < 0 || index >= int(m_entries.size()) ? QString() : m_entries[std::size_t(index)].factory.id;
}

Panel* PanelStack::current() const
{
    const int index = m_bar->currentIndex() - extraTabs();
    return index < 0 || index >= int(m_entries.size()) ? nullptr : m_entries[std::size_t(index)].panel;
}

Panel* PanelStack::panel(const QString& id)
{
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        Entry& entry = m_entries[i];
        if (entry.factory.id != id)
            continue;
        if (!entry.panel) {
            entry.panel = entry.factory.create(m_context);
            m_pages->addWidget(entry.panel);
            connect(entry.panel, &Panel::badgeChanged, this, [this, i] { refreshBadge(int(i)); });
            connect(entry.panel, &Panel::abilitiesChanged, this, &PanelStack::abilitiesChanged);
            refreshBadge(int(i));
        }
        return entry.panel;
    }
    return nullptr;
}

void PanelStack::refreshBadge(int entry)
{
    const Panel* panel = m_entries[std::size_t(entry)].panel;
    m_bar->setTabData(entry + extraTabs(), panel ? panel->badge() : 0);
    m_bar->setTabText(entry + extraTabs(), m_entries[std::size_t(entry)].factory.name); // lays the tabs out anew
}

void PanelStack::setExtraPage(QWidget* page, const QString& name)
{
    if (page == m_extra)
        return;
    const QString current = currentId();
    const QSignalBlocker blocker(m_bar);
    if (m_extra) {
        m_pages->removeWidget(m_extra);
        m_extra->hide();
        m_bar->removeTab(0);
    }
    m_extra = page;
    if (page) {
        m_bar->insertTab(0, name);
        m_pages->addWidget(page);
        connect(page, &QObject::destroyed, this, [this, page] {
            if (m_extra == page) {
                m_extra = nullptr;
                m_bar->removeTab(0);
            }
        });
    }
    if (!current.isEmpty())
        showPanel(current);
    else
        m_bar->setCurrentIndex(0);
    becameCurrent();
}

void PanelStack::becameCurrent()
{
    if (m_rowWidget) {
        // Back to its panel, else it would stand in the strip as soon as the panel shows its children.
        m_row->removeWidget(m_rowWidget);
        m_rowWidget->setParent(m_rowOwner);
        m_rowWidget->hide();
        m_rowWidget = nullptr;
    }
    if (m_extra && m_bar->currentIndex() == 0) {
        m_pages->setCurrentWidget(m_extra);
        m_extra->show();
    } else if (Panel* shown = panel(currentId())) {
        m_pages->setCurrentWidget(shown);
        m_rowWidget = shown->tabRowWidget();
        m_rowOwner = shown;
        if (m_rowWidget) {
            m_row->addWidget(m_rowWidget);
            m_rowWidget->show();
        }
    }
    emit currentChanged();
}

} // namespace camwright
