#include "app/window/placehistory.h"

namespace camwright {

namespace {

constexpr std::size_t MostPlaces = 100;

bool isSame(const Place& first, const Place& second)
{
    return first.object == second.object && first.field == second.field && first.range.line == second.range.line;
}

} // namespace

void PlaceHistory::note(const Place& place)
{
    if (!m_places.empty()) {
        if (isSame(m_places[m_at], place))
            return;
        m_places.resize(m_at + 1);
    }
    m_places.push_back(place);
    if (m_places.size() > MostPlaces)
        m_places.erase(m_places.begin());
    m_at = m_places.size() - 1;
}

const Place* PlaceHistory::back()
{
    return m_at > 0 && m_at < m_places.size() ? &m_places[--m_at] : nullptr;
}

const Place* PlaceHistory::forward()
{
    return m_at + 1 < m_places.size() ? &m_places[++m_at] : nullptr;
}

void PlaceHistory::clear()
{
    m_places.clear();
    m_at = 0;
}

} // namespace camwright
