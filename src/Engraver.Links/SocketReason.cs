using System.Net.Sockets;
using Engraver.Core.Languages;

namespace Engraver.Links;

/// <summary>Why the network refused, in this program's own words: part of a sentence that names the address, without a full stop.</summary>
public static class SocketReason
{
    /// <param name="failure">Failure of a socket; the reason for any other is that of <see cref="SystemErrorText"/>.</param>
    public static string Of(Exception failure) => failure is SocketException { SocketErrorCode: var error } && Key(error) is { } key ? Wording.Get(key) : SystemErrorText.FromException(failure);

    /// <summary>Name of the text; null for an error that has none.</summary>
    private static string? Key(SocketError error) => error switch
    {
        SocketError.ConnectionRefused => "SocketReason.ConnectionRefused",
        SocketError.HostNotFound or SocketError.NoData or SocketError.TryAgain => "SocketReason.NoHost",
        SocketError.TimedOut => "SocketReason.NoAnswer",
        SocketError.NetworkUnreachable or SocketError.HostUnreachable or SocketError.NetworkDown or SocketError.HostDown => "SocketReason.Unreachable",
        SocketError.ConnectionReset or SocketError.ConnectionAborted or SocketError.Shutdown => "SocketReason.ConnectionClosed",
        SocketError.AddressAlreadyInUse => "SocketReason.PortInUse",
        SocketError.AccessDenied => "SocketReason.AccessDenied",
        _ => null,
    };
}
