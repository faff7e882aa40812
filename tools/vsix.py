"""Pack the folder of the extension for VS Code as a .vsix, without a network.

    python tools/vsix.py editors/vscode cncsub.vsix

A .vsix is a ZIP of the folder `extension` with two files beside it: the manifest of the package and
the types of its files. What `npm install --omit=dev` put into `node_modules` is packed too; without
it the extension says that its server is missing.
"""

from __future__ import annotations

import json
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape, quoteattr

EPOCH = (1980, 1, 1, 0, 0, 0)  # the time of every file: the same folder gives the same bytes
ASSETS = {
    "Code.Manifest": "package.json",
    "Services.Content.Details": "README.md",
    "Services.Content.License": "LICENSE.txt",
}
LEFT_OUT = {"package-lock.json", ".package-lock.json"}
TYPES = {
    ".json": "application/json",
    ".js": "application/javascript",
    ".md": "text/markdown",
    ".txt": "text/plain",
}


def files_of(folder: Path) -> Iterator[Path]:
    """Yield the files of the extension, in order; of links and hidden files none."""
    for file in sorted(folder.rglob("*")):
        hidden = any(part.startswith(".") for part in file.relative_to(folder).parts)
        if file.is_file() and not (file.is_symlink() or hidden or file.name in LEFT_OUT):
            yield file


def manifest(package: dict[str, Any]) -> str:
    """Return the manifest of a package, from its package.json."""
    identity = " ".join(
        f"{key}={quoteattr(value)}"
        for key, value in {
            "Language": "en-US",
            "Id": package["name"],
            "Version": package["version"],
            "Publisher": package["publisher"],
        }.items()
    )
    engine = quoteattr(package["engines"]["vscode"])
    assets = "".join(
        f'    <Asset Type="Microsoft.VisualStudio.{kind}" Path="extension/{path}"'
        ' Addressable="true"/>\n'
        for kind, path in ASSETS.items()
    )
    return f"""<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity {identity}/>
    <DisplayName>{escape(package["displayName"])}</DisplayName>
    <Description xml:space="preserve">{escape(package["description"])}</Description>
    <Tags>{escape(",".join(package["keywords"]))}</Tags>
    <Categories>{escape(",".join(package["categories"]))}</Categories>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value={engine}/>
    </Properties>
    <License>extension/LICENSE.txt</License>
  </Metadata>
  <Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation>
  <Dependencies/>
  <Assets>
{assets}  </Assets>
</PackageManifest>
"""


def content_types(names: list[str]) -> str:
    """Return the types of the files, by their endings."""
    endings = sorted({Path(name).suffix for name in names} - {""} | {".vsixmanifest"})
    types = {ending: TYPES.get(ending, "application/octet-stream") for ending in endings}
    rows = "".join(
        f"<Default Extension={quoteattr(ending)} ContentType={quoteattr(kind)}/>"
        for ending, kind in types.items()
    )
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        f'<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">{rows}</Types>\n'
    )


def pack(folder: Path, output: Path) -> list[str]:
    """Write the package, and return the names of its files."""
    package = json.loads((folder / "package.json").read_text("utf-8"))
    contents: dict[str, bytes] = {}
    for file in files_of(folder):
        name = file.relative_to(folder).as_posix()
        contents[f"extension/{'LICENSE.txt' if name == 'LICENSE' else name}"] = file.read_bytes()
    names = list(contents)
    contents = {
        "extension.vsixmanifest": manifest(package).encode(),
        "[Content_Types].xml": content_types(names).encode(),
        **contents,
    }
    with zipfile.ZipFile(output, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, data in contents.items():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(entry, data)
    return list(contents)


def main(words: list[str]) -> int:
    if len(words) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder, output = map(Path, words)
    names = pack(folder, output)
    print(f"{output}: {len(names)} files")
    if not any(name.startswith("extension/node_modules/vscode-languageclient/") for name in names):
        print(
            "without vscode-languageclient: npm install --omit=dev in the folder adds it",
            file=sys.stderr,
        )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
