using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>Passes every motion to the judges: lines and arcs for a machine whose tool is switched by an output, points a step apart with their heights for a
/// machine with a tool axis. The reported time only gives the order.</summary>
internal sealed class GcodeTracer(ReplayRequest request)
{
    /// <summary>Step between points on a machine with a tool axis, millimetres.</summary>
    private const double Step = 0.05;

    /// <summary>Allowed difference between the radii of consecutive pieces, millimetres.</summary>
    private const double RadiusStep = 2e-5;

    private const int MaxPieces = 720;

    /// <summary>Rounding error at the end of a calculated arc, millimetres.</summary>
    private const double NegligibleLength = 1e-9;

    private readonly HeightDrive? _drive = request.Machine.Height;
    private double _seconds;

    /// <summary>True when an axis has moved or a cut was made.</summary>
    public bool HasMoved { get; private set; }

    /// <summary>Called when the tool is switched on or off at the machine position.</summary>
    public void Switch(Vector3D place, bool isOn)
    {
        if (_drive is null) Dwell(place.X, place.Y, 0.0, isOn);
    }

    public void Line(Vector3D from, Vector3D to, GcodeMotion motion)
    {
        HasMoved = true;
        if (_drive is not null) Places(from, to, part => from + ((to - from) * part), (to - from).Length, motion);
        else if (!motion.IsOn) Dwell(to.X, to.Y, 0.0, isOn: false);
        else if (from.X != to.X || from.Y != to.Y) Cut(Segment.FromLine(new Point2D(from.X, from.Y), new Point2D(to.X, to.Y)), motion);
    }

    /// <summary>Passes an arc, which can rise.</summary>
    public void Arc(GcodeArc arc, Vector3D from, Vector3D to, GcodeMotion motion)
    {
        HasMoved = true;
        motion = motion with { Blend = motion.Blend with { Lines = 0.0 } };
        var length = Math.Abs(arc.Sweep) * Math.Max(arc.StartRadius, arc.EndRadius);
        if (_drive is not null) Places(from, to, part => arc.At(part) is var at ? new Vector3D(at.X, at.Y, from.Z + ((to.Z - from.Z) * part)) : default, double.Hypot(length, to.Z - from.Z), motion);
        else if (!motion.IsOn) Dwell(to.X, to.Y, 0.0, isOn: false);
        else Pieces(arc, new Point2D(to.X, to.Y), motion);
    }

    /// <summary>In quarters of a turn at most, as the judges require arcs; for ends at different distances from the centre, in as many pieces as keep each
    /// within half a step of its radius. A straight move follows when the arc does not reach the end.</summary>
    private void Pieces(GcodeArc arc, Point2D end, GcodeMotion motion)
    {
        var (quarters, spiral) = (Math.Ceiling(Math.Abs(arc.Sweep) / (Math.PI / 2.0)), Math.Ceiling(Math.Abs(arc.EndRadius - arc.StartRadius) / RadiusStep));
        var parts = (int)Math.Clamp(spiral, quarters, MaxPieces);
        for (var i = 0; i < parts; i++)
        {
            var radius = arc.StartRadius + ((arc.EndRadius - arc.StartRadius) * (i + 0.5) / parts);
            Cut(Segment.FromArc(new ArcSegment(arc.Centre, radius, Angle.FromRadians(arc.From + (arc.Sweep * i / parts)), Angle.FromRadians(arc.Sweep / parts))), motion);
        }

        if (arc.At(1.0) is var last && last.DistanceTo(end) > NegligibleLength) Cut(Segment.FromLine(last, end), motion);
    }

    /// <summary>Both ends and places between; the tool cuts below the retract height.</summary>
    private void Places(Vector3D from, Vector3D to, Func<double, Vector3D> at, double length, GcodeMotion motion)
    {
        var isCut = Math.Min(from.Z, to.Z) < _drive!.RetractHeight;
        var steps = isCut ? (int)Math.Max(1.0, Math.Ceiling(length / Step)) : 1;
        for (var i = isCut ? 0 : 1; i <= steps; i++)
        {
            var place = i == steps ? to : at((double)i / steps);
            Dwell(place.X, place.Y, place.Z, place.Z < _drive.RetractHeight);
        }

        if (!isCut) return;
        request.Blends?.Add(motion.Line, motion.Blend.Largest);
        request.Feeds?.Reach(Math.Min(from.Z, to.Z));
        if (!double.IsInfinity(motion.Feed) || from.X != to.X || from.Y != to.Y || to.Z < from.Z) request.Feeds?.Add(motion.Line, motion.Feed, length, from.Z - to.Z, strokes: request.Strokes?.Passing(new Point2D(to.X, to.Y), to.Z));
    }

    private void Cut(in Segment path, GcodeMotion motion)
    {
        foreach (var judge in request.Judges) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
        _seconds += 1.0;
        request.Feeds?.Add(motion.Line, motion.Feed, path.Length, strokes: request.Strokes?.Passing(path.End, null));
        request.Blends?.Add(motion.Line, motion.Blend.Largest);
    }

    private void Dwell(double x, double y, double z, bool isOn)
    {
        _seconds += 1.0;
        foreach (var judge in request.Judges) judge.Add(new TraceSample(_seconds, x, y, isOn, z));
    }
}
