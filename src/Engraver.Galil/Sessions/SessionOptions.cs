using Engraver.Core.Motion;

namespace Engraver.Galil.Sessions;

/// <summary>Settings of a session.</summary>
public sealed record SessionOptions
{
    /// <summary>Time without a reply after which the link counts as lost.</summary>
    public TimeSpan ReplyTimeout { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>Opens a second handle for the operator's stop and for unsolicited text. Not possible on a serial line: the stop is then sent after the bytes
    /// that are being sent.</summary>
    public bool SecondHandle { get; init; } = true;

    /// <summary>Receives every line on the wire; null for none.</summary>
    public IWireTrace? Trace { get; init; }

    /// <summary>Called with each line printed by a program in the controller, on the reading thread: it must return at once.</summary>
    public Action<string>? MessageReceived { get; init; }
}
