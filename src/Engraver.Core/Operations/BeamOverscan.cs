using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Operations;

/// <summary>The ways before and behind the lines of a fill at full speed with the beam off.</summary>
public static class BeamOverscan
{
    /// <summary>Where the motion of a line begins and ends.</summary>
    /// <param name="line">A straight line with a length.</param>
    /// <param name="overscan">Length of each way, mm.</param>
    public static (Point2D From, Point2D To) Around(in Segment line, double overscan)
    {
        var way = (line.End - line.Start) * (overscan / line.Length);
        return (line.Start - way, line.End + way);
    }

    /// <summary>Smallest box of the ways; empty without any.</summary>
    /// <param name="path">The path of the whole job.</param>
    /// <param name="strokes">Operation and pass of each of its strokes.</param>
    public static Bounds2D BoundsOf(Toolpath path, IReadOnlyList<StrokePass> strokes)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(strokes);
        return path.Strokes.Zip(strokes).Where(pair => pair.Second.Operation.Overscan > 0.0).SelectMany(pair => pair.First.Moves.Select(move => Around(move.Segment, pair.Second.Operation.Overscan)))
            .Aggregate(Bounds2D.Empty, (box, way) => box.Union(Bounds2D.FromCorners(way.From, way.To)));
    }
}
