#pragma once

namespace camwright {

/// camwright [PROJECT] [--demo DIR] [--screenshot DIR] [--theme light|dark] [--lang en|zh|ru]
int runWindow(int argc, char** argv);

} // namespace camwright
