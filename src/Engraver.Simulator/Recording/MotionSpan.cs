using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>Samples of motion at constant speed in which nothing else happened, in closed form: samples are computed on demand and not stored.</summary>
public sealed class MotionSpan
{
    private readonly long _before;
    private readonly MotionSample _end;
    private readonly SteadyCourse[] _courses;

    /// <param name="before">The sample before the first sample of the span.</param>
    /// <param name="samples">Number of samples, at least one.</param>
    /// <param name="end">The last row; axes without a course have its positions during the whole span.</param>
    internal MotionSpan(long before, long samples, MotionSample end, SteadyCourse[] courses)
    {
        _before = before;
        _end = end;
        _courses = courses;
        Count = samples;
    }

    /// <summary>Number of samples in the span.</summary>
    public long Count { get; }

    /// <summary>The outputs, constant over the span.</summary>
    public byte Outputs => _end.Outputs;

    public MotionSample First => this[0];

    public MotionSample Last => _end;

    /// <summary>One of its samples, counted from 0; equal to the result of single steps.</summary>
    public MotionSample this[long index]
    {
        get
        {
            Span<int> places = [_end.A, _end.B, _end.C, _end.D, 0, 0];
            foreach (var course in _courses) course.At(index + 1, places);
            return new MotionSample(_before + 1 + index, places[0], places[1], places[2], places[3], _end.Outputs);
        }
    }

    /// <summary>Positions of two axes at one of its samples, counts before rounding.</summary>
    /// <param name="x">An axis, from 0 for A.</param>
    /// <param name="y">Another axis.</param>
    public (double X, double Y) Exactly(long index, int x, int y)
    {
        Span<double> places = [_end.A, _end.B, _end.C, _end.D, 0, 0];
        foreach (var course in _courses) course.Exactly(index + 1, places);
        return (places[x], places[y]);
    }

    /// <summary>The arc on which two axes move from the first sample to the last, at most a quarter of an ellipse; null when they move on a straight line or
    /// are at rest.</summary>
    /// <param name="x">The axis of the cosine, from 0 for A.</param>
    /// <param name="y">The axis of the sine.</param>
    public ArcCourse? ArcOf(int x, int y)
    {
        foreach (var course in _courses)
        {
            if (course.ArcBetween(1, Count, x, y) is { } arc) return arc;
        }

        return null;
    }
}

/// <summary>Receives all entries of a record, in order of time, while the controller computes them.</summary>
public interface IMotionListener
{
    /// <summary>Called for a sample of motion, the start position of a motion, or a change of an output.</summary>
    void Add(in MotionSample sample);

    /// <summary>Called for a span of many samples at constant speed.</summary>
    void Add(MotionSpan span);
}

/// <summary>Axis positions at one sample: commanded positions in counts, for a stepper the position of its shaft, and the outputs 1 to 8 as a byte (bit 0 =
/// output 1).</summary>
/// <param name="Sample">Sample number since power up; its time is Sample times 1 ms nominal.</param>
public readonly record struct MotionSample(long Sample, int A, int B, int C, int D, byte Outputs)
{
    /// <summary>Nominal controller time in seconds.</summary>
    public double Seconds => Sample / 1000.0;

    /// <summary>Commanded minus motor position of the first four axes (_TE), counts; 0 in a span, where the motors follow without lag.</summary>
    public (int A, int B, int C, int D) Error { get; init; }

    /// <summary>The following error of an axis, counts; the index of A is 0.</summary>
    public int ErrorOf(int axis) => axis switch { 0 => Error.A, 1 => Error.B, 2 => Error.C, 3 => Error.D, _ => 0 };

    /// <summary>The position of an axis, counts; the index of A is 0.</summary>
    public int this[int axis] => axis switch { 0 => A, 1 => B, 2 => C, 3 => D, _ => 0 };
}
