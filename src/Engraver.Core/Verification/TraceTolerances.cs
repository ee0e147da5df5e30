namespace Engraver.Core.Verification;

/// <summary>Allowed differences of a correct run, millimetres.</summary>
public sealed record TraceTolerances
{
    /// <summary>Length of one count of the coarser axis. Rounding both axes and the radius of an arc moves a point by less than 2.5 counts (galil-dmc.md
    /// B.3).</summary>
    public required double Count { get; init; }

    /// <summary>Largest distance between the drawing's curves and the arcs cut for them.</summary>
    public required double MaxError { get; init; }

    /// <summary>Largest distance of a cutting sample from the drawing.</summary>
    public double Deviation => (2.5 * Count) + MaxError;

    /// <summary>Largest distance from a drawn corner at which an arc may round it (see <see cref="Corners.DrawnCorner"/>); 0 where corners are not
    /// rounded.</summary>
    public double CornerTolerance { get; init; }

    /// <summary>Largest gap between two drawn ends that are joined to a corner.</summary>
    public double JoinTolerance { get; init; }

    /// <summary>Distance by which a chord between two samples cuts a corner: chord squared / (8 x radius), here 20 mm/s at 1 ms on a radius of 0.1
    /// mm.</summary>
    public double ChordSagitta { get; init; } = 0.0005;

    /// <summary>A point of the drawing counts as cut when the trace passes within this distance.</summary>
    public double Coverage => Deviation + ChordSagitta;

    /// <summary>A shorter gap is ignored: where chords between samples cut a corner, a small part of the drawing is outside them.</summary>
    public double LargestStep { get; init; } = 0.05;

    /// <summary>In a short segment a gap shorter than its length divided by this is also ignored.</summary>
    public int MinSteps { get; init; } = 16;

    /// <summary>Number of longest ignored gaps that fit into a segment of this length.</summary>
    public double StepsFor(double length) => Math.Max(Math.Ceiling(length / LargestStep), MinSteps);
}
