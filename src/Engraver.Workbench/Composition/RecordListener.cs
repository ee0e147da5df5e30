using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;
using Engraver.Simulator;
using Engraver.Simulator.Motion;

namespace Engraver.Workbench.Composition;

/// <summary>Tells judges what a simulated controller does, in millimetres of the drawing, while it does it: nothing is kept.</summary>
/// <remarks>Called by the controller under its lock; <see cref="Start"/> and <see cref="Verdicts"/> may come from elsewhere.</remarks>
internal sealed class RecordListener(MachineProfile profile, params TraceJudge[] judges) : IMotionListener
{
    private const double RoundEnough = 1e-9;
    private readonly Lock _gate = new();
    private readonly int _toolBit = 1 << (profile.ToolOutput - 1);
    private readonly double _count = 1.0 / profile.Scale.Largest;
    private readonly int _x = IndexOf(profile.Axes.X);
    private readonly int _y = IndexOf(profile.Axes.Y);
    private (double X, double Y)? _frame;

    /// <summary>Samples from now on belong to the job; what was before is nobody's.</summary>
    /// <param name="frameX">Counts of the controller at the drawing's zero, axis of X.</param>
    /// <param name="frameY">The same, axis of Y.</param>
    public void Start(double frameX, double frameY)
    {
        lock (_gate)
        {
            _frame ??= (frameX, frameY);
        }
    }

    /// <summary>One for each judge.</summary>
    public TraceVerdict[] Verdicts()
    {
        lock (_gate)
        {
            return [.. judges.Select(judge => judge.Verdict())];
        }
    }

    public void Add(in MotionSample sample)
    {
        lock (_gate)
        {
            if (_frame is not { } frame) return;
            var place = Place(frame, sample[_x], sample[_y]);
            var told = new TraceSample(sample.Seconds, place.X, place.Y, IsCutting(sample.Outputs));
            foreach (var judge in judges) judge.Add(told);
        }
    }

    public void Add(MotionSpan span)
    {
        lock (_gate)
        {
            if (_frame is not { } frame) return;
            if (span.ArcOf(_x, _y) is { } arc && IsCutting(span.Outputs)) TellArc(frame, span, arc);
            else Tell(frame, span, 0, span.Count - 1);
        }
    }

    /// <summary>Samples hold the axes in the order of their letters.</summary>
    private static int IndexOf(MachineAxis axis) => axis.Letter - 'A';

    private bool IsCutting(byte outputs) => (outputs & _toolBit) != 0;

    private Point2D Place((double X, double Y) frame, double x, double y) => profile.Scale.ToMillimetres(x - frame.X, y - frame.Y);

    /// <summary>The straight way from one sample of a span to another.</summary>
    private void Tell((double X, double Y) frame, MotionSpan span, long from, long to)
    {
        var (first, last) = (span.Exactly(from, _x, _y), span.Exactly(to, _x, _y));
        Tell(span, from, to, Segment.FromLine(Place(frame, first.X, first.Y), Place(frame, last.X, last.Y)));
    }

    private void Tell(MotionSpan span, long from, long to, Segment path)
    {
        var told = new TraceSpan(span[from].Seconds, span[to].Seconds, to - from + 1, path, IsCutting(span.Outputs));
        foreach (var judge in judges) judge.Add(told);
    }

    /// <summary>Where the axes' scales make an ellipse of it, which no program of ours asks for, it is told as chords that stay within a twentieth of a count.</summary>
    private void TellArc((double X, double Y) frame, MotionSpan span, ArcCourse arc)
    {
        var (radiusX, radiusY) = (arc.RadiusX / profile.Scale.X, arc.RadiusY / profile.Scale.Y);
        var radius = Math.Max(Math.Abs(radiusX), Math.Abs(radiusY));
        if (Math.Abs(Math.Abs(radiusX) - Math.Abs(radiusY)) <= RoundEnough * radius)
        {
            var centre = Place(frame, arc.CentreX, arc.CentreY);
            Tell(span, 0, span.Count - 1, Segment.FromArc(Unmirrored(new ArcSegment(centre, radius, Angle.FromDegrees(arc.StartDegrees), Angle.FromDegrees(arc.SweepDegrees)), radiusX < 0.0, radiusY < 0.0)));
            return;
        }

        var chords = (long)Math.Min(span.Count - 1, Math.Ceiling(Math.Abs(arc.SweepDegrees) * (Math.PI / 180.0) / Math.Sqrt(8.0 * _count / 20.0 / radius)));
        for (var i = 0L; i < chords; i++) Tell(frame, span, i * (span.Count - 1) / chords, (i + 1) * (span.Count - 1) / chords);
    }

    /// <summary>An axis that counts the other way mirrors the angles.</summary>
    private static ArcSegment Unmirrored(ArcSegment arc, bool isXMirrored, bool isYMirrored)
    {
        if (isXMirrored) arc = arc with { Start = Angle.FromDegrees(180.0) - arc.Start, Sweep = -arc.Sweep };
        return isYMirrored ? arc with { Start = -arc.Start, Sweep = -arc.Sweep } : arc;
    }
}
