using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines.Moves;

/// <summary>The travel of the axes of a machine: the only place that decides whether a move leaves the travel, for jogs, moves to a point, jobs and their
/// frames.</summary>
/// <remarks>The travel is given in machine millimetres, from the controller's own zero, so it is valid only while that zero is where the profile assumes it
/// (<see cref="Origins.StoredMachineState"/>).</remarks>
public static class TravelLimits
{
    /// <summary>The axes that have a travel, with its ends in counts.</summary>
    public static IReadOnlyList<SoftLimit> Of(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return [.. profile.Axes.All.Where(axis => axis.Travel is not null).Select(axis => Of(axis)!.Value)];
    }

    /// <summary>The ends of one axis' travel in counts, rounded inwards; null where the axis has none.</summary>
    public static SoftLimit? Of(MachineAxis axis)
    {
        if (axis.Travel is not { } travel) return null;
        var (one, other) = (axis.Scale.Exact(travel.Min), axis.Scale.Exact(travel.Max));
        return new SoftLimit(axis.Letter, Clamp(Math.Ceiling(Math.Min(one, other))), Clamp(Math.Floor(Math.Max(one, other))));
    }

    /// <summary>Why a motion is not allowed: a point that it reaches is outside the travel. Null when the whole motion is inside.</summary>
    /// <param name="least">The smallest counts that it reaches, from the controller's own zero, in the order of <see cref="MachineAxes.All"/>; axes that are
    /// missing do not move.</param>
    /// <param name="most">The largest counts, in the same order.</param>
    public static Diagnostic? Refusal(MachineProfile profile, IReadOnlyList<long> least, IReadOnlyList<long> most)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(least);
        ArgumentNullException.ThrowIfNull(most);
        var axes = profile.Axes.All;
        for (var i = 0; i < Math.Min(axes.Count, least.Count); i++)
        {
            if (Of(axes[i]) is not { } limit || (least[i] >= limit.Min && most[i] <= limit.Max)) continue;
            var outside = least[i] < limit.Min ? least[i] : most[i];
            var travel = axes[i].Travel!;
            return PreparationRules.OutsideTravel.At(default, profile.Axes.NameOf(axes[i].Letter).ToString(), NumberText.Rounded(axes[i].Scale.ToMillimetres(outside), 3), NumberText.Rounded(travel.Min, 3), NumberText.Rounded(travel.Max, 3));
        }

        return null;
    }

    /// <summary>The same check for one point.</summary>
    /// <param name="withHeight">The height is part of the point; otherwise it does not change.</param>
    public static Diagnostic? Refusal(MachineProfile profile, CountsPoint place, bool withHeight = false)
    {
        long[] counts = withHeight ? [place.X, place.Y, place.Z] : [place.X, place.Y];
        return Refusal(profile, counts, counts);
    }

    /// <summary>Why a step is not allowed where the machine position at its start is unknown: it is longer than the whole travel of an axis. Null when it is
    /// allowed.</summary>
    /// <param name="step">Counts of the controller.</param>
    public static Diagnostic? StepRefusal(MachineProfile profile, CountsPoint step, bool withHeight)
    {
        ArgumentNullException.ThrowIfNull(profile);
        var axes = profile.Axes.All;
        for (var i = 0; i < (withHeight ? axes.Count : 2); i++)
        {
            var length = Math.Abs(axes[i].Scale.ToMillimetres(step[i]));
            if (axes[i].Travel is { } travel && length > travel.Max - travel.Min) return PreparationRules.StepBeyondTravel.At(default, NumberText.Rounded(length, 3), profile.Axes.NameOf(axes[i].Letter).ToString(), NumberText.Rounded(travel.Max - travel.Min, 3));
        }

        return null;
    }

    /// <summary>The same check for a job whose drawing zero is at these counts: its path in plan, and where an axis is the tool drive the heights from its
    /// deepest cut to its clearance.</summary>
    /// <param name="profile">The machine with its travel; the axes of the program's own profile are in the same order.</param>
    /// <param name="dryRun">The tool stays out of the work: all motion is raised (<see cref="DryRunLift"/>).</param>
    /// <param name="following">What the jobs after it reach, which must be inside too; null for none.</param>
    public static Diagnostic? Refusal(MachineProfile profile, MotionProgram program, CountsPoint frame, bool dryRun, MotionExtents? following = null)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(program);
        return Of(profile).Count == 0 ? null : Refusal(profile, following?.Union(MotionExtents.Of(program)) ?? MotionExtents.Of(program), program.Profile, frame, dryRun);
    }

    /// <summary>The same check for jobs that reach these counts of their frame.</summary>
    /// <param name="tool">The profile for which they were made, with their depths.</param>
    public static Diagnostic? Refusal(MachineProfile profile, MotionExtents extents, MachineProfile tool, CountsPoint frame, bool dryRun)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(tool);
        if (Refusal(profile, [extents.MinX + frame.X, extents.MinY + frame.Y], [extents.MaxX + frame.X, extents.MaxY + frame.Y]) is { } inPlan) return inPlan;
        if (extents.Heights(tool, dryRun) is not { } heights || profile.Axes.Z is not { } axis || Of(axis) is not { } limit) return null;
        var (least, most) = (heights.Min + frame.Z, heights.Max + frame.Z);
        if (least >= limit.Min && most <= limit.Max) return null;
        var (name, place) = (profile.Axes.NameOf(axis.Letter).ToString(), NumberText.Rounded(axis.Scale.ToMillimetres(least < limit.Min ? least : most), 3));
        var (down, up) = (NumberText.Rounded(axis.Travel!.Min, 3), NumberText.Rounded(axis.Travel.Max, 3));
        return dryRun
            ? PreparationRules.DryRunOutsideTravel.At(default, NumberText.Rounded(axis.Scale.ToMillimetres(DryRunLift.Of(tool, extents)), 3), name, place, down, up)
            : PreparationRules.HeightOutsideTravel.At(default, name, place, down, up);
    }

    private static int Clamp(double counts) => (int)Math.Clamp(counts, int.MinValue, int.MaxValue);
}
