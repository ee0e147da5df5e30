using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The lines and arcs of a motion program as geometry, to compute the distance of a sample from them, in counts.</summary>
internal sealed class EngravedPath
{
    private readonly List<Func<double, double, double>> _distances = [];

    public EngravedPath(MotionProgram program)
    {
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var from = sequence.Start;
            foreach (var segment in sequence.Segments)
            {
                _distances.Add(segment.Kind == VectorSegmentKind.Line ? ToLine(from, segment.End) : ToArc(from, segment));
                from = segment.End;
            }
        }
    }

    public double DistanceTo(int x, int y) => _distances.Min(distance => distance(x, y));

    private static Func<double, double, double> ToLine(CountsPoint a, CountsPoint b) => (x, y) =>
    {
        double dx = b.X - a.X, dy = b.Y - a.Y;
        var along = Math.Clamp((((x - a.X) * dx) + ((y - a.Y) * dy)) / ((dx * dx) + (dy * dy)), 0, 1);
        return Math.Sqrt(Math.Pow(x - a.X - (along * dx), 2) + Math.Pow(y - a.Y - (along * dy), 2));
    };

    /// <summary>Angles outside the sweep are not excluded: no other path of these tests is on the circles of the arcs.</summary>
    private static Func<double, double, double> ToArc(CountsPoint start, VectorSegment arc)
    {
        var theta = arc.ThetaDegrees * Math.PI / 180;
        double cx = start.X - (arc.Radius * Math.Cos(theta)), cy = start.Y - (arc.Radius * Math.Sin(theta));
        return (x, y) => Math.Abs(Math.Sqrt(Math.Pow(x - cx, 2) + Math.Pow(y - cy, 2)) - arc.Radius);
    }
}
