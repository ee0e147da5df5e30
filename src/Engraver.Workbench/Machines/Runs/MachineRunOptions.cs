using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>How a prepared job is run.</summary>
public sealed record MachineRunOptions(ControllerAddress Address, ExecutionStrategy Strategy)
{
    /// <summary>Path of the journal.</summary>
    public required string JournalPath { get; init; }

    /// <summary>Where every line on the wire is written; null for nowhere.</summary>
    public string? TracePath { get; init; }

    /// <summary>True: every motion, with the tool off.</summary>
    public bool DryRun { get; init; }

    /// <summary>Where the drawing's zero lies.</summary>
    public OriginRequest Origin { get; init; } = new OriginRequest.Work();

    /// <summary>Where the machine goes after the last stroke.</summary>
    public FinishPlace Finish { get; init; }

    /// <summary>The machine in this host's hands; null: it is taken from <see cref="Memories"/> for the time of the run.</summary>
    public MachineHold? Hold { get; init; }

    /// <summary>Where the origins of machines are kept.</summary>
    public MachineMemories Memories { get; init; } = new(null);

    /// <summary>Name of this process for another host that wants the machine meanwhile.</summary>
    public string Holder { get; init; } = "";

    /// <summary>Where the job goes on that was begun before; null for one that begins at its beginning.</summary>
    public ResumeRequest? Resume { get; init; }

    /// <summary>Hold, resume and overrides by the operator; null for a job that nobody holds.</summary>
    public JobControl? Control { get; init; }

    /// <summary>Told where the drawing's zero lies, counts of the controller, before anything moves; null for nobody.</summary>
    public Action<CountsPoint>? Placed { get; init; }

    /// <summary>Asked before the start with what the machine says just then and where the job would go: why it must not start, or null. Null where a list
    /// was gone through before (ARM).</summary>
    public Func<MachineStatus, JobPlacement, string?>? MayStart { get; init; }

    /// <summary>Told what is found out before the first motion; on the thread of the job.</summary>
    public Action<Diagnostic>? Told { get; init; }
}
