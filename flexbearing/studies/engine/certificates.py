"""Certificates by which a scheduler, its workers and this program know each other."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.read import LONGEST_NAME
from flexbearing.printable import excerpt

if TYPE_CHECKING:
    from distributed.security import Security

OPTIONS = "--tls-ca", "--tls-cert", "--tls-key"


@dataclass(frozen=True)
class Certificates:
    """Files in PEM form; whoever has them may have code run by the scheduler and by its workers."""

    authority: Path
    certificate: Path
    key: Path

    def security(self) -> "Security":
        """The same files for every role, as Dask takes them."""
        from distributed.security import Security

        authority, certificate, key = map(str, (self.authority, self.certificate, self.key))
        roles = ("client", "scheduler", "worker")
        files = {f"tls_{role}_cert": certificate for role in roles}
        files |= {f"tls_{role}_key": key for role in roles}
        return Security(require_encryption=True, tls_ca_file=authority, **files)


def of_one_study(folder: Path) -> Certificates:
    """Make certificates that only this user has, as files in a folder that nobody else may enter."""
    from distributed.security import Security

    made = Security.temporary()
    texts = {"ca": made.tls_ca_file, "cert": made.tls_client_cert, "key": made.tls_client_key}
    for name, text in texts.items():
        (folder / f"{name}.pem").write_text(text)
    return Certificates(*(folder / f"{name}.pem" for name in texts))


def certificates(*files: Path | None) -> Certificates | None:
    """Look at the files of `OPTIONS`.

    Raises `BadCase` where one or two are named, or they are no certificates and key that belong together.
    """
    named = [file.resolve() for file in files if file is not None]
    if not named:
        return None
    if len(named) != len(OPTIONS):
        raise BadCase(f"{', '.join(OPTIONS)}: all three are needed for TLS, {len(named)} given")
    for option, file in zip(OPTIONS, named, strict=True):
        try:
            inputs.stamp(file)
        except inputs.Unreadable as problem:
            raise BadCase(f"{option} {excerpt(str(file), LONGEST_NAME)}: {problem}") from problem
    found = Certificates(*named)
    _require_usable(found)
    return found


def _require_usable(found: Certificates) -> None:
    """Load the files as a connection does; without a prompt for a passphrase."""
    from ssl import create_default_context

    try:
        context = create_default_context(cafile=found.authority)
        context.load_cert_chain(found.certificate, found.key, password="")
    except (OSError, ValueError) as problem:
        raise BadCase(
            f"{', '.join(OPTIONS)}: no certificates and key in PEM form, without a passphrase, that belong "
            f"together: {problem}"
        ) from problem
