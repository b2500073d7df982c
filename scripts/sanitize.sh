#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the library with its unit and property tests and the cases of fuzzing under the address and undefined-behavior
# sanitizers and runs them, then those of threads under the thread sanitizer: scripts/sanitize.sh [--quick]. About 40
# minutes on two cores; with --quick without tests that match whole bodies or solids for 20 s and more each and run little
# that the tests of the stages do not. The presets leave out the program and the tests on measuring data: they take too long.
set -euo pipefail
cd "$(dirname "$0")/.."

slow_tests=(
  'Figure/SpectralLift.TakesAllVerticesToWhereTheyBelong/\(0, 2\)'
  'Figure/SpectralLift.TakesAllVerticesToWhereTheyBelong/\(2, 0\)'
  Match.CanBeStopped
  Match.LandmarksSkipExact
  Match.MeshesOfVeryDifferentSizeAreNotComparedInDetail
  Match.MinSharedDecidesWhatIsNearlyTheSame
  Match.UnrelatedMeshesAreSpectral
  Match.WhatConnectivityFindsLeadsTheRestAndStays
  MatchPartial.MovedRenumberedAndOfUnknownScale
  MatchPartial.UnlikeShapesAndWrongScalesAreDoubted
  MatchPartial.WhatFitsALittleIsUnsure
  MatchSpectral.AReflectedMeshIsSaidAndMatched
  MatchSpectral.CanBeStoppedInEveryStage
  MatchSpectral.InsideOutIsSaidAndMatchedWithMonotoneProgress
  MatchSpectral.OneLandmarkTurnsASymmetricMapAndHoldsExactly
  MatchSpectral.OneOpenMeshIsWarnedOf
  MatchSpectral.UnlikeShapesOfVeryDifferentSizeGetLittleConfidenceAndASentenceBothWays
  MatchVolume.OtherTetrahedraOfOneBentSolid
  SpectralRematching.ExchangingTheShapesExchangesTheMaps
  SpectralRematchingOfLimbs.LandmarksAndDirectionsGuideAsWell
  SpectralSearch.OfNearIsometriesThatAreNotDecidedTheCloseOnesAreRivals
  SpectralSearch.OfUnlikeShapesAsManyAsAskedForHaveBeenTriedAndOneIsRefinedOnceMore
  SpectralSearch.OfUnlikeShapesTheWinnerIsRematchedAndComesAfterWhatIsBetter
  SpectralSearch.OfUnlikeShapesWhatFitsBadlyIsSoughtFromBToAAsWell
  SpectralUnlikeShapes.WhatIsFoundWithoutLandmarksWinsOnlyWhereItFitsAndAgreesWithThem
)
case "${1:-}" in
  "") excluded=() ;;
  --quick) excluded=(--exclude-regex "^($(IFS='|' && echo "${slow_tests[*]//./\\.}"))") ;;
  *) echo "usage: scripts/sanitize.sh [--quick]" >&2; exit 2 ;;
esac

for preset in asan tsan; do
  # clang: quicker here than g++, and it warns of other things.
  cmake --preset "$preset" -DCMAKE_CXX_COMPILER=clang++ > /dev/null
  TIMEFORMAT="== build for $preset: %R s, %U s of CPU"
  time cmake --build --preset "$preset"
  TIMEFORMAT="== tests under $preset: %R s, %U s of CPU"
  time ctest --preset "$preset" -j "$(nproc)" "${excluded[@]}"
done
