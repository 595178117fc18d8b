# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# The site of the manual, and every command line that it shows. Part of ./dev, which has set $root.

# docs: public headers, site and command lines. All are checked, also when one has failed.
docs() {
  [ $# -eq 0 ] || usage
  local begin
  begin=$(date +%s)
  take_turn
  # shellcheck disable=SC2086
  need $docs_packages
  python_of tools/docs build/docs-venv
  python_tools # for the lines that export a log
  use_test_python
  host_build "every verb" verbs
  begin_checks docs
  checked "every value, range and error of the public headers of core and hal has its comment, and Doxygen no warning" docs_headers
  checked "the gallery is made, MkDocs has no warning, and every link leads somewhere" docs_site
  checked "every command line in a block of the manual runs, or has its place and reason" /usr/bin/python3 -B test/system/every_line.py . build/host/fantail
  leave_turn
  end_checks "The manual" "./dev docs"
  echo "build/site/index.html: $(find build/site -name '*.html' | wc -l) pages, $(du -sm build/site | cut -f1) MB, made in $(($(date +%s) - begin)) s;" \
    "open it in a browser, from the disk or from anywhere"
}

docs_headers() {
  rm -rf build/docs/doxygen build/docs/pages
  mkdir -p build/docs/doxygen &&
    doxygen tools/docs/Doxyfile >&2 &&
    build/docs-venv/bin/python -B tools/docs/stage.py . build/docs/doxygen/xml build/docs/pages
}

docs_site() {
  rm -rf build/site
  build/docs-venv/bin/python -B tools/docs/gallery.py . build/host/fantail build/docs/pages build/docs/work &&
    NO_MKDOCS_2_WARNING=1 build/docs-venv/bin/mkdocs --quiet build --strict -f tools/docs/mkdocs.yml >&2 &&
    # For servers, and with links that lead nowhere from the disk.
    rm -f build/site/404.html build/site/sitemap.xml build/site/sitemap.xml.gz &&
    /usr/bin/python3 -B tools/docs/check_site.py build/site
}
