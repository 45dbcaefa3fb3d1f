"""The library for macOS, as far as Linux can examine it: its parts, its signature, and its code, made to run here.

Facts about the format: Apple's headers `mach-o/loader.h`, `mach-o/fixup-chains.h` and `kern/cs_blobs.h`."""

import ctypes
import hashlib
import struct
from pathlib import Path

from lief import MachO

# A page of memory is not larger on any machine that runs the code.
PAGE = 16384
SIGNATURE, CODE_DIRECTORY = 0xFADE0CC0, 0xFADE0C02
SHA256 = 2

# Functions that have another name on Linux, or that `macos.c` provides.
OTHER_NAMES = {
    "__bzero": "bzero",
    "__error": "__errno_location",
    "_tlv_atexit": "macos_at_exit_of_thread",
    "_tlv_bootstrap": "macos_variable_of_thread",
    "memset_pattern16": "macos_memset_pattern16",
    "pthread_threadid_np": "macos_number_of_thread",
}
C_LIBRARY = ctypes.CDLL("libc.so.6")


def processors(library: Path) -> dict[str, MachO.Binary]:
    """The parts of a universal file by the name of their processor."""
    types = {"Intel": MachO.Header.CPU_TYPE.X86_64, "Apple": MachO.Header.CPU_TYPE.ARM64}
    file = MachO.parse(str(library))
    assert file.size == len(types)
    # A part that is not taken out is lost with the file.
    return {name: file.take(processor) for name, processor in types.items()}


def part_of(library: Path, part: MachO.Binary) -> bytes:
    """The bytes of a part of a universal file."""
    file = library.read_bytes()
    return file[part.fat_offset : part.fat_offset + part.original_size]


def pages_that_differ(code: bytes, signature: bytes) -> tuple[int, int]:
    """Number of code pages whose hash differs from their signature, and number of all pages."""
    magic, _, count = struct.unpack_from(">3I", signature)
    assert magic == SIGNATURE
    offsets = [struct.unpack_from(">2I", signature, 12 + 8 * number)[1] for number in range(count)]
    directory = next(at for at in offsets if struct.unpack_from(">I", signature, at)[0] == CODE_DIRECTORY)
    _, _, _, _, hashes, _, _, pages, limit = struct.unpack_from(">9I", signature, directory)
    size, kind, _, exponent = struct.unpack_from(">4B", signature, directory + 36)
    assert (size, kind) == (32, SHA256)
    first = directory + hashes
    assert pages == -(-limit // 2**exponent)
    different = 0
    for number in range(pages):
        page = code[number << exponent : min(number + 1 << exponent, limit)]
        wanted = signature[first + 32 * number : first + 32 * (number + 1)]
        different += hashlib.sha256(page).digest() != wanted
    return different, pages


def function(symbol: str) -> str:
    """The replacement for a macOS function on Linux."""
    name = symbol.removeprefix("_")
    if name in OTHER_NAMES:
        return OTHER_NAMES[name]
    return name if name.startswith("_Unwind_") or hasattr(C_LIBRARY, name) else "macos_absent"


def image_of(part: MachO.Binary) -> bytes:
    """The part as it is in memory, from address 0."""
    ends = [segment.virtual_address + segment.virtual_size for segment in part.segments]
    image = bytearray(max(ends))
    for segment in part.segments:
        at = segment.virtual_address
        image[at : at + len(segment.content)] = segment.content
    return bytes(image)


def pointers(part: MachO.Binary, image: bytes) -> dict[int, str]:
    """The values written by the loader: addresses, each with an assembler expression."""
    found = {}
    for relocation in part.relocations:
        (target,) = struct.unpack_from("<Q", image, relocation.address)
        found[relocation.address] = f"image + {target:#x}"
    for binding in part.bindings:
        found[binding.address] = f"{function(binding.symbol.name)} + {binding.addend}"
    return found


def thread_template(part: MachO.Binary) -> int:
    """Address of the initial values of thread-local variables."""
    kinds = (MachO.Section.TYPE.THREAD_LOCAL_REGULAR, MachO.Section.TYPE.THREAD_LOCAL_ZEROFILL)
    return min(section.virtual_address for section in part.sections if section.type in kinds)


def write_assembly(part: MachO.Binary, folder: Path) -> Path:
    """The part as a source for the assembler of Linux: the same bytes, at the same distances from each other, and
    functions of Linux or of `macos.c` in place of those of macOS."""
    image = image_of(part)
    bytes_of_image = folder / "image.bin"
    bytes_of_image.write_bytes(image)
    lines = ['.section .image, "awx"', f".balign {PAGE}", "image:"]
    at = 0
    for address, value in sorted(pointers(part, image).items()):
        if address > at:
            lines.append(f'.incbin "{bytes_of_image}", {at}, {address - at}')
        lines.append(f".quad {value}")
        at = address + 8
    lines.append(f'.incbin "{bytes_of_image}", {at}')
    lines += [".globl macos_thread_template", ".hidden macos_thread_template"]
    lines += [f".set macos_thread_template, image + {thread_template(part):#x}"]
    for symbol in part.exported_symbols:
        name = symbol.name.removeprefix("_")
        lines += [f".globl {name}", f".type {name}, %function", f".set {name}, image + {symbol.value:#x}"]
    lines.append('.section .note.GNU-stack, "", %progbits')
    source = folder / "image.s"
    source.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return source
