"""What the linker must know of macOS: text-based libraries, which list the functions that each one has. Zig brings that
of the system library; nothing of the others is called, and none is named in a program in the end."""

import re
from importlib.util import find_spec
from pathlib import Path

# The first version that runs on Apple's processors.
OLDEST = "11.0"
# Names that crates and Rust's standard library give to the linker. The first three are one library.
SYSTEM = ("usr/lib/libSystem", "usr/lib/libc", "usr/lib/libm")
UNUSED = {"usr/lib/libc++": "/usr/lib/libc++.1.dylib", "usr/lib/libiconv": "/usr/lib/libiconv.2.dylib"}
FLAGS = [
    "-Clinker=rust-lld",
    "-Clinker-flavor=ld64.lld",
    # No data for debuggers, which name object files; no library of which nothing is called.
    "-Clink-arg=-S",
    "-Clink-arg=-dead_strip_dylibs",
]
# A list of systems and processors, such as [ x86_64-macos, arm64e-macos ].
TARGETS = re.compile(r"\[ ([^\]]*-mac[^\]]*) \]")
EMPTY = """--- !tapi-tbd
tbd-version: 4
targets: [ x86_64-macos, arm64-macos ]
install-name: '{name}'
...
"""


def of_programs(found: re.Match[str]) -> str:
    """A list of targets as the linker knows them. Zig names Apple's processors as Apple's own programs do."""
    names = {name.strip().replace("arm64e-", "arm64-") for name in found[1].split(",")}
    return f"[ {', '.join(name for name in ('x86_64-macos', 'arm64-macos') if name in names)} ]"


def sdk(folder: Path) -> dict[str, str]:
    """Writes the libraries below a folder. Returns the environment in which the linker finds them."""
    zig = Path(find_spec("ziglang").submodule_search_locations[0])
    system = (zig / "lib" / "libc" / "darwin" / "libSystem.tbd").read_text(encoding="utf-8")
    texts = dict.fromkeys(SYSTEM, TARGETS.sub(of_programs, system))
    texts |= {path: EMPTY.format(name=name) for path, name in UNUSED.items()}
    for path, text in texts.items():
        file = folder / f"{path}.tbd"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return {"SDKROOT": str(folder), "MACOSX_DEPLOYMENT_TARGET": OLDEST}
