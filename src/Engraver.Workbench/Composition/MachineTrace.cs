using Engraver.Links.Recording;

namespace Engraver.Workbench.Composition;

/// <summary>The trace of a link: every line on the wire.</summary>
public sealed class MachineTrace
{
    internal MachineTrace(WireTrace wire) => Wire = wire;

    internal WireTrace Wire { get; }

    /// <summary>Why it ended early; null if complete.</summary>
    public string? Failure => Wire.Failure;

    /// <summary>Flushes and closes the file.</summary>
    public Task CloseAsync(CancellationToken cancellation) => Wire.CloseAsync(cancellation);
}
