# SPDX-License-Identifier: MIT
"""Usage: seal_image.py OBJCOPY LINKED.elf SEALED.elf

Writes the CRC-32C of an image into its last word, the section .image_crc, where the firmware looks for it at boot.
"""

import pathlib
import subprocess
import sys
import tempfile


def crc32c(data: bytes) -> int:
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0x82F63B78 if byte & 1 else 0)
        table.append(byte)
    crc = 0xFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ table[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF


def main() -> None:
    objcopy, linked, sealed = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder, "image.bin")
        subprocess.run([objcopy, "-O", "binary", linked, image], check=True)
        word = pathlib.Path(folder, "crc.bin")
        word.write_bytes(crc32c(image.read_bytes()[:-4]).to_bytes(4, "little"))
        subprocess.run([objcopy, "--update-section", f".image_crc={word}", linked, sealed], check=True)


main()
