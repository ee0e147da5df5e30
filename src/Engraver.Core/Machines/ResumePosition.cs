namespace Engraver.Core.Machines;

/// <summary>Where an interrupted job is to continue, according to its journal and to what the controller itself has kept of it.</summary>
/// <param name="Place">Everything before it was certainly cut.</param>
/// <param name="Doubt">Counts before the place that may not have been cut: they are cut again in addition to any lead-in.</param>
/// <param name="Frame">Controller counts at the drawing's zero, as the interrupted job had them.</param>
/// <param name="IsSameZero">The controller has kept the number that the job stored in it: it was not switched off since.</param>
public sealed record ResumePosition(JobPosition Place, double Doubt, CountsPoint Frame, bool IsSameZero)
{
    /// <summary>The strategy with which the job was started; null where no journal states it.</summary>
    public ExecutionStrategy? Strategy { get; init; }

    /// <summary>Where an output is the tool of a machine with a Z axis: the height at which the job was cut, the controller's own counts; null
    /// elsewhere.</summary>
    public int? HeightOfCut { get; init; }

    /// <summary>The job ended for a change of the tool, which has another length.</summary>
    public bool IsToolChange { get; init; }

    /// <summary>As in <see cref="JobOptions.Settings"/>; null where no journal states them.</summary>
    public IReadOnlyDictionary<string, string>? Settings { get; init; }

    /// <summary>It cannot be resumed because the path is not that of the journal's job.</summary>
    public bool IsPathChanged { get; init; }

    /// <summary>The journal is of an older version, without checksums: a change to it cannot be detected.</summary>
    public bool IsUnsealed { get; init; }

    /// <summary>Why the job cannot be resumed, and what to do; null when it can.</summary>
    public string? Refusal { get; init; }

    /// <summary>A job that cannot be resumed.</summary>
    public static ResumePosition Refused(string why) => new(default, 0.0, default, false) { Refusal = why };
}
