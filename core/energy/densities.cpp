// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/densities.h"

#include <algorithm>
#include <array>

#include "core/energy/arap.h"
#include "core/energy/dirichlet.h"
#include "core/energy/green_strain.h"
#include "core/energy/lscm.h"
#include "core/energy/symmetric_dirichlet.h"

namespace foldless {
namespace {

constexpr std::array kDensities{
    Density{"dirichlet", "Dirichlet", "EDD*95", 0.01, false, dirichlet_value,
            dirichlet_derivatives},
    Density{"lscm", "LSCM (conformal)", "LPRM02", 0.01, false, lscm_value, lscm_derivatives},
    Density{"arap", "As rigid as possible", "LZX*08", 0.01, false, arap_value, arap_derivatives},
    Density{"green-strain", "Green's strain", "HG00", 100, true, green_strain_value,
            green_strain_derivatives},
    Density{"symmetric-dirichlet", "Symmetric Dirichlet", "SS15", 0.01, false,
            symmetric_dirichlet_value, symmetric_dirichlet_derivatives},
};

}  // namespace

std::span<const Density> densities() { return kDensities; }

const Density* find_density(std::string_view name) {
  const auto row = std::ranges::find(kDensities, name, &Density::name);
  return row == kDensities.end() ? nullptr : &*row;
}

}  // namespace foldless
