// The header alone, as the strictest C++17 compiler sees it.
#include "stribeck.h"

// Included twice on purpose: it must guard itself.
#include "stribeck.h"

int main() {
    return 0;
}
