# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# The site of the manual, and every command line that it shows. Part of ./dev, which has set $root.

docs() {
  [ $# -eq 0 ] || usage
  local begin
  begin=$(date +%s)
  take_turn
  # shellcheck disable=SC2086
  need $docs_packages
  python_of tools/docs build/docs-venv
  host_build "every verb" verbs
  mkdir -p build/docs build/site
  rm -rf build/docs/doxygen
  mkdir build/docs/doxygen
  doxygen tools/docs/Doxyfile >&2
  build/docs-venv/bin/python -B tools/docs/stage.py . build/docs/doxygen/xml build/docs/pages
  build/docs-venv/bin/python -B tools/docs/gallery.py . build/host/fantail build/docs/pages build/docs/work
  echo "docs: the site" >&2
  NO_MKDOCS_2_WARNING=1 build/docs-venv/bin/mkdocs --quiet build --strict -f tools/docs/mkdocs.yml >&2
  # For servers, and with links that lead nowhere from the disk.
  rm -f build/site/404.html build/site/sitemap.xml build/site/sitemap.xml.gz
  /usr/bin/python3 -B tools/docs/check_site.py build/site
  echo "docs: the command lines of the manual" >&2
  /usr/bin/python3 -B test/system/every_line.py . build/host/fantail
  leave_turn
  echo "build/site/index.html: $(find build/site -name '*.html' | wc -l) pages, $(du -sm build/site | cut -f1) MB, made in $(($(date +%s) - begin)) s;" \
    "open it in a browser, from the disk or from anywhere"
}
