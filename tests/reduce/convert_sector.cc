// SPDX-License-Identifier: GPL-3.0-or-later
// A sector as gmsh saves it in another format, as `gmsh SECTOR.msh -save -format msh22 -o OTHER.msh` does.
//
// usage: convert_sector SECTOR.msh VERSION text|binary OTHER.msh
#include <gmsh.h>

#include <string>

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(argv[1]);
  gmsh::option::setNumber("Mesh.MshFileVersion", std::stod(argv[2]));
  gmsh::option::setNumber("Mesh.Binary", std::string(argv[3]) == "binary" ? 1 : 0);
  gmsh::write(argv[4]);
  gmsh::finalize();
  return 0;
}
