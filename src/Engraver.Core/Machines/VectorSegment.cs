namespace Engraver.Core.Machines;

/// <summary>One VP or CR of a vector sequence, in counts of the job's frame.</summary>
/// <remarks>Line: only <see cref="End"/> matters. Arc: radius, theta and delta exactly as they will be sent (already rounded to the controller's resolution);
/// <see cref="End"/> is the predicted position after it, rounded to counts (galil-dmc.md B.3).</remarks>
/// <param name="Kind">VP or CR.</param>
/// <param name="End">End point, job frame.</param>
/// <param name="Radius">CR radius, whole counts; 0 for a line.</param>
/// <param name="ThetaDegrees">CR theta: direction from the centre to the current point.</param>
/// <param name="DeltaDegrees">CR delta: signed sweep, counter-clockwise positive.</param>
/// <param name="EntityIndex">The drawing entity of this segment.</param>
/// <param name="Length">Path length in counts.</param>
public readonly record struct VectorSegment(
    VectorSegmentKind Kind, CountsPoint End, int Radius, double ThetaDegrees, double DeltaDegrees, int EntityIndex, double Length)
{
    /// <summary>Vector speed that is commanded from its start, even counts/s (galil-dmc.md B.4: <c>&lt;o</c>); 0: that of its sequence.</summary>
    public int Speed { get; init; }

    /// <summary>The move of the toolpath's stroke that it cuts. Where several moves became one path, all its segments state the first of them.</summary>
    public int Move { get; init; }

    /// <summary>Number of consecutive moves of that path.</summary>
    public int Moves { get; init; } = 1;

    /// <summary>The entities that it cuts, in order, the first of which is <see cref="EntityIndex"/>; null where there is only that one.</summary>
    public IReadOnlyList<EntityShare>? Shares { get; init; }

    /// <summary>The entity at a place of it.</summary>
    /// <param name="along">Length from its start, counts.</param>
    public int EntityAt(double along)
    {
        var last = EntityIndex;
        for (var i = 0; i < Shares?.Count; i++)
        {
            last = Shares[i].EntityIndex;
            if ((along -= Shares[i].Length) < 0.0) break;
        }

        return last;
    }
}
