using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Arming;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver run --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Holds">How often the operator held the job.</param>
/// <param name="Checks">The list before the start; null when the machine was not asked.</param>
/// <param name="FinalZ">Counts of the Z axis; null on a machine without one.</param>
/// <param name="NotCut">What is seen on the layers that are cut and gives no cut, by DXF type; null when the job was not prepared.</param>
internal sealed record RunJson(
    string Outcome,
    int SegmentsSent,
    int SegmentsExecuted,
    double Seconds,
    double? PlannedSeconds,
    int Underruns,
    int Rejected,
    long? FinalX,
    long? FinalY,
    RunJson.ScaleJson CountsPerMillimetre,
    double? MaxDeviation,
    double? MissingLength,
    string DeviationSource,
    string? Journal,
    RunJson.LeftOutJson? LeftOut,
    IReadOnlyDictionary<string, int>? NotCut,
    RunJson.OriginJson? Origin,
    long? FinalZ,
    int Holds,
    RunJson.ResumedJson? ResumedFrom,
    IReadOnlyList<StartCheckJson>? Checks)
{
    /// <summary>X, Y and Z as far as steppers move them: what is polled of those is what was commanded.</summary>
    public IReadOnlyList<string> OpenLoop { get; init; } = [];

    /// <summary>Largest following error of the servo axes while the tool cut, mm; null where nobody knows it.</summary>
    public double? MaxFollowingError { get; init; }

    /// <summary>The distance from the drawing up to which the run counts as right, mm; null for a run that did not begin.</summary>
    public double? Tolerance { get; init; }

    /// <summary>The trajectories that were run; null for a job of the drawing itself.</summary>
    public FollowedJson? Trajectory { get; init; }

    /// <summary>Where the run went on that was begun before.</summary>
    /// <param name="Segments">Segments of the whole program that were cut whole.</param>
    /// <param name="Along">Millimetres along the next one that were cut too.</param>
    internal sealed record ResumedJson(int Segments, double Along);

    /// <param name="VerifiedBound">Largest distance of the path that was asked for from what the trajectories follow, mm, proven.</param>
    internal sealed record FollowedJson(int Count, int Points, double VerifiedBound)
    {
        public static FollowedJson? From(TrajectoryJob? job) => job is null ? null : new(job.Trajectories.Count, job.Trajectories.Sum(one => one.Curve.Points), job.Bound);
    }

    internal sealed record ScaleJson(double X, double Y);

    /// <summary>Where the drawing's zero lay, millimetres by the controller's own zero.</summary>
    /// <param name="Source">work, here or given.</param>
    internal sealed record OriginJson(double X, double Y, string Source);

    /// <param name="Count">Entities of the drawing that gave no curve though they should have.</param>
    /// <param name="Length">Their length, mm; null where it is unknown.</param>
    internal sealed record LeftOutJson(int Count, double? Length);
}

/// <summary>One line of the list before the start.</summary>
/// <param name="Ok">False: the job does not start.</param>
/// <param name="Warning">It does not prevent the start, but the operator must have read it.</param>
/// <param name="Sentence">What was looked at, and when it is not so, what to do.</param>
internal sealed record StartCheckJson(bool Ok, bool Warning, string Sentence)
{
    /// <summary>Null for a list that nobody went through.</summary>
    public static IReadOnlyList<StartCheckJson>? Of(ArmingChecklist? list) => list is null ? null : [.. list.Checks.Select(check => new StartCheckJson(check.Passed, check.IsWarning, check.Sentence))];
}
