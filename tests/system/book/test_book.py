"""The documentation builds as a site in which every link has its target, every picture is there, and nothing is fetched.

    usage: test_book.py SOURCE_DIR
"""

import html.parser
import json
import shutil
import subprocess
import sys
import unittest
import urllib.parse
from pathlib import Path

SOURCE = Path(sys.argv.pop(1))
SITE = SOURCE / "build/book/site"


class Page(html.parser.HTMLParser):
    """Targets of a page's links and pictures, what it loads, and the places in it that a link can name."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.places = [], [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.places.update(given[name] for name in ("id", "name") if given.get(name))
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag in ("img", "script") and "src" in given:
            self.loaded.append(given["src"])
        if tag == "link" and "stylesheet" in given.get("rel", ""):
            self.loaded.append(given["href"])


def setUpModule():
    if not shutil.which("mkdocs"):
        raise unittest.SkipTest("no mkdocs (scripts/setup.sh installs it)")
    built = subprocess.run([SOURCE / "scripts/book.sh"], capture_output=True, text=True, timeout=250)
    assert built.returncode == 0, built.stdout + built.stderr
    global pages
    pages = {path: Page(path) for path in SITE.rglob("*.html")}


class Book(unittest.TestCase):
    def test_every_link_has_its_target(self):
        broken = []
        for path, page in pages.items():
            if path.name == "404.html":
                continue
            for link in page.links:
                parts = urllib.parse.urlsplit(link)
                if parts.scheme:
                    continue
                target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
                if target.is_dir():
                    target /= "index.html"
                if not target.exists() or target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].places:
                    broken.append(f"{path.relative_to(SITE)}: {link}")
        self.assertEqual([], broken)

    def test_pictures_are_there_and_nothing_is_fetched(self):
        missing = [
            f"{path.relative_to(SITE)}: {what}"
            for path, page in pages.items() if path.name != "404.html" for what in page.loaded
            if urllib.parse.urlsplit(what).scheme or not (path.parent / urllib.parse.unquote(what)).exists()
        ]
        self.assertEqual([], missing)

    def test_every_page_of_the_documentation_is_in_the_site_and_in_its_search(self):
        index = json.loads((SITE / "search/search_index.json").read_text(encoding="utf-8"))
        found = {entry["location"].split("#")[0] for entry in index["docs"]}
        expected = {str(path.relative_to(SOURCE).with_suffix(".html")) for path in (SOURCE / "docs").rglob("*.md")}
        self.assertEqual(set(), {page.replace("README.html", "index.html") for page in expected} - found)


if __name__ == "__main__":
    unittest.main()
