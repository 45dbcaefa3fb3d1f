"""The page's library as a native one: a question per line in; a line with the hash of the bytes of its answer out."""

import ctypes
import hashlib
import sys


def main(path: str) -> None:
    library = ctypes.CDLL(path)
    library.stribeck_alloc.argtypes = [ctypes.c_size_t]
    library.stribeck_alloc.restype = ctypes.c_void_p
    library.stribeck_ask.restype = ctypes.c_size_t
    library.stribeck_answer.restype = ctypes.c_void_p
    for line in sys.stdin.buffer:
        question = line.rstrip(b"\n")
        ctypes.memmove(library.stribeck_alloc(len(question)), question, len(question))
        length = library.stribeck_ask()
        answer = ctypes.string_at(library.stribeck_answer(), length)
        print(hashlib.sha256(answer).hexdigest())


main(sys.argv[1])
