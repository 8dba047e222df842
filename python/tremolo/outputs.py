"""Folders that commands write into."""

from pathlib import Path


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
