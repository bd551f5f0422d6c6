// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/arap.h"
#include "core/energy/dirichlet.h"
#include "core/energy/green_strain.h"
#include "core/energy/lscm.h"
#include "core/energy/symmetric_dirichlet.h"

namespace foldless {

/// visit(Kind()) with the formula of that name.
template <class Visit>
decltype(auto) with_density(DensityKind kind, const Visit& visit) {
  switch (kind) {
    case DensityKind::dirichlet: return visit(Dirichlet());
    case DensityKind::lscm: return visit(Lscm());
    case DensityKind::arap: return visit(Arap());
    case DensityKind::green_strain: return visit(GreenStrain());
    case DensityKind::symmetric_dirichlet: break;
  }
  return visit(SymmetricDirichlet());
}

}  // namespace foldless
