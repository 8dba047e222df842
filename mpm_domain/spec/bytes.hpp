#pragma once

// Memory of particles and nodes, from the tables of fields.

#include "mpm_domain/fields/node_fields.hpp"     // IWYU pragma: export
#include "mpm_domain/fields/particle_fields.hpp" // IWYU pragma: export
