#include <cstdio>

#include "shprt/base/version.h"

int main() { std::printf("shprt %s\n", shprt::kVersion); }
