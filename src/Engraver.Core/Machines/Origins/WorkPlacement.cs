using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Machines.Origins;

/// <summary>Finds where a job's drawing lies on the machine, and refuses rather than guesses.</summary>
public static class WorkPlacement
{
    /// <param name="memory">What is kept of the machine.</param>
    /// <param name="place">Where the controller says that it stands now.</param>
    /// <param name="start">The drawing point of the start option, counts of the drawing.</param>
    public static PlacementResult Find(MachineMemory memory, ControllerPlace place, OriginRequest request, MachineProfile profile, CountsPoint start)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(place);
        return request switch
        {
            OriginRequest.PresentPlace => Placed(new CountsPoint(place.Position.X - start.X, place.Position.Y - start.Y), OriginSource.Here),
            OriginRequest.Given { Machine: var at } => Given(place, at, profile),
            OriginRequest.Work => Work(memory, place, profile),
            _ => throw new ArgumentOutOfRangeException(nameof(request)),
        };
    }

    /// <summary>Why the controller's position cannot be trusted by what is kept; null when it can.</summary>
    public static Diagnostic? LossOf(MachineMemory memory, ControllerPlace place)
    {
        ArgumentNullException.ThrowIfNull(memory);
        ArgumentNullException.ThrowIfNull(place);
        var doubt = place.Doubt.Length > 0 ? place.Doubt : memory.Lost;
        if (doubt.Length > 0) return PreparationRules.PositionDoubted.At(default, doubt);
        if (memory.IsSameZero(place) || memory.Mark is null) return null;
        return memory.ActiveOrigin is null or { IsAssumed: true } && memory.RestsAtZero && place.Position == default ? null : PreparationRules.ZeroLost.At(default, memory.Active);
    }

    private static PlacementResult Given(ControllerPlace place, Point2D at, MachineProfile profile)
    {
        if (place.Doubt.Length > 0) return Refused(PreparationRules.PositionDoubted.At(default, place.Doubt));
        return profile.Scale.Holds(Bounds2D.FromCorners(at, at), default)
            ? Placed(profile.Scale.ToCounts(at), OriginSource.Given)
            : Refused(PreparationRules.OriginTooFar.At(default, Number(at.X), Number(at.Y)));
    }

    private static PlacementResult Work(MachineMemory memory, ControllerPlace place, MachineProfile profile)
    {
        if (LossOf(memory, place) is { } lost) return Refused(lost);
        if (memory.ActiveOrigin is { } origin)
            return origin.Plane is { } set ? Placed(set, OriginSource.Work) : Refused(PreparationRules.OriginHalfSet.At(default, memory.Active, origin.X is null ? "X" : "Y"));
        if (place.Position == default) return Placed(default, OriginSource.Work) with { IsAssumed = true };
        var scale = profile.Scale;
        return Refused(PreparationRules.NoOrigin.At(default, memory.Active, Number(place.Position.X / scale.X), Number(place.Position.Y / scale.Y)));
    }

    private static PlacementResult Placed(CountsPoint frame, OriginSource source) => new(frame, source, null);

    private static PlacementResult Refused(Diagnostic refusal) => new(null, OriginSource.Work, refusal);

    private static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);
}

/// <summary>Where the drawing's zero lies by the controller's own zero, or why nobody can say.</summary>
/// <param name="Frame">Controller counts at the drawing's zero; null when it is refused.</param>
/// <param name="Source">Where the place was taken from.</param>
/// <param name="Refusal">What is wrong and what to do; null when there is a place.</param>
public sealed record PlacementResult(CountsPoint? Frame, OriginSource Source, Diagnostic? Refusal)
{
    /// <summary>No origin was set: the controller counts 0, and that place is taken.</summary>
    public bool IsAssumed { get; init; }
}

/// <summary>Where a job's origin comes from.</summary>
public enum OriginSource
{
    /// <summary>The active work origin.</summary>
    Work,

    /// <summary>The place where the machine stands.</summary>
    Here,

    /// <summary>A machine position that was typed.</summary>
    Given,
}

/// <summary>What the operator wants the drawing's zero to be.</summary>
public abstract record OriginRequest
{
    private OriginRequest()
    {
    }

    /// <summary>The active work origin of the machine.</summary>
    public sealed record Work : OriginRequest;

    /// <summary>The machine stands at the drawing's start point.</summary>
    public sealed record PresentPlace : OriginRequest;

    /// <summary>A machine position.</summary>
    /// <param name="Machine">Millimetres by the controller's own zero.</param>
    public sealed record Given(Point2D Machine) : OriginRequest;
}
