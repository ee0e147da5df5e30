using System.Text.Json.Serialization;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver run --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record RunJson
{
    public required string Outcome { get; init; }

    public required int SegmentsSent { get; init; }

    public required int SegmentsExecuted { get; init; }

    public required double Seconds { get; init; }

    public required double? PlannedSeconds { get; init; }

    public required int Underruns { get; init; }

    public required int Rejected { get; init; }

    public required long? FinalX { get; init; }

    public required long? FinalY { get; init; }

    public required ScaleJson CountsPerMillimetre { get; init; }

    public required double? MaxDeviation { get; init; }

    /// <summary>Largest distance from the drawing where corners were rounded within the corner tolerance, mm; not part of <see cref="MaxDeviation"/>. Null when
    /// unknown or without a corner tolerance.</summary>
    public double? CornerDeviation { get; init; }

    public required double? MissingLength { get; init; }

    /// <summary>How much slower than planned the machine ran along its path; null where it cannot be compared.</summary>
    public LagJson? Lag { get; init; }

    public required string DeviationSource { get; init; }

    public required string? Journal { get; init; }

    public required LeftOutJson? LeftOut { get; init; }

    /// <summary>Visible entities on the cut layers that produce no cut, by DXF type; null when the job was not prepared.</summary>
    public required IReadOnlyDictionary<string, int>? NotCut { get; init; }

    public required OriginJson? Origin { get; init; }

    /// <summary>Counts of the Z axis; null on a machine without one.</summary>
    public required long? FinalZ { get; init; }

    /// <summary>Number of feed holds by the operator.</summary>
    public required int Holds { get; init; }

    public required ResumedJson? ResumedFrom { get; init; }

    /// <summary>The start checks; null when the machine was not queried.</summary>
    public required IReadOnlyList<StartCheckJson>? Checks { get; init; }

    /// <summary>Those of X, Y and Z that steppers move: their polled positions are the commanded ones.</summary>
    public IReadOnlyList<string> OpenLoop { get; init; } = [];

    /// <summary>Largest following error of the servo axes while the tool cut, mm; null when unknown.</summary>
    public double? MaxFollowingError { get; init; }

    /// <summary>Maximum allowed distance from the drawing, mm; null for a run that did not start.</summary>
    public double? Tolerance { get; init; }

    /// <summary>The fonts of the texts that are cut; empty if none is.</summary>
    public IReadOnlyList<CutFont> Fonts { get; init; } = [];

    /// <summary>The executed trajectories; null for a job of the drawing itself.</summary>
    public FollowedJson? Trajectory { get; init; }

    /// <summary>The values of the texts of the plate that was run; null without any. Of a series the last one.</summary>
    public PlateReportJson? Plate { get; init; }

    /// <summary>The plates of a series that were run; null for a run that is not a series.</summary>
    public IReadOnlyList<PlateReportJson>? Plates { get; init; }

    /// <summary>The operations; not written for a job without operations.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<OperationJson>? Operations { get; init; }

    /// <summary>The sections of this run, between which the tool was changed; not written for a job of one tool.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<SectionJson>? Sections { get; init; }

    /// <summary>Where a resumed run continued.</summary>
    /// <param name="Segments">Completed segments of the whole program.</param>
    /// <param name="Along">Millimetres of the next segment that were already cut.</param>
    internal sealed record ResumedJson(int Segments, double Along);

    /// <param name="VerifiedBound">Proven upper bound of the distance between the commanded path and the source of the trajectories, mm.</param>
    internal sealed record FollowedJson(int Count, int Points, double VerifiedBound)
    {
        public static FollowedJson? From(TrajectoryJob? job) => job is null ? null : new(job.Trajectories.Count, job.Trajectories.Sum(one => one.Curve.Points), job.Bound);
    }

    internal sealed record ScaleJson(double X, double Y);

    /// <param name="Seconds">Lost on the path, without the time at rest.</param>
    /// <param name="Places">Where most was lost, at most five.</param>
    internal sealed record LagJson(double Seconds, IReadOnlyList<LagPlaceJson> Places)
    {
        public static LagJson? From(RunLag? lag) => lag is null ? null : new(lag.Seconds, [.. lag.Places.Select(place => new LagPlaceJson(place.Place.X, place.Place.Y, place.Entity, place.Seconds, place.PlannedSpeed, place.Speed, place.PlannedAcceleration, place.Acceleration))]);
    }

    /// <summary>A part of the path on which time was lost: millimetres, seconds, mm/s and mm/s2.</summary>
    /// <param name="X">Where it begins.</param>
    /// <param name="Entity">Drawing entity there.</param>
    internal sealed record LagPlaceJson(double X, double Y, int Entity, double Seconds, double PlannedSpeed, double Speed, double PlannedAcceleration, double Acceleration);

    /// <summary>Position of the drawing's zero, millimetres from the controller's zero.</summary>
    /// <param name="Source">work, here or given.</param>
    internal sealed record OriginJson(double X, double Y, string Source);

    /// <param name="Count">Entities of the drawing that could not be converted to curves.</param>
    /// <param name="Length">Their length, mm; null when unknown.</param>
    internal sealed record LeftOutJson(int Count, double? Length);
}
