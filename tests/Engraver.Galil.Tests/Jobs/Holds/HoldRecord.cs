using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>Checks holds and interruptions by the simulator's record.</summary>
internal static class HoldRecord
{
    /// <summary>Samples that a tool may be on at a standstill in addition to its settle times: a few polls, a test of a buffer, the corner between two
    /// sequences.</summary>
    private const int SamplesAtRest = 250;

    /// <summary>From the report of the hold until the resume nothing moves and the tool is off.</summary>
    public static void AssertAtRestInHold(SimulatedBench bench, HoldingOperator operators)
    {
        var record = bench.Controller.Record.Snapshot();
        Assert.NotEmpty(operators.Held);
        foreach (var (from, to) in operators.Held)
        {
            Assert.InRange(to - from, 500, long.MaxValue);
            Assert.DoesNotContain(record, sample => sample.Sample > from && sample.Sample <= to);
            Assert.Equal(0, record.LastOrDefault(sample => sample.Sample <= from).Outputs);
        }
    }

    /// <summary>The tool is on without motion only for short times: its settle time before and after a cut, and a few polls.</summary>
    /// <param name="deadHosts">How often a host was lost: then it may be on until the watchdog trips.</param>
    public static void AssertNoBurnAtRest(SimulatedBench bench, MachineProfile profile, int deadHosts = 0)
    {
        const double Watchdog = 1200.0;
        var most = (2 * profile.ToolSettleSeconds * 1024) + SamplesAtRest;
        var record = bench.Controller.Record.Snapshot();
        var burns = record.Zip(record.Skip(1)).Where(pair => pair.First.Outputs != 0).Select(pair => pair.Second.Sample - pair.First.Sample).Where(samples => samples > most).ToList();
        Assert.InRange(burns.Count, 0, deadHosts);
        Assert.All(burns, samples => Assert.InRange(samples, 0, Watchdog));
    }

    /// <summary>The path with the tool on is at most <paramref name="most"/> counts longer than the drawing.</summary>
    public static void AssertNoRepeatedCut(SimulatedBench bench, MotionProgram program, double most)
    {
        var drawn = program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length));
        Assert.InRange(CutLength(bench.Controller.Record.Snapshot()), 0.0, (1.001 * drawn) + 5.0 + most);
    }

    /// <summary>Every point of the drawing was passed with the tool on, within a count, and nothing else was.</summary>
    public static void AssertEverythingWasCut(SimulatedBench bench, MotionProgram program)
    {
        var path = new EngravedPath(program);
        Assert.All(bench.Controller.Record.Snapshot().Where(sample => sample.Outputs != 0), sample => Assert.InRange(path.DistanceTo(sample.A, sample.B), 0, 2.5));
        var chords = Chords(bench.Controller.Record.Snapshot());
        foreach (var place in Places(program)) Assert.True(chords.IsNear(place, 2.5), $"{place} was never cut, to {Enumerable.Range(3, 100).FirstOrDefault(off => chords.IsNear(place, off))} counts");
    }

    /// <summary>Points every few counts along the drawing.</summary>
    private static IEnumerable<Point2D> Places(MotionProgram program)
    {
        const double Step = 7.0;
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var start = sequence.Start;
            foreach (var segment in sequence.Segments)
            {
                var course = Course(start, segment);
                for (var i = 0; i <= segment.Length / Step; i++) yield return course(Math.Min(1.0, i * Step / segment.Length));
                start = segment.End;
            }
        }
    }

    private static Func<double, Point2D> Course(CountsPoint start, VectorSegment segment)
    {
        var theta = segment.ThetaDegrees * Math.PI / 180.0;
        return segment.Kind == VectorSegmentKind.Line
            ? part => new Point2D(start.X + (part * ((double)segment.End.X - start.X)), start.Y + (part * ((double)segment.End.Y - start.Y)))
            : part => new Point2D(
                start.X + (segment.Radius * (Math.Cos(theta + (part * segment.DeltaDegrees * Math.PI / 180.0)) - Math.Cos(theta))),
                start.Y + (segment.Radius * (Math.Sin(theta + (part * segment.DeltaDegrees * Math.PI / 180.0)) - Math.Sin(theta))));
    }

    /// <summary>The paths between two samples with the tool on, indexed by squares of the plane.</summary>
    private static ChordGrid Chords(IReadOnlyList<MotionSample> record)
    {
        var grid = new ChordGrid();
        foreach (var (first, second) in record.Zip(record.Skip(1)))
        {
            if (first.Outputs != 0) grid.Add(new Point2D(first.A, first.B), new Point2D(second.A, second.B));
        }

        return grid;
    }

    private sealed class ChordGrid
    {
        private const double Side = 200.0;
        private readonly Dictionary<(int X, int Y), List<(Point2D From, Point2D To)>> _squares = [];

        public void Add(Point2D from, Point2D to)
        {
            var steps = 1 + (int)(from.DistanceTo(to) / Side * 2.0);
            var seen = new HashSet<(int X, int Y)>();
            for (var i = 0; i <= steps; i++)
            {
                var square = SquareOf(from + ((to - from) * ((double)i / steps)));
                if (!seen.Add(square)) continue;
                if (!_squares.TryGetValue(square, out var chords)) _squares[square] = chords = [];
                chords.Add((from, to));
            }
        }

        public bool IsNear(Point2D place, double distance)
        {
            var (x, y) = SquareOf(place);
            for (var i = x - 1; i <= x + 1; i++)
            {
                for (var j = y - 1; j <= y + 1; j++)
                {
                    if (_squares.TryGetValue((i, j), out var chords) && chords.Exists(chord => new LineSegment(chord.From, chord.To).DistanceTo(place) <= distance)) return true;
                }
            }

            return false;
        }

        private static (int X, int Y) SquareOf(Point2D place) => ((int)Math.Floor(place.X / Side), (int)Math.Floor(place.Y / Side));
    }

    public static double CutLength(IReadOnlyList<MotionSample> record) => record.Zip(record.Skip(1))
        .Where(pair => pair.First.Outputs != 0 && pair.Second.Outputs != 0)
        .Sum(pair => Math.Sqrt(Math.Pow(pair.Second.A - pair.First.A, 2) + Math.Pow(pair.Second.B - pair.First.B, 2)));
}
