using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The motions at feed while a beam is off: a fill with overscan requires one before and one after each line, in its direction and at its feed; every
/// other is required to be a rapid.</summary>
internal sealed class GcodeOverscan(RequirementsJudge? terms, StrokeRequirements? strokes)
{
    /// <summary>Rounding of a place, mm; a direction is as uncertain as both ends of its line.</summary>
    private const double Rounding = 0.0003;

    private OffMotion? _before;
    private OverscanLine? _last;

    /// <summary>A straight motion at feed while the beam is off.</summary>
    public void Pass(Point2D from, Point2D to, double feed, int line)
    {
        var motion = new OffMotion(from, to, feed, line);
        if (_last is { } cut)
        {
            if (!Continues(cut.From, cut.To, from, to, cut.Required) || feed != cut.Feed) Add(line, motion.Length, cut.Required);
            _last = null;
            return;
        }

        End();
        _before = motion;
    }

    /// <summary>A straight motion with the beam on.</summary>
    public void Cut(Point2D from, Point2D to, double feed, int line)
    {
        var middle = new Point2D((from.X + to.X) / 2.0, (from.Y + to.Y) / 2.0);
        var required = strokes?.Passing(middle, null).Select(stroke => stroke.Overscan).DefaultIfEmpty(0.0).Min() ?? 0.0;
        if (required == 0.0)
        {
            End();
            return;
        }

        if (_last is { } cut && Continues(cut.From, cut.To, from, to, 0.0))
        {
            _last = cut with { To = to };
            return;
        }

        EndLine();
        if (_before is not { } before) Add(line, 0.0, required);
        else if (!Continues(to, from, before.To, before.From, required) || before.Feed != feed) Add(before.Line, before.Length, required);
        (_before, _last) = (null, new OverscanLine(from, to, feed, required, line));
    }

    /// <summary>Another motion, or the end of the program.</summary>
    public void End()
    {
        EndLine();
        if (_before is { } before) terms?.AddDifference(before.Line, "G1", "G0");
        _before = null;
    }

    private void EndLine()
    {
        if (_last is { } cut) Add(cut.Number, 0.0, cut.Required);
        _last = null;
    }

    /// <summary>True for a motion that begins where a line ends, has its direction and at least a length.</summary>
    private static bool Continues(Point2D from, Point2D to, Point2D start, Point2D end, double length)
    {
        var (line, way) = (to - from, end - start);
        return start.DistanceTo(to) <= Rounding && way.Length >= length - Rounding && line.Dot(way) >= 0.0 && Math.Abs(line.Cross(way)) <= Rounding * (line.Length + way.Length);
    }

    private void Add(int line, double actual, double required) => terms?.AddDifference(line, Said(actual), Said(required));

    private static string Said(double length) => $"G1 S0, {NumberText.Rounded(length, 4)} mm";

    private readonly record struct OffMotion(Point2D From, Point2D To, double Feed, int Line)
    {
        public double Length => From.DistanceTo(To);
    }

    /// <param name="Required">Way that must follow, mm.</param>
    /// <param name="Number">Line of the program's text.</param>
    private readonly record struct OverscanLine(Point2D From, Point2D To, double Feed, double Required, int Number);
}
