// What gmsh runs, if it is given this file.
SystemCall "touch command_ran";
