#!/usr/bin/env bash
# Makes the volumes that the scenes of this folder show, beside them: make_volumes.sh ISOCAST [FOLDER]
set -euo pipefail
isocast=$(realpath "${1:?usage: make_volumes.sh ISOCAST [FOLDER]}")
cd "${2:-$(dirname "$0")}"
"$isocast" sample "x^2+y^2+z^2+0.25*sin(7*x)*sin(7*y)*sin(7*z)" --domain -1.2,1.2 --resolution 64 --type f32 -o bumps.nrrd
"$isocast" sample "exp(-4*((x-0.4)^2+y^2+z^2))+exp(-4*((x+0.4)^2+y^2+z^2))" --domain -1.2,1.2 --resolution 48 --type f32 -o two_atoms.nrrd
"$isocast" sample "sin(3*x)*cos(3*y)+sin(3*y)*cos(3*z)+sin(3*z)*cos(3*x)" --domain -1.2,1.2 --resolution 64 --type u8 -o gyroid.nrrd
