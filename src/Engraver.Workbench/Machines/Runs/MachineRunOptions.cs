using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Options of a run.</summary>
public sealed record MachineRunOptions(ControllerAddress Address, ExecutionStrategy Strategy)
{
    /// <summary>Path of the journal.</summary>
    public required string JournalPath { get; init; }

    /// <summary>Path of the wire trace; null for none.</summary>
    public string? TracePath { get; init; }

    /// <summary>True: executes every motion with the tool off.</summary>
    public bool DryRun { get; init; }

    /// <summary>Position of the drawing's zero.</summary>
    public OriginRequest Origin { get; init; } = new OriginRequest.ActiveOrigin();

    /// <summary>The work origins that this job and those that follow request by name.</summary>
    public IEnumerable<string> NamedOrigins => [.. Origin is OriginRequest.NamedOrigin { Name: var own } ? new[] { own } : [], .. Following?.Elsewhere.Select(one => one.Origin) ?? []];

    /// <summary>Target of the machine after the last stroke.</summary>
    public FinishPlace Finish { get; init; }

    /// <summary>The jobs that follow: this one does not start if they would leave the travel or have no place. Null for none.</summary>
    public FollowingJobs? Following { get; init; }

    /// <summary>The lease of the machine; null: it is acquired from <see cref="Memories"/> for the run.</summary>
    public MachineLease? Lease { get; init; }

    /// <summary>Storage of the origins of machines.</summary>
    public MachineMemories Memories { get; init; } = new(null);

    /// <summary>Name of this process for the messages of other hosts.</summary>
    public string LeaseOwner { get; init; } = "";

    /// <summary>Where to resume an interrupted job; null for a job from the start.</summary>
    public ResumeRequest? Resume { get; init; }

    /// <summary>Feed hold, resume and overrides by the operator; null for none.</summary>
    public JobControl? Control { get; init; }

    /// <summary>Receives the position of the drawing's zero, counts of the controller, before any motion; null for none.</summary>
    public Action<CountsPoint>? FrameFound { get; init; }

    /// <summary>Checks before the start: receives the current status and the placement, and returns why the job must not start, or null. Null if the checks
    /// were already run (ARM).</summary>
    public Func<MachineStatus, JobPlacement, string?>? CheckStart { get; init; }

    /// <summary>Called when everything has been checked, right before the job takes the machine; returns why it must not, or null. Null for none.</summary>
    public Func<CancellationToken, Task<Diagnostic?>>? Starting { get; init; }

    /// <summary>Receives findings before the first motion, on the thread of the job.</summary>
    public Action<Diagnostic>? FindingReported { get; init; }
}
