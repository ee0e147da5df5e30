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
