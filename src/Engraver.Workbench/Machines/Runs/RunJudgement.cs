using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Comparison of a run with the drawing from the data of the controller or the simulator's record; null values are unknown.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing, or from the region in which a corner may be rounded: of the motors if
/// their position error is known, otherwise of the commanded position.</param>
/// <param name="MissingLengthMm">Drawn length that was not cut; also null if the link was lost and the controller continued alone.</param>
/// <param name="Source">"record", "polled" or "none".</param>
public sealed record RunJudgement(double? MaxDeviationMm, double? MissingLengthMm, string Source)
{
    public static RunJudgement Unknown { get; } = new(null, null, "none");

    /// <summary>Largest distance of the commanded path from the drawing, if the deviation of the motors is known too; null if only one is known, which is then
    /// <see cref="MaxDeviationMm"/>.</summary>
    public double? CommandedDeviationMm { get; init; }

    /// <summary>Largest distance of a cutting sample from the drawing where it rounded a corner within the corner tolerance, which is not part of
    /// <see cref="MaxDeviationMm"/>; null if unknown or if corners may not be rounded.</summary>
    public double? CornerDeviationMm { get; init; }

    /// <summary>Largest following error of the servo axes while the tool cut, mm; null if it was not polled, or for steppers.</summary>
    public double? FollowingMm { get; init; }

    /// <summary>Its position on the commanded path, millimetres.</summary>
    public Point2D? FollowingAt { get; init; }

    /// <summary>Position of the largest deviation on the drawing, millimetres; null if unknown.</summary>
    public Point2D? DeviationAt { get; init; }

    /// <summary>The first position of the drawing that was not cut, millimetres; null if nothing is missing or it is unknown.</summary>
    public Point2D? MissingAt { get; init; }

    /// <summary>What was measured of the operations of which something was cut; empty without operations, and for polled positions, which do not show every
    /// stroke.</summary>
    public IReadOnlyList<MeasuredOperation> Operations { get; init; } = [];

    /// <summary>The judgement of several runs that cut one drawing: the largest deviation and the sum of the missing lengths. A figure that is unknown in one
    /// of them is unknown.</summary>
    /// <param name="runs">At least one.</param>
    internal static RunJudgement OfSections(IReadOnlyList<RunJudgement> runs)
    {
        var worst = runs.MaxBy(run => run.MaxDeviationMm ?? double.NegativeInfinity)!;
        var following = runs.MaxBy(run => run.FollowingMm ?? double.NegativeInfinity)!;
        return worst with
        {
            MaxDeviationMm = runs.All(run => run.MaxDeviationMm is not null) ? worst.MaxDeviationMm : null,
            MissingLengthMm = runs.All(run => run.MissingLengthMm is not null) ? runs.Sum(run => run.MissingLengthMm) : null,
            MissingAt = runs.Select(run => run.MissingAt).FirstOrDefault(place => place is not null),
            CornerDeviationMm = runs.Max(run => run.CornerDeviationMm),
            CommandedDeviationMm = runs.All(run => run.CommandedDeviationMm is not null) ? runs.Max(run => run.CommandedDeviationMm) : null,
            FollowingMm = runs.All(run => run.FollowingMm is not null) ? following.FollowingMm : null,
            FollowingAt = following.FollowingAt,
            Operations = [.. runs.SelectMany(run => run.Operations).GroupBy(operation => operation.Id).Select(parts => parts.Aggregate((before, after) => before.With(after)))],
        };
    }
}
