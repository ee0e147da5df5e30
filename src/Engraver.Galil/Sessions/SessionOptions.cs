using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>How a session talks.</summary>
public sealed record SessionOptions
{
    /// <summary>How long a reply may take before the link counts as lost.</summary>
    public TimeSpan ReplyTimeout { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>Open a second handle for the operator's stop and for unsolicited text. A serial line is a single wire and never has one: the stop then goes at the next prompt.</summary>
    public bool SecondHandle { get; init; } = true;

    /// <summary>Where every line on the wire is written, or null for nowhere.</summary>
    public WireTrace? Trace { get; init; }

    /// <summary>Called with each line that a program in the controller prints. It runs on the reader: it must return at once.</summary>
    public Action<string>? MessageReceived { get; init; }
}
