using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>One figure as straight lines. A closed one does not repeat its first point.</summary>
internal sealed class Polyline
{
    public List<Vector> Points { get; } = [];

    public bool IsClosed { get; set; }

    /// <summary>Number of straight pieces, including the closing one of a closed figure.</summary>
    public int SegmentCount => IsClosed && Points.Count > 1 ? Points.Count : Math.Max(0, Points.Count - 1);

    public (Vector Start, Vector End) Segment(int index) => (Points[index], Points[(index + 1) % Points.Count]);
}
