using Engraver.Core.Machines;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>Programs for a tool that is moved by the Z axis, written by hand, and checks by the simulator's record, in which the tool cuts when it is below the
/// retract height.</summary>
internal static class HeightBench
{
    public const int Clearance = 3200;
    public const int Retract = 800;

    public static MachineProfile Profile { get; } = MachineProfile.Default with
    {
        Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) },
        Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, PlungeMmPerMinute = 240.0 },
        Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.5 },
    };

    /// <summary>A level line followed by an arc; a slope of two lines in three axes, a vertical piece, a level one and a slope up again; and a level line: 9
    /// segments in three strokes far from each other.</summary>
    public static MotionProgram Part(MachineProfile? profile = null, MotionStyle style = MotionStyle.Continuous) => new(profile ?? Profile, default, Strokes(style)) { Finish = default(CountsPoint), Style = style };

    private static IReadOnlyList<MotionStroke> Strokes(MotionStyle style) =>
    [
        Stroke(0, style, new(5000, 0, -400), Line(new(5000, 0, -400), new(25000, 0, -400)), new VectorSegment(VectorSegmentKind.Arc, new(25000, 12000, -400), 6000, 270, 180, 1, 6000 * Math.PI), Line(new(25000, 12000, -400), new(9000, 12000, -400))),
        new MotionStroke(1, new(5000, 30000, -400),
        [
            .. Stroke(1, style, new(5000, 30000, -400), Line(new(5000, 30000, -400), new(15000, 30000, -1200)), Line(new(15000, 30000, -1200), new(25000, 30000, -2400))).Sequences,
            .. Stroke(1, style, new(25000, 30000, -2400), Line(new(25000, 30000, -2400), new(25000, 30000, -4400))).Sequences,
            .. Stroke(1, style, new(25000, 30000, -4400), Line(new(25000, 30000, -4400), new(25000, 45000, -4400))).Sequences,
            .. Stroke(1, style, new(25000, 45000, -4400), Line(new(25000, 45000, -4400), new(10000, 48000, -400))).Sequences,
        ]),
        Stroke(2, style, new(5000, 60000, -2000), Line(new(5000, 60000, -2000), new(30000, 60000, -2000))),
    ];

    /// <summary>A line whose ends may have any height.</summary>
    public static VectorSegment Line(CountsPoint from, CountsPoint to) => new(VectorSegmentKind.Line, to, 0, 0, 0, 0, Length(to - from));

    private static MotionStroke Stroke(int index, MotionStyle style, CountsPoint start, params VectorSegment[] segments)
    {
        var isSlope = segments.Select(segment => segment.End.Z).Append(start.Z).Distinct().Count() > 1;
        if (style == MotionStyle.Continuous) return new MotionStroke(index, start, [new VectorSequence(start, 20000, segments) { ChangesHeight = isSlope }]);
        var sequences = new List<VectorSequence>();
        foreach (var segment in segments)
        {
            var from = sequences.Count == 0 ? start : sequences[^1].End;
            sequences.Add(new VectorSequence(from, 20000, [segment]) { ChangesHeight = segment.End.Z != from.Z });
        }

        return new MotionStroke(index, start, sequences);
    }

    /// <summary>Every sample below the retract height is on the drawing or, during a vertical move of the tool, vertically above a point of it; and every point
    /// of the drawing was passed. Both to 2.5 counts in X, Y and Z.</summary>
    /// <param name="most">Counts of it that may have been cut twice.</param>
    public static void AssertCut(SimulatedBench bench, MotionProgram program, double most = 0.0)
    {
        var pieces = Pieces(program);
        var record = bench.Controller.Record.Snapshot();
        Assert.All(record.Zip(record.Skip(1)).Where(IsDeep), pair => Assert.True(
            pieces.Any(piece => piece.DistanceTo(pair.Second.A, pair.Second.B, pair.Second.C) <= 2.5 || (IsUpright(pair) && piece.IsUnder(pair.Second))),
            $"{pair.Second.A},{pair.Second.B},{pair.Second.C} at sample {pair.Second.Sample} lies beside the drawing"));
        var passed = new PassedPlaces(record);
        foreach (var (x, y, z) in pieces.SelectMany(piece => piece.Places())) Assert.True(passed.Has(x, y, z, 2.5), $"{x:0},{y:0},{z:0} was never cut, to {Enumerable.Range(3, 100).FirstOrDefault(off => passed.Has(x, y, z, off))} counts");
        var cut = record.Zip(record.Skip(1)).Where(pair => IsDeep(pair) && !IsUpright(pair)).Sum(pair => Length(Place(pair.Second) - Place(pair.First)));
        Assert.InRange(cut, 0.0, (1.001 * program.Strokes.Sum(stroke => stroke.Sequences.Sum(sequence => sequence.Length))) + 20.0 + most);
    }

    /// <summary>Above the drawing the tool moved down at most at the plunge feed (3.2 counts a sample); the spindle turned whenever it was in the
    /// work.</summary>
    public static void AssertGentle(SimulatedBench bench, MotionProgram program)
    {
        var record = bench.Controller.Record.Snapshot();
        var pieces = Pieces(program);
        var plunges = record.Zip(record.Skip(1)).Where(pair => IsDeep(pair) && IsUpright(pair) && pair.Second.C < pair.First.C && !pieces.Any(piece => piece.DistanceTo(pair.Second.A, pair.Second.B, pair.Second.C) <= 2.5)).ToList();
        Assert.NotEmpty(plunges);
        Assert.All(plunges, pair => Assert.InRange(pair.First.C - pair.Second.C, 0, 4 * (pair.Second.Sample - pair.First.Sample)));
        Assert.All(record.Where(sample => sample.C < 0), sample => Assert.Equal(4, sample.Outputs));
    }

    /// <summary>During the hold the tool was at clearance height or above, and nothing moved.</summary>
    public static void AssertStoodUp(SimulatedBench bench, HoldingOperator operators)
    {
        var record = bench.Controller.Record.Snapshot();
        Assert.NotEmpty(operators.Held);
        foreach (var (from, to) in operators.Held)
        {
            Assert.InRange(to - from, 500, long.MaxValue);
            Assert.InRange(record.Last(sample => sample.Sample <= to).C, Clearance, int.MaxValue);
            Assert.DoesNotContain(record.Zip(record.Skip(1)), pair => pair.Second.Sample > from && pair.Second.Sample <= to && Place(pair.First) != Place(pair.Second));
        }
    }

    private static bool IsDeep((MotionSample First, MotionSample Second) pair) => pair.First.C < Retract && pair.Second.C < Retract && (pair.First.A, pair.First.B) is not (0, 0);

    private static bool IsUpright((MotionSample First, MotionSample Second) pair) => (pair.First.A, pair.First.B) == (pair.Second.A, pair.Second.B);

    private static CountsPoint Place(MotionSample sample) => new(sample.A, sample.B, sample.C);

    private static double Length(CountsPoint way) => double.Hypot(double.Hypot(way.X, way.Y), way.Z);

    private static List<Piece> Pieces(MotionProgram program)
    {
        var pieces = new List<Piece>();
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var from = sequence.Start;
            foreach (var segment in sequence.Segments)
            {
                pieces.AddRange(segment.Kind == VectorSegmentKind.Line ? [new Piece(from.X, from.Y, from.Z, segment.End.X, segment.End.Y, segment.End.Z)] : Chords(from, segment));
                from = segment.End;
            }
        }

        return pieces;
    }

    /// <summary>Chords with a distance of less than a tenth of a count from their arc.</summary>
    private static IEnumerable<Piece> Chords(CountsPoint from, VectorSegment arc)
    {
        var (theta, sweep) = (arc.ThetaDegrees * Math.PI / 180.0, arc.DeltaDegrees * Math.PI / 180.0);
        var count = 1 + (int)(Math.Abs(sweep) / Math.Sqrt(0.8 / arc.Radius));
        (double X, double Y) At(int i) => (from.X + (arc.Radius * (Math.Cos(theta + (sweep * i / count)) - Math.Cos(theta))), from.Y + (arc.Radius * (Math.Sin(theta + (sweep * i / count)) - Math.Sin(theta))));
        for (var i = 0; i < count; i++) yield return new Piece(At(i).X, At(i).Y, from.Z, At(i + 1).X, At(i + 1).Y, from.Z);
    }

    private readonly record struct Piece(double X, double Y, double Z, double ToX, double ToY, double ToZ)
    {
        private double Long => double.Hypot(double.Hypot(ToX - X, ToY - Y), ToZ - Z);

        public double DistanceTo(double x, double y, double z)
        {
            var foot = Math.Clamp((((x - X) * (ToX - X)) + ((y - Y) * (ToY - Y)) + ((z - Z) * (ToZ - Z))) / (Long * Long), 0.0, 1.0);
            return double.Hypot(double.Hypot(x - X - (foot * (ToX - X)), y - Y - (foot * (ToY - Y))), z - Z - (foot * (ToZ - Z)));
        }

        /// <summary>The point is on the piece or vertically above a point of it.</summary>
        public bool IsUnder(MotionSample sample)
        {
            var plan = ((ToX - X) * (ToX - X)) + ((ToY - Y) * (ToY - Y));
            var foot = plan == 0.0 ? 0.0 : Math.Clamp((((sample.A - X) * (ToX - X)) + ((sample.B - Y) * (ToY - Y))) / plan, 0.0, 1.0);
            var about = plan == 0.0 ? 1.0 : 2.5 / Math.Sqrt(plan); // for a steep piece the lowest height within this distance
            var lowest = Math.Min(Z + (Math.Max(0.0, foot - about) * (ToZ - Z)), Z + (Math.Min(1.0, foot + about) * (ToZ - Z)));
            return double.Hypot(sample.A - X - (foot * (ToX - X)), sample.B - Y - (foot * (ToY - Y))) <= 2.5 && sample.C >= lowest - 2.5;
        }

        public IEnumerable<(double X, double Y, double Z)> Places()
        {
            for (var i = 0; i <= Long / 7.0; i++)
            {
                var part = Math.Min(1.0, i * 7.0 / Long);
                yield return (X + (part * (ToX - X)), Y + (part * (ToY - Y)), Z + (part * (ToZ - Z)));
            }
        }
    }

    /// <summary>The paths between two samples in the work, indexed by squares of the plane.</summary>
    private sealed class PassedPlaces
    {
        private const double Side = 200.0;
        private readonly Dictionary<(int X, int Y), List<Piece>> _squares = [];

        public PassedPlaces(IReadOnlyList<MotionSample> record)
        {
            foreach (var (first, second) in record.Zip(record.Skip(1)).Where(IsDeep))
            {
                var way = new Piece(first.A, first.B, first.C, second.A, second.B, second.C);
                if (Place(first) == Place(second)) continue;
                foreach (var square in way.Places().Select(place => (Square(place.X), Square(place.Y))).Append((Square(second.A), Square(second.B))).Distinct())
                {
                    if (!_squares.TryGetValue(square, out var ways)) _squares[square] = ways = [];
                    ways.Add(way);
                }
            }
        }

        public bool Has(double x, double y, double z, double off)
        {
            for (var i = Square(x) - 1; i <= Square(x) + 1; i++)
            {
                for (var j = Square(y) - 1; j <= Square(y) + 1; j++)
                {
                    if (_squares.TryGetValue((i, j), out var ways) && ways.Exists(way => way.DistanceTo(x, y, z) <= off)) return true;
                }
            }

            return false;
        }

        private static int Square(double counts) => (int)Math.Floor(counts / Side);
    }
}
