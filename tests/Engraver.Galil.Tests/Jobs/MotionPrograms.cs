using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Motion programs for jobs, written by hand so that they are independent of the generator.</summary>
internal static class MotionPrograms
{
    /// <summary>The paper's Table 3 drawing at 100 counts/mm (galil-dmc.md EX5), with a stop at its two sharp corners; 4 segments, ends at 5000,5000.</summary>
    public static MotionProgram Paper => One(
        Sequence(new(5000, 5000), Line(15000, 5000, 0, 10000)),
        Sequence(new(15000, 5000), Line(15000, 15000, 1, 10000), Arc(5000, 15000, 5000, 0, 180, 2), Line(5000, 5000, 3, 10000)));

    /// <summary>One line of <paramref name="counts"/> along X from 1000,0, after a rapid of 1000 counts.</summary>
    public static MotionProgram LongLine(int counts) => One(Sequence(new(1000, 0), Line(1000 + counts, 0, 0, counts)));

    /// <summary>A rapid to <paramref name="counts"/>,<paramref name="counts"/> and a short line there.</summary>
    public static MotionProgram LongRapid(int counts) => One(Sequence(new(counts, counts), Line(counts + 100, counts, 0, 100)));

    /// <summary>One sequence of <paramref name="count"/> half circles in a row, each from a multiple of 2 * radius to the next.</summary>
    public static MotionProgram ArcChain(int count, int radius) => One(Sequence(
        new(0, 0), [.. Enumerable.Range(1, count).Select(i => Arc(i * 2 * radius, 0, radius, 180, i % 2 == 0 ? 180 : -180, i - 1))]));

    /// <summary>One sequence of <paramref name="count"/> short lines: a gentle zigzag of <paramref name="step"/> counts a piece.</summary>
    public static MotionProgram ShortLines(int count, int step = 60) => One(Sequence(
        new(0, 0), [.. Enumerable.Range(1, count).Select(i => Line(i * step, i % 2, i - 1, Math.Sqrt((step * step) + 1)))]));

    /// <summary>One sequence of a full circle of radius 1500 followed by the same short lines.</summary>
    public static MotionProgram CircleAndShortLines(int count, int step = 60) => One(Sequence(
        new(0, 0), [Arc(0, 0, 1500, 180, 360, 0), .. Enumerable.Range(1, count).Select(i => Line(i * step, i % 2, i, Math.Sqrt((step * step) + 1)))]));

    /// <summary>Two strokes with a rapid between them.</summary>
    public static MotionProgram TwoStrokes => new(MachineProfile.Default, default, InColumns(
    [
        new MotionStroke(0, new(2000, 0), [Sequence(new(2000, 0), Line(4000, 0, 7, 2000))]),
        new MotionStroke(1, new(4000, 3000), [Sequence(new(4000, 3000), Line(2000, 3000, 3, 2000))]),
    ]));

    /// <summary>Strokes as the generator stores them, which are created again on each access.</summary>
    public static IReadOnlyList<MotionStroke> InColumns(IReadOnlyList<MotionStroke> strokes)
    {
        var columns = new VectorColumns(strokes.Sum(stroke => stroke.SegmentCount));
        foreach (var stroke in strokes)
        {
            foreach (var sequence in stroke.Sequences) columns.Append(sequence.Speed, sequence.AccelerationOn(MachineProfile.Default), sequence.Segments, sequence.ChangesHeight, sequence.Feed);
            Assert.True(columns.EndStroke(stroke.Index, stroke.Start));
        }

        return columns.Strokes();
    }

    public static VectorSegment Line(long x, long y, int entity, double length) => new(VectorSegmentKind.Line, new(x, y), 0, 0, 0, entity, length);

    private static VectorSegment Arc(int x, int y, int radius, double theta, double delta, int entity) =>
        new(VectorSegmentKind.Arc, new(x, y), radius, theta, delta, entity, radius * Math.Abs(delta) * Math.PI / 180);

    private static VectorSequence Sequence(CountsPoint start, params VectorSegment[] segments) => new(start, 20000, segments);

    private static MotionProgram One(params VectorSequence[] sequences) => new(MachineProfile.Default, default, InColumns([new MotionStroke(0, sequences[0].Start, sequences)]));
}
