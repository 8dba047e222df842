"""Where a command may write: never over a file that it reads, nor over one that is not its own.

`app/output_place.hpp` does the same for the commands that are programs.
"""

from pathlib import Path

SOFTWARE = "tremolo"  # of the text in pictures that names what drew them
PAGE = ": tremolo report</title>"
HEAD = 4096  # bytes that show whose a file is


def _is_own(path, beginning):
    with open(path, "rb") as stream:
        head = stream.read(HEAD)
    if path.suffix == ".png":
        return head.startswith(b"\x89PNG") and b"tEXtSoftware\0" + SOFTWARE.encode() in head
    if path.suffix == ".html":
        return PAGE.encode() in head
    return bool(beginning) and head.startswith(beginning.encode())


def writable(path, inputs=(), beginning=""):
    """Returns the path of a file that a command may write.

    inputs: files that the command reads
    beginning: of a table, its heading; a picture (.png) and a page (.html) are known by what tremolo puts into them
    Raises ValueError for a folder, for an input, and for a file that exists and was not written by such a command.
    """
    path = Path(path)
    if path.is_dir():
        raise ValueError(f"{path}: is a folder; give the name of a file")
    if not path.exists():
        return path
    if any(Path(other).exists() and path.samefile(other) for other in inputs):
        raise ValueError(f"{path}: is a file that this command reads; give another name")
    if path.is_file() and path.stat().st_size > 0 and not _is_own(path, beginning):
        raise ValueError(f"{path}: exists and is not a file that this command wrote; give another name, or remove it")
    return path


def made_folder(path):
    """Makes a folder with those above it, where they are not there yet. Raises OSError that names what is in its way."""
    path = Path(path)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError) as error:
        obstacle = next(part for part in [*reversed(path.parents), path] if part.exists() and not part.is_dir())
        raise NotADirectoryError(f"cannot make the folder {path}: {obstacle} is no folder") from error
    except OSError as error:
        raise OSError(f"cannot make the folder {path}: {error.strerror}") from error
    return path
