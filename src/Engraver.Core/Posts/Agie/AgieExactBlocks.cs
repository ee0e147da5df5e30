using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts.Agie;

/// <summary>Blocks whose whole degrees leave the path by no more than <see cref="ContourError"/>: each starts from the actual machine position, so that errors
/// do not accumulate (sace-xps-agie.md 4.3).</summary>
/// <remarks>An arc is a chord to the next whole degree, arcs of whole degrees of at most half a turn, and a chord to its end. Ends of lines are within 0.708
/// micrometres of the path, ends of arcs within <see cref="ArcError"/>, and a chord adds its height of at most <see cref="ChordHeight"/>.</remarks>
internal sealed class AgieExactBlocks
{
    /// <summary>Micrometres: ArcError and line rounding at the ends of a chord, plus its height between them.</summary>
    public const double ContourError = 1.1;

    private const double ArcError = 0.8;
    private const double ChordHeight = 0.3;

    /// <summary>The effect of rounding on a whole degree.</summary>
    private const double Whole = 1e-9;

    private readonly AgieSteps _steps;

    private AgieExactBlocks(AgieSteps steps) => _steps = steps;

    /// <summary>All strokes, with a positioning line before each but the first.</summary>
    /// <param name="path">Lines, arcs and circles.</param>
    public static AgieSteps Write(Toolpath path)
    {
        var steps = new AgieSteps(path.Strokes[0].Start);
        var exact = new AgieExactBlocks(steps);
        foreach (var stroke in path.Strokes)
        {
            steps.For = (stroke.Index, -1);
            steps.Line(steps.Of(stroke.Start) - steps.Place, drawn: null);
            for (var move = 0; move < stroke.Moves.Count && !steps.TooMany; move++)
            {
                steps.For = (stroke.Index, move);
                exact.Follow(stroke.Moves[move].Segment);
            }
        }

        return steps;
    }

    private void Follow(Segment drawn)
    {
        var gap = _steps.Of(drawn.Start) - _steps.Place;
        if (gap.Length > ArcError) _steps.Line(gap, Segment.FromLine(drawn.Start + (gap * -0.001), drawn.Start)); // within the join tolerance
        if (drawn.Kind == SegmentKind.Line) GoTo(_steps.Of(drawn.End), drawn);
        else FollowArc(drawn);
    }

    private void FollowArc(Segment drawn)
    {
        var (arc, centre, radius) = (drawn.Arc, _steps.Of(drawn.Arc.Centre), drawn.Arc.Radius * 1000.0);
        var (way, at, end) = (arc.Sweep.Degrees > 0.0 ? 1.0 : -1.0, arc.Start.Degrees, arc.Start.Degrees + arc.Sweep.Degrees);
        while (way * (end - at) > Whole && !_steps.TooMany)
        {
            var near = Math.Round(at);
            if (Math.Abs(at - near) <= Whole && Longest(centre, radius, near, way, (int)Math.Floor((way * (end - near)) + Whole)) is { } block)
            {
                _steps.Add(block, drawn);
                at = near + (way * block.WorkDegrees);
            }
            else
            {
                var next = way > 0.0 ? Math.Floor(at + Whole) + 1.0 : Math.Ceiling(at - Whole) - 1.0;
                var isLast = way * (end - next) <= Whole;
                Chords(centre, radius, at, isLast ? end - at : next - at, drawn);
                at = isLast ? end : next;
            }
        }
    }

    /// <summary>The arc with the most whole degrees that stays and ends within the error; null when there is none. The radius, in whole micrometres, is the
    /// nearest or the second nearest number.</summary>
    private AgieBlock? Longest(Point2D centre, double radius, double at, double way, int most)
    {
        if (radius > AgieBlock.Largest) return null;
        for (var work = Math.Min(most, 180); work >= 1; work--)
        {
            foreach (var whole in (double[])[AgieSteps.Rounded(radius), Math.Floor(radius), Math.Ceiling(radius)])
            {
                if (whole >= 1.0 && IsNear(centre, whole, whole - radius, at, way * work)) return AgieBlock.Arc(way < 0.0, (int)(at % 360.0), work, (int)whole);
            }
        }

        return null;
    }

    /// <summary>The centre is off by a vector c and the radius by r, so that the arc differs from the drawn one by r + c.u in the direction u: largest at an
    /// end, or along c.</summary>
    private bool IsNear(Point2D centre, double radius, double longer, double at, double sweep)
    {
        var (from, to) = (Angle.FromDegrees(at), Angle.FromDegrees(at + sweep));
        var off = _steps.Place - Vector2D.FromPolar(radius, from) - centre;
        if ((off + Vector2D.FromPolar(longer, to)).Length > ArcError) return false;
        var arc = new ArcSegment(default, 1.0, from, Angle.FromDegrees(sweep));
        double Apart(Angle direction) => Math.Abs(longer + off.Dot(Vector2D.FromPolar(1.0, direction)));
        if (Apart(from) > ArcError || Apart(to) > ArcError) return false;
        return (!arc.Covers(off.Direction) || Apart(off.Direction) <= ArcError) && (!arc.Covers((-off).Direction) || Apart((-off).Direction) <= ArcError);
    }

    /// <summary>At most about a degree.</summary>
    private void Chords(Point2D centre, double radius, double at, double sweep, Segment drawn)
    {
        var widest = Math.Sqrt(8.0 * ChordHeight / radius) * (180.0 / Math.PI);
        var parts = (int)Math.Clamp(Math.Ceiling(Math.Abs(sweep) / widest), 1.0, AgieSteps.MaxCount);
        for (var i = 1; i <= parts; i++) GoTo(centre + Vector2D.FromPolar(radius, Angle.FromDegrees(at + (sweep * i / parts))), drawn);
    }

    private void GoTo(Point2D target, Segment drawn) => _steps.Line(target - _steps.Place, drawn);
}
