"""Pages link to the files of the repository as they lie there. In the site, a link to what is no part of it becomes its text."""

import posixpath
import re

LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s#]+)(#[^)\s]*)?\)")
FIRST_PAGE = {"README.md": "index.md"}


def on_page_markdown(markdown, page, files, **_):
    folder = posixpath.dirname(page.file.src_path)

    def target(found):
        text, path, anchor = found[1], found[2], found[3] or ""
        if "://" in path:
            return found[0]
        place = posixpath.normpath(posixpath.join(folder, path))
        place = FIRST_PAGE.get(place, place)
        if files.get_file_from_path(place) is None:
            return text
        return f"[{text}]({posixpath.relpath(place, folder or '.')}{anchor})"

    return LINK.sub(target, markdown)
