using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>How a prepared job is run.</summary>
public sealed record MachineRunOptions(ControllerAddress Address, JobMode Mode)
{
    /// <summary>Where the journal goes.</summary>
    public required string JournalPath { get; init; }

    /// <summary>Where every line on the wire is written; null for nowhere.</summary>
    public string? TracePath { get; init; }

    /// <summary>Every motion, but the tool stays off.</summary>
    public bool DryRun { get; init; }

    /// <summary>Where the starts of earlier runs are kept; null where nobody remembers.</summary>
    public StartMemory? Starts { get; init; }

    /// <summary>Told what is found out before the first motion; on the thread of the job.</summary>
    public Action<Diagnostic>? Told { get; init; }
}
