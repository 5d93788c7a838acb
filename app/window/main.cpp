#include "app/window/application.h"

int main(int argc, char** argv)
{
    return camwright::runWindow(argc, argv);
}
