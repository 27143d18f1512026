// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the sectors of a model, and the speeds of a response.
#include <iostream>

#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"

int main(int, char** argv) {
  std::cout << tiprub::read_model(argv[1]).sector_count << ' ' << tiprub::read_response(argv[2]).speeds.size()
            << '\n';
}
