#pragma once

#include "core/base/place.h"

#include <vector>

namespace camwright {

/// The places a user was at, for back and forward. The oldest of more than a hundred are forgotten.
class PlaceHistory {
public:
    /// The user is here now. What lay ahead is forgotten, unless it is the place he stands on already.
    void note(const Place& place);
    /// One step back or forward; null where there is none.
    const Place* back();
    const Place* forward();
    void clear();

private:
    std::vector<Place> m_places;
    std::size_t m_at = 0;
};

} // namespace camwright
