using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Verification;
using Engraver.Simulator;
using Engraver.Simulator.Motion;

namespace Engraver.Workbench.Composition;

/// <summary>Forwards the motion of a simulated controller to judges as it happens, in millimetres of the drawing. Stores nothing.</summary>
/// <remarks>Called by the controller under its lock; <see cref="Start"/> and <see cref="Verdicts"/> may be called from other threads.</remarks>
internal sealed class RecordListener(MachineProfile profile, params ITraceJudge[] judges) : IMotionListener
{
    private const double ScaleTolerance = 1e-9;
    private readonly Lock _gate = new();
    private readonly OutputSwitch _tool = profile.Tool;
    private readonly int? _z = profile.Height is null || profile.Axes.Z is not { } z ? null : IndexOf(z);
    private readonly double _count = profile.Scale.Finer.LengthOf(1.0);
    private readonly int _x = IndexOf(profile.Axes.X);
    private readonly int _y = IndexOf(profile.Axes.Y);
    private (double X, double Y, double Z)? _frame;

    /// <summary>Also receives the positions; null for none.</summary>
    public RunTraceBuilder? Places { get; init; }

    /// <summary>Also compares the motors with the drawing; null for none.</summary>
    public MotorJudge? Motors { get; init; }

    /// <summary>Samples from now on belong to the job and are judged; earlier ones are ignored.</summary>
    /// <param name="frameX">Counts of the controller at the drawing's zero, axis of X.</param>
    /// <param name="frameY">The same, axis of Y.</param>
    /// <param name="frameZ">The same, axis of Z.</param>
    public void Start(double frameX, double frameY, double frameZ = 0.0)
    {
        lock (_gate)
        {
            _frame ??= (frameX, frameY, frameZ);
        }
    }

    /// <summary>Sets the conditions of the places that are added from now on.</summary>
    public void SetConditions(TraceConditions conditions)
    {
        lock (_gate)
        {
            Places?.Conditions = conditions;
        }
    }

    /// <summary>One verdict for each judge.</summary>
    public TraceVerdict[] Verdicts()
    {
        lock (_gate)
        {
            return [.. judges.Select(judge => judge.Verdict())];
        }
    }

    /// <summary>Reads from a judge while no sample is added to it.</summary>
    public T Between<T>(Func<T> read)
    {
        lock (_gate)
        {
            return read();
        }
    }

    public void Add(in MotionSample sample)
    {
        lock (_gate)
        {
            if (_frame is not { } frame) return;
            Forward(frame, sample);
        }
    }

    /// <summary>The collected trace; null without a builder.</summary>
    public RunTrace? Trace()
    {
        lock (_gate)
        {
            return Places?.ToTrace("record");
        }
    }

    public void Add(MotionSpan span)
    {
        lock (_gate)
        {
            if (_frame is not { } frame) return;
            if (_z is not null) ForwardSamples(frame, span);
            else if (span.ArcOf(_x, _y) is { } arc && IsCutting(span.Outputs)) ForwardArc(frame, span, arc);
            else Forward(frame, span, 0, span.Count - 1);
        }
    }

    /// <summary>Samples contain the axes in the order of their letters.</summary>
    private static int IndexOf(MachineAxis axis) => axis.Letter - 'A';

    /// <summary>With a tool axis every sample is judged individually, also at constant speed.</summary>
    private void ForwardSamples((double X, double Y, double Z) frame, MotionSpan span)
    {
        for (var i = 0L; i < span.Count; i++) Forward(frame, span[i]);
    }

    /// <summary>The record contains motor positions; the commanded position differs from them by the controller's position error.</summary>
    private void Forward((double X, double Y, double Z) frame, in MotionSample sample)
    {
        var motor = Place(frame, sample[_x], sample[_y]);
        var (errorX, errorY, errorZ) = (sample.ErrorOf(_x), sample.ErrorOf(_y), _z is { } height ? sample.ErrorOf(height) : 0);
        var commanded = errorX == 0 && errorY == 0 ? motor : Place(frame, (double)sample[_x] + errorX, (double)sample[_y] + errorY);
        var z = _z is { } axis ? sample[axis] + (double)errorZ - frame.Z : 0.0;
        var isCutting = _z is null ? IsCutting(sample.Outputs) : profile.UpSign * z < profile.UpSign * (double)profile.RetractCounts;
        var following = double.Hypot(motor.DistanceTo(commanded), profile.Scale.ToMillimetres((double)errorZ));
        var traced = new TraceSample(sample.Seconds, commanded.X, commanded.Y, isCutting, profile.Scale.ToMillimetres(z)) { FollowingMm = following, Outputs = sample.Outputs };
        var seen = traced with { XMm = motor.X, YMm = motor.Y, ZMm = profile.Scale.ToMillimetres(z - errorZ) };
        foreach (var judge in judges) judge.Add(traced);
        Motors?.Add(traced, seen);
        Places?.Add(seen);
    }

    private bool IsCutting(byte outputs) => _tool.IsOn(outputs);

    private Point2D Place((double X, double Y, double Z) frame, double x, double y) => profile.Scale.ToMillimetres(x - frame.X, y - frame.Y);

    /// <summary>Forwards the straight line from one sample of a span to another to the judges.</summary>
    private void Forward((double X, double Y, double Z) frame, MotionSpan span, long from, long to)
    {
        var (first, last) = (span.Exactly(from, _x, _y), span.Exactly(to, _x, _y));
        Forward(span, from, to, Segment.FromLine(Place(frame, first.X, first.Y), Place(frame, last.X, last.Y)));
    }

    private void Forward(MotionSpan span, long from, long to, Segment path)
    {
        var traced = new TraceSpan(span[from].Seconds, span[to].Seconds, to - from + 1, path, IsCutting(span.Outputs)) { FollowingMm = 0.0, Outputs = span.Outputs };
        foreach (var judge in judges) judge.Add(traced);
        Motors?.AddSpan(traced.Cutting);
        Places?.Add(traced);
    }

    /// <summary>Forwards an arc to the judges. Unequal axis scales make it an ellipse, which is forwarded as chords within a twentieth of a count; no post of
    /// this program writes such an arc.</summary>
    private void ForwardArc((double X, double Y, double Z) frame, MotionSpan span, ArcCourse arc)
    {
        var (radiusX, radiusY) = (profile.Scale.X.ToMillimetres(arc.RadiusX), profile.Scale.Y.ToMillimetres(arc.RadiusY));
        var radius = Math.Max(Math.Abs(radiusX), Math.Abs(radiusY));
        if (Math.Abs(Math.Abs(radiusX) - Math.Abs(radiusY)) <= ScaleTolerance * radius)
        {
            var centre = Place(frame, arc.CentreX, arc.CentreY);
            Forward(span, 0, span.Count - 1, Segment.FromArc(Unmirrored(new ArcSegment(centre, radius, Angle.FromDegrees(arc.StartDegrees), Angle.FromDegrees(arc.SweepDegrees)), radiusX < 0.0, radiusY < 0.0)));
            return;
        }

        var chords = (long)Math.Min(span.Count - 1, Math.Ceiling(Math.Abs(arc.SweepDegrees) * (Math.PI / 180.0) / Math.Sqrt(8.0 * _count / 20.0 / radius)));
        for (var i = 0L; i < chords; i++) Forward(frame, span, i * (span.Count - 1) / chords, (i + 1) * (span.Count - 1) / chords);
    }

    /// <summary>The arc in drawing angles: an axis with a negative scale mirrors them.</summary>
    private static ArcSegment Unmirrored(ArcSegment arc, bool isXMirrored, bool isYMirrored)
    {
        if (isXMirrored) arc = arc with { Start = Angle.FromDegrees(180.0) - arc.Start, Sweep = -arc.Sweep };
        return isYMirrored ? arc with { Start = -arc.Start, Sweep = -arc.Sweep } : arc;
    }
}
