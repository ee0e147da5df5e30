using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.ArcRecovery;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Sequencing.ArcRecovery;

public class ArcRecoveryTests
{
    private const double MaxError = 0.01;

    private static readonly Arbitrary<(ArcSegment Arc, int Chords)> FlattenedArcs = (
        from x in Gen.Choose(-100, 100)
        from y in Gen.Choose(-100, 100)
        from radius in Gen.Choose(5, 500)
        from start in Gen.Choose(0, 359)
        from sweep in Gen.Choose(20, 340)
        from sign in Gen.Elements(1, -1)
        from finer in Gen.Choose(1, 4)
        let arc = new ArcSegment(new Point2D(x, y), radius / 10.0, Angle.FromDegrees(start), Angle.FromDegrees(sign * sweep))
        select (arc, Math.Max(5, finer * (int)Math.Ceiling(arc.Sweep.Abs().Radians / (2.0 * Math.Acos(1.0 - (0.8 * MaxError / arc.Radius))))))).ToArbitrary();

    [Property]
    public Property A_flattened_arc_comes_back_with_its_radius_and_its_ends() => Prop.ForAll(FlattenedArcs, flat =>
    {
        var points = Flatten(flat.Arc, flat.Chords);
        if (Rise(flat.Arc) < 3.0 * MaxError) return true;
        var table = Recover(Analysed(Polyline(points))).Table;
        if (table.Count != 1) return false;
        var arc = table[0].ToSegment();
        return arc.Kind == SegmentKind.Arc && arc.Start == points[0] && arc.End == points[^1]
            && Math.Abs(arc.Arc.Radius - flat.Arc.Radius) <= MaxError && Math.Abs((arc.Arc.Sweep - flat.Arc.Sweep).Degrees) < 1.0;
    });

    [Fact]
    public void A_flattened_circle_becomes_a_circle_in_its_own_direction()
    {
        var ring = Flatten(new ArcSegment(new Point2D(3, 4), 10, Angle.FromDegrees(17), -Angle.FullTurn), 120);
        ring[^1] = ring[0];

        var table = Recover(Analysed(Polyline(ring))).Table;

        Assert.Equal(SegmentKind.Circle, table[0].Kind);
        Assert.Equal(1, table.Count);
        Assert.Equal(10.0, table[0].Radius, 1e-9);
        Assert.Equal(-360.0, table[0].SweepDegrees);
    }

    /// <summary>Shuffled, every other one drawn backwards, ends rounded to a micrometre: the result of an export without polylines.</summary>
    [Fact]
    public void Separate_lines_that_meet_are_one_run()
    {
        var points = Flatten(new ArcSegment(new Point2D(0, 0), 20, Angle.FromDegrees(10), Angle.FromDegrees(150)), 60);
        var builder = new DrawingBuilder();
        foreach (var i in Enumerable.Range(0, 60).OrderBy(i => (i * 37) % 60))
        {
            var (from, to) = i % 2 == 0 ? (points[i], points[i + 1]) : (points[i + 1], points[i]);
            builder.Line(Math.Round(from.X, 6), Math.Round(from.Y, 6), Math.Round(to.X, 6), Math.Round(to.Y, 6));
        }

        var result = Recover(Analysed(builder));

        var note = Assert.Single(result.Arcs);
        Assert.Equal(60, note.Lines);
        Assert.Equal(20.0, Assert.Single(result.Table.ToSegments()).Arc.Radius, 1e-3);
    }

    [Fact]
    public void Rounded_corners_of_a_plate_become_arcs_and_its_sides_stay()
    {
        var points = new List<Point2D>();
        foreach (var (x, y, start) in new[] { (90.0, 40.0, 0.0), (10.0, 40.0, 90.0), (10.0, 10.0, 180.0), (90.0, 10.0, 270.0) })
        {
            points.AddRange(Flatten(new ArcSegment(new Point2D(x, y), 10, Angle.FromDegrees(start), Angle.FromDegrees(90)), 24));
        }

        points.Add(points[0]);
        var segments = Recover(Analysed(Polyline([.. points]))).Table.ToSegments();

        Assert.Equal(4, segments.Count(segment => segment.Kind == SegmentKind.Arc));
        Assert.Equal(4, segments.Count(segment => segment.Kind == SegmentKind.Line));
        Assert.All(segments.Where(segment => segment.Kind == SegmentKind.Arc), segment => Assert.Equal(10.0, segment.Arc.Radius, 1e-6));
    }

    [Theory]
    [InlineData(4)]
    [InlineData(6)]
    [InlineData(8)]
    [InlineData(10)]
    public void Polygons_stay_what_they_are_however_coarse_the_error(int corners)
    {
        var ring = Flatten(new ArcSegment(new Point2D(0, 0), 1, Angle.Zero, Angle.FullTurn), corners);
        ring[^1] = ring[0];
        var analysed = Analysed(Polyline(ring));

        Assert.Same(analysed, ArcRecoverer.Recover(analysed, 0.5).Table);
    }

    [Fact]
    public void Straight_lines_and_zigzags_stay()
    {
        var straight = Enumerable.Range(0, 50).Select(i => new Point2D(i * 0.7, i * 0.3)).ToArray();
        var zigzag = Enumerable.Range(0, 50).Select(i => new Point2D(i, 10.0 + ((i % 2) * 0.005))).ToArray();
        var bent = Enumerable.Range(0, 50).Select(i => new Point2D(i, 20.0 + (i * i * 1e-3) + ((i % 2) * 0.004))).ToArray();

        foreach (var points in new[] { straight, zigzag, bent }) Assert.Empty(Recover(Analysed(Polyline(points))).Arcs);
    }

    /// <summary>Random waves: lines and result are always within the error of each other, in both directions, by sampling that is independent of circle
    /// formulas.</summary>
    [Property]
    public Property Nothing_moves_farther_than_the_error() => Prop.ForAll(Gen.Choose(1, 1_000_000).ToArbitrary(), seed =>
    {
        var before = Analysed(Polyline(Wave(new System.Random(seed))));
        var result = Recover(before);
        var (drawn, cut) = (before.ToSegments(), result.Table.ToSegments());
        var worst = Math.Max(Farthest(drawn, cut), Farthest(cut, drawn));
        return (worst <= MaxError * 1.000001 && cut[0].Start == drawn[0].Start && cut[^1].End == drawn[^1].End).Label($"{worst} with {result.Arcs.Count} arcs");
    });

    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    public void Coordinates_with_few_decimals_still_make_an_arc(int decimals)
    {
        var points = Flatten(new ArcSegment(new Point2D(1, 2), 14.4, Angle.FromDegrees(41), Angle.FromDegrees(191)), 400);
        Point2D[] rounded = [.. points.Select(point => new Point2D(Math.Round(point.X, decimals), Math.Round(point.Y, decimals)))];

        Assert.InRange(Recover(Analysed(Polyline(rounded))).Table.Count, 1, 12);
    }

    [Property]
    public Property Doing_it_twice_changes_nothing() => Prop.ForAll(Gen.Choose(1, 1_000_000).ToArbitrary(), seed =>
    {
        var once = Recover(Analysed(Polyline(Wave(new System.Random(seed))))).Table;
        return ReferenceEquals(once, Recover(once).Table);
    });

    [Fact]
    public void Waves_do_give_arcs() => Assert.InRange(Enumerable.Range(1, 20).Sum(seed => Recover(Analysed(Polyline(Wave(new System.Random(seed))))).Arcs.Count), 40, 2000);

    [Fact]
    public void A_line_that_ends_on_a_vertex_keeps_its_joint()
    {
        var points = Flatten(new ArcSegment(new Point2D(0, 0), 20, Angle.Zero, Angle.FromDegrees(90)), 40);
        var builder = Polyline(points).Line(points[15].X, points[15].Y, 0, 0);

        var segments = Recover(Analysed(builder)).Table.ToSegments();

        Assert.Equal([points[15], points[40]], segments.Where(segment => segment.Kind == SegmentKind.Arc).Select(segment => segment.End));
    }

    /// <summary>Segments that cannot be part of an arc are not joined to contours; the result must be the same. Boxes and loose lines around the wave, some of
    /// them touching it.</summary>
    [Property(MaxTest = 20)]
    public Property What_lies_around_changes_no_arc() => Prop.ForAll(Gen.Choose(1, 1_000_000).ToArbitrary(), seed =>
    {
        var random = new System.Random(seed);
        var wave = Wave(random);
        Segment[] lines = [.. wave.Zip(wave.Skip(1), Segment.FromLine)];
        var around = Enumerable.Range(0, 60).Select(_ => new Point2D(3000.0 + random.Next(100), random.Next(100))).SelectMany(corner => new[]
        {
            Segment.FromLine(corner, corner + new Vector2D(3, 0)), Segment.FromLine(corner + new Vector2D(3, 4), corner), Segment.FromLine(corner, corner + new Vector2D(0, -5)),
        }).ToArray();

        var alone = Recover(Analysed(Loose(lines, random: null)));
        var among = Recover(Analysed(Loose([.. lines, .. around], random: null)));

        Assert.Equal(alone.Arcs.Select(note => (note.Lines, note.Deviation)), among.Arcs.Select(note => (note.Lines, note.Deviation)));
        Assert.Equal(alone.Arcs.Count, Recover(Analysed(Loose([.. lines, .. around], random))).Arcs.Count, tolerance: 3);
    });

    [Fact]
    public void A_thousand_loose_ends_in_one_place_come_to_an_end()
    {
        var star = Enumerable.Range(0, 1000).Select(i => Segment.FromLine(new Point2D(0, 0), new Point2D(0, 0) + Vector2D.FromPolar(5.0, Angle.FromDegrees(0.36 * i)))).ToArray();

        Assert.Empty(Recover(Analysed(Loose(star, random: null))).Arcs);
    }

    [Fact]
    public void Lines_at_different_heights_are_no_plane_arc()
    {
        var points = Flatten(new ArcSegment(new Point2D(0, 0), 20, Angle.Zero, Angle.FromDegrees(90)), 40);
        var builder = Polyline(points);
        var drawing = builder.Build();
        for (var i = 0; i < drawing.Parts.Count; i++) (drawing.Parts[i].C, drawing.Parts[i].F) = (i, i + 1);

        Assert.Empty(Recover(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default))).Arcs);
    }

    [Fact]
    public void Sequencing_says_what_it_replaced_and_where()
    {
        var drawing = Polyline(Flatten(new ArcSegment(new Point2D(0, 0), 20, Angle.Zero, Angle.FromDegrees(90)), 40)).Build();
        var analysed = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default));

        var result = Sequencer.Sequence(analysed, drawing, UsualOptions.Sequencing with { ArcTolerance = MaxError });

        var found = Assert.Single(result.Diagnostics, diagnostic => diagnostic.Rule == SequencingRules.ArcRecovered);
        Assert.Equal((10, "A1", Severity.Info), ((int)found.Source.Line, found.Source.Handle, found.Severity));
        Assert.Equal(0, result.DuplicatesRemoved);
        Assert.Equal(1, result.Segments);
        Assert.Equal(40, Sequencer.Sequence(analysed, drawing, UsualOptions.Sequencing).Segments);
    }

    private static ArcRecoveryResult Recover(EntityTable analysed) => ArcRecoverer.Recover(analysed, MaxError);

    private static double Rise(in ArcSegment arc) => arc.Radius * (1.0 - Math.Cos(Math.Min(Math.PI, arc.Sweep.Abs().Radians / 2.0)));

    private static EntityTable Analysed(DrawingBuilder builder) => ArcAnalysis.Analyse(EntityTableBuilder.Build(builder.Build(), LayerSelection.Default));

    private static DrawingBuilder Polyline(Point2D[] points) => new DrawingBuilder().Curve(CurveType.LwPolyline, [.. points.Zip(points.Skip(1), Segment.FromLine)]);

    private static DrawingBuilder Loose(Segment[] lines, System.Random? random)
    {
        var builder = new DrawingBuilder();
        if (random is not null) random.Shuffle(lines);
        foreach (var line in lines) builder.Line(line.Start.X, line.Start.Y, line.End.X, line.End.Y);
        return builder;
    }

    private static Point2D[] Flatten(ArcSegment arc, int chords) => [.. Enumerable.Range(0, chords + 1).Select(i => arc.PointAt((double)i / chords))];

    /// <summary>A path of changing curvature, flattened in steps of uneven length, with a corner now and then.</summary>
    private static Point2D[] Wave(System.Random random)
    {
        var (points, place, direction, bend) = (new List<Point2D> { new(0, 0) }, new Point2D(0, 0), 0.0, 0.05);
        for (var i = 0; i < 200; i++)
        {
            var step = 0.2 + (0.4 * random.NextDouble());
            if (random.Next(25) == 0) bend = (random.NextDouble() - 0.5) * 0.5;
            if (random.Next(60) == 0) direction += 2.0;
            direction += bend * step;
            place += new Vector2D(Math.Cos(direction), Math.Sin(direction)) * step;
            points.Add(place + new Vector2D(1e-6 * random.NextDouble(), 1e-6 * random.NextDouble()));
        }

        return [.. points];
    }

    private static double Farthest(Segment[] from, Segment[] to) =>
        from.Max(segment => Enumerable.Range(0, 33).Max(i => to.Min(other => other.DistanceTo(segment.PointAt(i / 32.0)))));
}
