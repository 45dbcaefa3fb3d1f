"""What is in the files of a release."""

import io
import tarfile
import zipfile
from collections.abc import Iterator

ARCHIVES = (".zip", ".fmu", ".ssp", ".whl")
COMPRESSED = (".tar.gz", ".crate")


def within(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    """A file, or all files in it if it is an archive, also those in archives in it."""
    if name.endswith(ARCHIVES):
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            for entry in archive.namelist():
                yield from within(entry, archive.read(entry))
    elif name.endswith(COMPRESSED):
        with tarfile.open(fileobj=io.BytesIO(content)) as archive:
            for entry in archive:
                if entry.isfile():
                    yield from within(entry.name, archive.extractfile(entry).read())
    else:
        yield name, content
