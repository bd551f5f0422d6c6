// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/densities.h"

#include <algorithm>
#include <array>

#include "core/energy/density_kinds.h"

namespace foldless {
namespace {

template <class Kind>
double value(const Mat2& J) {
  return Kind::value(matrix2(J));
}
template <class Kind>
DensityDerivatives derivatives(const Mat2& J) {
  return Kind::derivatives(matrix2(J));
}

constexpr std::array kDensities{
    Density{"dirichlet", "Dirichlet", "EDD*95", 0.01, false, DensityKind::dirichlet,
            value<Dirichlet>, derivatives<Dirichlet>},
    Density{"lscm", "LSCM (conformal)", "LPRM02", 0.01, false, DensityKind::lscm, value<Lscm>,
            derivatives<Lscm>},
    Density{"arap", "As rigid as possible", "LZX*08", 0.01, false, DensityKind::arap, value<Arap>,
            derivatives<Arap>},
    Density{"green-strain", "Green's strain", "HG00", 100, true, DensityKind::green_strain,
            value<GreenStrain>, derivatives<GreenStrain>},
    Density{"symmetric-dirichlet", "Symmetric Dirichlet", "SS15", 0.01, false,
            DensityKind::symmetric_dirichlet, value<SymmetricDirichlet>,
            derivatives<SymmetricDirichlet>},
};

}  // namespace

std::span<const Density> densities() { return kDensities; }

const Density* find_density(std::string_view name) {
  const auto row = std::ranges::find(kDensities, name, &Density::name);
  return row == kDensities.end() ? nullptr : &*row;
}

}  // namespace foldless
