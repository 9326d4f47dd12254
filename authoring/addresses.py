"""Who calls: the address of the other side, or the one a trusted proxy tells of."""

from functools import lru_cache
from ipaddress import IPv4Address, IPv4Network, IPv6Address, IPv6Network, ip_address

from django.conf import settings
from django.http import HttpRequest

#: What a proxy adds, by the names of WSGI.
PROXY_MARKS = (
    "HTTP_FORWARDED",
    "HTTP_VIA",
    "HTTP_X_FORWARDED_FOR",
    "HTTP_X_FORWARDED_HOST",
    "HTTP_X_FORWARDED_PROTO",
    "HTTP_X_REAL_IP",
)
MOST_HOPS = 20
_IPV6_SITE = 64


def caller(request: HttpRequest) -> str:
    """Return the address of the caller; of IPv6 its network of 64 bits, "" where it has none.

    X-Forwarded-For is read from its end, as far as CAIR_TRUSTED_PROXIES wrote it.
    """
    peer = request.META.get("REMOTE_ADDR", "")
    trusted = tuple(settings.CAIR_TRUSTED_PROXIES)
    if not trusted or not _trusted(peer, trusted):
        return _site(peer)
    hops = request.META.get("HTTP_X_FORWARDED_FOR", "").split(",")[-MOST_HOPS:]
    for hop in map(str.strip, reversed(hops)):
        if _address(hop) is None:
            break
        peer = hop
        if not _trusted(hop, trusted):
            break
    return _site(peer)


def is_own_machine(request: HttpRequest) -> bool:
    """Say whether a call comes from this machine itself, through no proxy that says it is one."""
    address = _address(request.META.get("REMOTE_ADDR", ""))
    marked = any(mark in request.META for mark in PROXY_MARKS)
    return address is not None and address.is_loopback and not marked


@lru_cache(1024)
def _address(text: str) -> IPv4Address | IPv6Address | None:
    try:
        address = ip_address(text)
    except ValueError:
        return None
    mapped = address.ipv4_mapped if isinstance(address, IPv6Address) else None
    return mapped or address


@lru_cache(1024)
def _trusted(text: str, networks: tuple[IPv4Network | IPv6Network, ...]) -> bool:
    address = _address(text)
    return address is not None and any(address in network for network in networks)


@lru_cache(1024)
def _site(text: str) -> str:
    """Return an address as it is counted: who has one of IPv6 has 2**64."""
    address = _address(text)
    if isinstance(address, IPv6Address):
        return str(IPv6Network((address, _IPV6_SITE), strict=False))
    return str(address) if address else ""
