using System.Globalization;
using System.Text;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>Lines and arcs of an XPS controller's XY group: each element continues from the end and the direction of the previous one (sace-xps-agie.md
/// 2.2).</summary>
/// <remarks>The bound applies to the text: each element is followed from the rounded numbers of the text, so that the bound includes accumulated
/// rounding.</remarks>
public sealed class LineArcText
{
    /// <summary>Largest change of direction between two elements that the file allows, degrees, when they are tangent.</summary>
    private const double SmoothDegrees = 0.01;

    /// <summary>Arcs with a smaller radius or length are written as lines.</summary>
    private const double MinLength = 1e-6;

    /// <summary>Maximum number of decimals of an angle in degrees in a double.</summary>
    private const int MaxDecimals = 14;

    /// <summary>Rounding of the calculation itself as a fraction of the coordinates and of each element, generous.</summary>
    private const double Rounding = 64.0 * 2.220446049250313e-16;

    private readonly StringBuilder _text = new();
    private readonly List<string> _broken = [];
    private readonly List<Segment> _run = [];
    private readonly Point2D _origin;
    private readonly double _length;
    private Point2D _place;
    private Vector2D _way;
    private double _bound;
    private double _turn;
    private int _elements;

    private LineArcText(Point2D origin, Vector2D way, double length) => (_origin, _place, _way, _length) = (origin, origin, way, length);

    /// <summary>The file of one run without corners.</summary>
    /// <param name="segments">Tangent to each other; ellipses and splines become arcs within the error.</param>
    /// <param name="closed">True when the last segment ends where the first starts.</param>
    /// <returns>Null when the file's arcs would differ from the drawing by more than the error.</returns>
    internal static TrajectoryFile? From(IReadOnlyList<Segment> segments, bool closed, TrajectoryOptions options, TrajectoryMotion motion)
    {
        const double FitShare = 0.98;
        List<Segment> elements = [.. segments.SelectMany(segment => segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, FitShare * options.MaxError) : [segment]).Where(segment => segment.Length > MinLength)];
        if (elements.Count == 0) return null;
        var length = elements.Sum(element => element.Length);
        var first = Math.Round(elements[0].StartTangent.Direction.Degrees, AngleDecimals(length));
        var writer = new LineArcText(elements[0].Start, Vector2D.FromPolar(1.0, Angle.FromDegrees(first)), length);
        foreach (var element in elements) writer.Add(element);
        var fitted = segments.Any(segment => segment.IsFreeCurve) ? FitShare * options.MaxError : 0.0;
        var bound = writer._bound + fitted + (Rounding * elements.Max(element => Math.Abs(element.Start.X) + Math.Abs(element.Start.Y) + element.Length));
        if (!(bound <= options.MaxError)) return null;
        var chain = SmoothChain.From(segments, closed);
        var head = $"FirstTangent = {Exact(first, "0.", AngleDecimals(length))}\nDiscontinuityAngle = {TrajectoryFile.Number(Math.Max(SmoothDegrees, Math.Ceiling(writer._turn * 1000.0) / 1000.0))}\n\n";
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
        if (way.Length < MinLength) _broken.Add(Wording.Get("Xps.ElementWithoutLength", _elements));
        Turn(way);
        _run.Add(Segment.FromLine(_place, end));
        (_place, _way) = (end, way * (1.0 / way.Length));
        _text.Append("Line = ").Append(TrajectoryFile.LongNumber(x)).Append(", ").Append(TrajectoryFile.LongNumber(y)).Append('\n');
    }

    /// <summary>The arc that the controller runs differs from the drawn one in position, direction, curvature and length.</summary>
    private void AddArc(Segment segment)
    {
        var (arc, side) = (segment.Arc, Math.Sign(segment.Arc.Sweep.Degrees));
        var (radius, decimals) = (Rounded(arc.Radius), AngleDecimals(Math.Max(arc.Radius, _length)));
        var sweep = Math.Round(arc.Sweep.Degrees, decimals);
        if (!(radius > 0.0)) _broken.Add(Wording.Get("Xps.ArcWithoutRadius", _elements));
        if (sweep == 0.0 || Math.Abs(sweep) > 360.0) _broken.Add(Wording.Get("Xps.BadArcSweep", _elements));
        Turn(segment.StartTangent);
        var centre = _place + (new Vector2D(-_way.Y, _way.X) * (side * radius));
        var (drawn, ran) = (segment.Start - arc.Centre, _place - centre);
        _bound = Math.Max(_bound, _place.DistanceTo(segment.Start) + Math.Min(
            OfPlaces(centre.DistanceTo(arc.Centre), arc, radius, Math.Abs(drawn.TurnTo(ran).Radians), sweep),
            OfDirections(arc, radius, _way.TurnTo(segment.StartTangent).Abs().Radians, sweep)));
        var turn = Angle.FromDegrees(sweep);
        _run.Add(Segment.FromArc(new ArcSegment(centre, radius, ran.Direction, turn)));
        (_place, _way) = (centre + Turned(ran, turn), Turned(_way, turn));
        _text.Append("Arc = ").Append(TrajectoryFile.LongNumber(radius)).Append(", ").Append(Exact(sweep, "0.000000", decimals)).Append('\n');
    }

    /// <summary>The distance is at most that of the centres and radii plus the difference of the angles.</summary>
    private static double OfPlaces(double centres, ArcSegment arc, double radius, double start, double sweep) =>
        centres + Math.Abs(radius - arc.Radius) + (Math.Max(radius, arc.Radius) * (start + (Math.Abs(arc.Sweep.Degrees - sweep) * Math.PI / 180.0)));

    /// <summary>The directions of both arcs differ by the difference at the start plus the difference of the curvatures for each millimetre: two integrals.
    /// Near an inflection, where the radius is large, this is the smaller bound.</summary>
    private static double OfDirections(ArcSegment arc, double radius, double start, double sweep)
    {
        var (drawn, ran) = (arc.Radius * Math.Abs(arc.Sweep.Radians), radius * Math.Abs(sweep) * Math.PI / 180.0);
        var both = Math.Min(drawn, ran);
        return (both * (start + (both * Math.Abs((1.0 / arc.Radius) - (1.0 / radius)) / 2.0))) + Math.Abs(drawn - ran);
    }

    private static string Exact(double angle, string least, int decimals) => (angle + 0.0).ToString(least.PadRight(decimals + 2, '#'), CultureInfo.InvariantCulture);

    /// <summary>Number of decimals for which the rounded angle moves a point at this distance by at most 1e-7 mm.</summary>
    private static int AngleDecimals(double distance) => Math.Clamp((int)Math.Ceiling(Math.Log10(distance * (Math.PI / 180.0) / 1e-7)), SplineFit.Decimals, MaxDecimals);

    private void Turn(Vector2D to) => _turn = Math.Max(_turn, _way.TurnTo(to).Abs().Degrees);

    private static Vector2D Turned(Vector2D vector, Angle by) => new((vector.X * by.Cos()) - (vector.Y * by.Sin()), (vector.X * by.Sin()) + (vector.Y * by.Cos()));
}
