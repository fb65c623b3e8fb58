# The Debian package is built, read, unpacked and run; the archive is unpacked elsewhere and run.
include("${CMAKE_CURRENT_LIST_DIR}/must.cmake")
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}/unpacked" "${SCRATCH}/archive")

must("cpack" "${CMAKE_CPACK_COMMAND}" --config "${BUILD}/CPackConfig.cmake" -B "${SCRATCH}/made"
  -D CPACK_PACKAGE_DIRECTORY=${SCRATCH}/made -D CPACK_COMPONENTS_ALL=program)
file(GLOB package "${SCRATCH}/made/reflectance_${VERSION}_*.deb")
file(GLOB archive "${SCRATCH}/made/reflectance-*.tar.gz")

must("dpkg-deb --info" dpkg-deb --info "${package}")
foreach(line "Package: reflectance\n" "Version: ${VERSION}" "Section: science" "Depends: [^\n]*libc6" "libembree3" "libtbb12"
    "Recommends: [^\n]*osmesa" "Suggests: [^\n]*openmpi" "Maintainer: [^\n]+<" "Description: understand, compare")
  says("the package's control file" "${line}")
endforeach()
if(out MATCHES "Depends: [^\n]*(mpi|libgtest|-dev)")
  message(FATAL_ERROR "the program depends on what only building or testing needs:\n${out}")
endif()

must("dpkg-deb --contents" dpkg-deb --contents "${package}")
foreach(file bin/reflectance share/applications/reflectance.desktop share/icons/hicolor/256x256/apps/reflectance.png
    share/mime/packages/reflectance.xml share/man/man1/reflectance.1.gz share/bash-completion/completions/reflectance
    share/doc/reflectance/copyright share/doc/reflectance/changelog.gz share/doc/reflectance/CHANGELOG.md.gz)
  says("the list of files" "root/root[^\n]* ./usr/${file}\n")
endforeach()
if(out MATCHES "(^|\n)[^\n]*(/home/|/tmp/|/include/|\\.a\n)")
  message(FATAL_ERROR "the program's package holds what is not its own:\n${out}")
endif()

# Unpacked anywhere, both run and draw the same picture.
must("dpkg-deb --extract" dpkg-deb --extract "${package}" "${SCRATCH}/unpacked")
must("tar" tar xzf "${archive}" -C "${SCRATCH}/archive" --strip-components=1)
foreach(program "${SCRATCH}/unpacked/usr/bin/reflectance" "${SCRATCH}/archive/bin/reflectance")
  must("--version" "${program}" --version)
  says("--version" "reflectance ${VERSION}")
  must("render" "${program}" render --size 32x32 --backend cpu --out "${program}.exr")
endforeach()
must("compare" "${SCRATCH}/unpacked/usr/bin/reflectance" compare "${SCRATCH}/unpacked/usr/bin/reflectance.exr"
  "${SCRATCH}/archive/bin/reflectance.exr" --threshold 0)

# Debian's own form of a changelog, dated.
must("gzip" gzip -dc "${SCRATCH}/unpacked/usr/share/doc/reflectance/changelog.gz")
says("the changelog" "^reflectance \\(${VERSION}\\) unstable; urgency=medium\n\n  \\* .*\n -- [^\n]+ <[^\n]+>  [A-Z][a-z][a-z], [0-9][0-9] ")

# The manual page names every verb and troff has nothing to complain of.
must("gzip" gzip -dc "${SCRATCH}/unpacked/usr/share/man/man1/reflectance.1.gz")
foreach(verb render eval models compare sweep "table info")
  says("the manual page" "\\.SS reflectance ${verb}\n")
endforeach()
string(LENGTH "${out}" length)
if(length LESS 10000)
  message(FATAL_ERROR "the manual page has ${length} characters only")
endif()
