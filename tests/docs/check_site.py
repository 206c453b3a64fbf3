#!/usr/bin/env python3
"""check_site.py SITE: on the pages that mkdocs built, every link leads somewhere, every page can be reached from the first, and
nothing is loaded from the network."""
import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.file, self.anchors, self.links, self.loaded = file, set(), [], []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        self.anchors.update(of[key] for key in ("id", "name") if of.get(key))
        if tag == "a" and of.get("href"):
            self.links.append(of["href"])
        if tag == "link" and "canonical" not in of.get("rel", "") and of.get("href"):
            self.loaded.append(of["href"])
        if tag in ("script", "img", "source", "iframe", "audio", "video", "embed", "object"):
            self.loaded += [of[key] for key in ("src", "data", "srcset") if of.get(key)]


def is_elsewhere(address):
    return bool(urllib.parse.urlparse(address).scheme) or address.startswith("//")


def target_of(page, address, site):
    path = urllib.parse.unquote(urllib.parse.urlparse(address).path)
    if not path:
        return page.file
    file = (site / path.lstrip("/") if path.startswith("/") else page.file.parent / path).resolve()
    return file / "index.html" if file.is_dir() else file


def problems_of(page, pages, site):
    for address in page.links + page.loaded:
        if is_elsewhere(address):
            if address in page.loaded:
                yield f"loads {address}"
            continue
        if address.startswith("/") or page.file.name == "404.html":
            continue  # of a server's root
        target = target_of(page, address, site)
        anchor = urllib.parse.unquote(urllib.parse.urlparse(address).fragment)
        if not target.exists():
            yield f"names {address}, which is not there"
        elif anchor and target in pages and anchor not in pages[target].anchors:
            yield f"names {address}, but there is no such place on that page"


def reachable_from(first, pages, site):
    found, waiting = {first}, [first]
    while waiting:
        page = pages[waiting.pop()]
        for address in page.links:
            target = target_of(page, address, site)
            if not is_elsewhere(address) and target in pages and target not in found:
                found.add(target)
                waiting.append(target)
    return found


site = pathlib.Path(sys.argv[1]).resolve()
pages = {file: Page(file) for file in site.rglob("*.html")}
problems = [f"{page.file.name} {problem}" for page in pages.values() for problem in problems_of(page, pages, site)]
for sheet in site.rglob("*.css"):
    problems += [f"{sheet.name} loads {address}" for address in re.findall(r"(?:url\(|@import)\s*['\"]?((?:https?:)?//[^'\")\s]+)", sheet.read_text())]
alone = set(pages) - reachable_from(site / "index.html", pages, site) - {site / "404.html", site / "search.html"}
problems += [f"no page leads to {page.name}" for page in alone]
assert len(pages) > 20, f"{len(pages)} pages only"
if problems:
    sys.exit("\n".join(problems))
print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links")
