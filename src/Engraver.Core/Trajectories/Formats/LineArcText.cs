using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Lines and arcs of an XPS controller's XY group: each element goes on from the end and the direction of the one before (sace-xps-agie.md 2.2).</summary>
/// <remarks>What is bounded is what the text says: each element is followed from the text's own rounded numbers, so that roundings that add up are in the bound.</remarks>
public sealed class LineArcText
{
    /// <summary>Largest change of direction between two elements that the file allows, degrees, when they are tangent.</summary>
    private const double SmoothDegrees = 0.01;

    /// <summary>Arcs with less radius or length are left to the line that they are.</summary>
    private const double LeastLength = 1e-6;

    /// <summary>Rounding of the calculation itself as a part of the coordinates and of each element, generous.</summary>
    private const double Rounding = 64.0 * 2.220446049250313e-16;

    private readonly StringBuilder _text = new();
    private readonly List<string> _broken = [];
    private readonly List<Segment> _run = [];
    private readonly Point2D _origin;
    private Point2D _place;
    private Vector2D _way;
    private double _bound;
    private double _turn;
    private int _elements;

    private LineArcText(Point2D origin, Vector2D way) => (_origin, _place, _way) = (origin, origin, way);

    /// <summary>The file of one run without corners.</summary>
    /// <param name="segments">Tangent to each other; ellipses and splines become arcs within the error.</param>
    /// <param name="closed">The last ends where the first starts.</param>
    /// <returns>Null when the file's arcs would leave the drawing by more than the error.</returns>
    internal static TrajectoryFile? From(IReadOnlyList<Segment> segments, bool closed, TrajectoryOptions options, TrajectoryMotion motion)
    {
        const double FitShare = 0.98;
        List<Segment> elements = [.. segments.SelectMany(segment => segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, FitShare * options.MaxError) : [segment]).Where(segment => segment.Length > LeastLength)];
        if (elements.Count == 0) return null;
        var first = Rounded(elements[0].StartTangent.Direction.Degrees);
        var writer = new LineArcText(elements[0].Start, Vector2D.FromPolar(1.0, Angle.FromDegrees(first)));
        foreach (var element in elements) writer.Add(element);
        var fitted = segments.Any(segment => segment.IsFreeCurve) ? FitShare * options.MaxError : 0.0;
        var bound = writer._bound + fitted + (Rounding * elements.Max(element => Math.Abs(element.Start.X) + Math.Abs(element.Start.Y) + element.Length));
        if (!(bound <= options.MaxError)) return null;
        var chain = SmoothChain.From(segments, closed);
        var head = $"FirstTangent = {TrajectoryFile.Number(first)}\nDiscontinuityAngle = {TrajectoryFile.Number(Math.Max(SmoothDegrees, Math.Ceiling(writer._turn * 1000.0) / 1000.0))}\n\n";
        return new TrajectoryFile(head + writer._text, elements[0].Start, options.Z, writer._elements + 1, SampledDistance.Of(writer._run, chain), bound, 1.0, chain.Length, closed, segments)
        {
            BrokenLimits = [.. writer._broken, .. MotionLimits.BrokenTravel(writer._run, motion)],
            MaxSpeed = MotionLimits.SpeedOf(writer._run, motion.Acceleration) is var speed && double.IsFinite(speed) ? speed : null,
        };
    }

    private static double Rounded(double value) => Math.Round(value, SplineFit.Decimals);

    private void Add(Segment element)
    {
        _elements++;
        if (element.Kind == SegmentKind.Line) AddLine(element);
        else AddArc(element);
    }

    private void AddLine(Segment line)
    {
        var (x, y) = (Rounded(line.End.X - _origin.X), Rounded(line.End.Y - _origin.Y));
        var end = new Point2D(_origin.X + x, _origin.Y + y);
        _bound = Math.Max(_bound, Math.Max(_place.DistanceTo(line.Start), end.DistanceTo(line.End)));
        var way = end - _place;
        if (way.Length < LeastLength) _broken.Add(Wording.Get("Xps.ElementWithoutLength", _elements));
        Turn(way);
        _run.Add(Segment.FromLine(_place, end));
        (_place, _way) = (end, way * (1.0 / way.Length));
        _text.Append("Line = ").Append(TrajectoryFile.LongNumber(x)).Append(", ").Append(TrajectoryFile.LongNumber(y)).Append('\n');
    }

    /// <summary>The arc that the controller runs differs from the drawn one by place and direction of its start and by rounding; the distance is at most that of the centres and radii plus what the angles differ by.</summary>
    private void AddArc(Segment segment)
    {
        var (arc, side) = (segment.Arc, Math.Sign(segment.Arc.Sweep.Degrees));
        var (radius, sweep) = (Rounded(arc.Radius), Rounded(arc.Sweep.Degrees));
        if (!(radius > 0.0)) _broken.Add(Wording.Get("Xps.ArcRadius", _elements));
        if (sweep == 0.0 || Math.Abs(sweep) > 360.0) _broken.Add(Wording.Get("Xps.ArcSweep", _elements));
        Turn(segment.StartTangent);
        var centre = _place + (new Vector2D(-_way.Y, _way.X) * (side * radius));
        var (drawn, ran) = (segment.Start - arc.Centre, _place - centre);
        var start = Math.Abs(drawn.TurnTo(ran).Radians);
        var end = start + (Math.Abs(arc.Sweep.Degrees - sweep) * Math.PI / 180.0);
        _bound = Math.Max(_bound, centre.DistanceTo(arc.Centre) + Math.Abs(radius - arc.Radius) + (Math.Max(radius, arc.Radius) * end) + _place.DistanceTo(segment.Start));
        var turn = Angle.FromDegrees(sweep);
        _run.Add(Segment.FromArc(new ArcSegment(centre, radius, ran.Direction, turn)));
        (_place, _way) = (centre + Turned(ran, turn), Turned(_way, turn));
        _text.Append("Arc = ").Append(TrajectoryFile.LongNumber(radius)).Append(", ").Append(TrajectoryFile.LongNumber(sweep)).Append('\n');
    }

    private void Turn(Vector2D to) => _turn = Math.Max(_turn, _way.TurnTo(to).Abs().Degrees);

    private static Vector2D Turned(Vector2D vector, Angle by) => new((vector.X * by.Cos()) - (vector.Y * by.Sin()), (vector.X * by.Sin()) + (vector.Y * by.Cos()));
}
