using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines.Origins;

/// <summary>Where the drawing's zero is from the controller's own zero, or why it is unknown.</summary>
/// <param name="Frame">Controller counts at the drawing's zero; null when it is refused.</param>
/// <param name="Source">The source of the position.</param>
/// <param name="Refusal">What is wrong and what to do; null when there is a position.</param>
public sealed record PlacementResult(CountsPoint? Frame, OriginSource Source, Diagnostic? Refusal)
{
    /// <summary>No origin was set: the controller counts 0, and that point is taken.</summary>
    public bool IsAssumed { get; init; }

    /// <summary>The work origin of a following job that is the reason of <see cref="Refusal"/>; null where it is the job itself.</summary>
    public string? RefusedOrigin { get; init; }

    /// <summary>The job was compared with the travel of the machine and does not leave it; also false where the travel is unknown.</summary>
    public bool IsWithinTravel { get; init; }
}
