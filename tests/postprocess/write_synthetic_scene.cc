// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the made scene into a folder: input to try the program on by hand.
#include "synthetic_scene.h"

int main(int argc, char** argv) {
  tiprub::synthetic::write_scene(argc > 1 ? argv[1] : "synthetic");
}
