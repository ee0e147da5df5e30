using System.Numerics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Documents;

/// <summary>A drawing with every type of curve, placed by the settings.</summary>
public sealed class PlacedDrawingTests : IDisposable
{
    private const double Inch = 25.4;

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory();

    public void Dispose() => _folder.Delete(recursive: true);

    /// <summary>The order is scale, mirror, rotate, move; here with complex numbers, independent of the maps of the program.</summary>
    [Theory]
    [InlineData(MirrorAxis.None)]
    [InlineData(MirrorAxis.X)]
    [InlineData(MirrorAxis.Y)]
    public void Every_curve_text_and_point_is_where_the_formula_has_it(MirrorAxis mirror)
    {
        var settings = new DrawingSettings { Cut = CutChoice.Text, Placement = new DrawingPlacement { Scale = 2.5, Mirror = mirror, Rotation = Angle.FromDegrees(35.0), Move = new Vector2D(11.0, -7.0) } };
        var (drawn, placed) = (Open(settings with { Placement = DrawingPlacement.None }), Open(settings));
        var (before, after) = (Segments(drawn, settings), Segments(placed, settings));

        Assert.Equal(Enum.GetValues<SegmentKind>().Order(), before.Select(one => one.Kind).Distinct().Order());
        Assert.Equal(before.Select(one => one.Kind), after.Select(one => one.Kind));
        for (var i = 0; i < before.Count; i++)
        {
            for (var at = 0.0; at <= 1.0; at += 0.125)
            {
                var expected = Expected(before[i].PointAt(at));
                var distance = before[i].Kind == SegmentKind.Circle ? after[i].DistanceTo(expected) : (after[i].PointAt(at) - expected).Length; // a circle of the table starts at its right
                Assert.True(distance < 1e-9, $"{i} {before[i].Kind} {at}");
            }
        }

        Assert.Equal(drawn.Points.Select(point => Expected(new Point2D(point.Position.X * Inch, point.Position.Y * Inch))), placed.Points.Select(point => new Point2D(point.Position.X * Inch, point.Position.Y * Inch)), (one, other) => one.IsNear(other, 1e-9));
        Assert.Equal(Heights(drawn).Select(z => z * 2.5), Heights(placed));
        Assert.Equal(Enumerable.Range(0, drawn.Entities.Count).Select(drawn.SourceOf), Enumerable.Range(0, placed.Entities.Count).Select(placed.SourceOf));

        Point2D Expected(Point2D millimetres)
        {
            var z = new Complex(millimetres.X, millimetres.Y) * 2.5;
            z = mirror switch { MirrorAxis.X => Complex.Conjugate(z), MirrorAxis.Y => -Complex.Conjugate(z), _ => z };
            z = (z * Complex.FromPolarCoordinates(1.0, 35.0 * Math.PI / 180.0)) + new Complex(11.0, -7.0);
            return new Point2D(z.Real, z.Imaginary);
        }
    }

    /// <summary>Lower left corner and centre of what is cut, a rotation by a right angle, and 0.06 mm that are missing between two points.</summary>
    [Fact]
    public void A_drawing_is_placed_on_its_blank_or_aligned_with_two_points()
    {
        var placement = new DrawingPlacement { Scale = 0.5, Rotation = Angle.FromDegrees(90.0) };
        var corner = BoundsOf(placement with { Place = BlankPlace.Corner, Move = new Vector2D(3.0, 4.0) });
        Assert.Equal((3.0, 4.0), (Math.Round(corner.MinX, 9), Math.Round(corner.MinY, 9)));
        var centre = BoundsOf(placement with { Place = BlankPlace.Centre, Blank = new Vector2D(500.0, 300.0) });
        Assert.Equal((250.0, 150.0), (Math.Round((centre.MinX + centre.MaxX) / 2.0, 9), Math.Round((centre.MinY + centre.MaxY) / 2.0, 9)));
        Assert.Equal((corner.Width, corner.Height), (centre.Width, centre.Height), (one, other) => Math.Abs(one.Width - other.Width) < 1e-9 && Math.Abs(one.Height - other.Height) < 1e-9);

        var aligned = new DrawingPlacement { Align = new PointPair(new(10.0, 0.0), new(30.0, 0.0)), To = new PointPair(new(5.0, 5.0), new(5.0, 25.06)) };
        var map = aligned.MapIn(DrawingScale.Millimetres, Bounds2D.Empty);
        Assert.Equal(0.06, aligned.AlignError, 9);
        Assert.True(map.Apply(new Point2D(10.0, 0.0)).IsNear(new Point2D(5.0, 5.03), 1e-9) && map.Apply(new Point2D(30.0, 0.0)).IsNear(new Point2D(5.0, 25.03), 1e-9));
        Assert.Equal(1.0, map.Scale);

        Bounds2D BoundsOf(DrawingPlacement place) => Segments(Open(new DrawingSettings { Placement = place }), new DrawingSettings()).Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
    }

    /// <summary>A point of the front and the same point of the turned blank are at the same distance from opposite edges.</summary>
    [Theory]
    [InlineData(MirrorAxis.X)]
    [InlineData(MirrorAxis.Y)]
    public void The_back_fits_the_front_also_in_a_grid(MirrorAxis axis)
    {
        var front = new DrawingPlacement { Rotation = Angle.FromDegrees(20.0), Place = BlankPlace.Centre, Blank = new Vector2D(400.0, 300.0) };
        var back = front with { Back = axis };
        var box = new Bounds2D(-10.0, -20.0, 30.0, 50.0);
        for (var index = 0; index < 6; index++)
        {
            var (one, other) = (At(front, index), At(back, index));
            Assert.True(other.IsNear(axis == MirrorAxis.X ? new Point2D(one.X, 300.0 - one.Y) : new Point2D(400.0 - one.X, one.Y), 1e-9), $"{index}");
        }

        Assert.Equal((200.0, 150.0), (Enumerable.Range(0, 6).Average(index => At(front with { Rotation = Angle.Zero }, index).X), Enumerable.Range(0, 6).Average(index => At(front with { Rotation = Angle.Zero }, index).Y)));

        Point2D At(DrawingPlacement placement, int index) =>
            placement.MapIn(DrawingScale.Millimetres, box).Apply(new Point2D(10.0, 15.0)) + new PlateGrid(3, 2, new Vector2D(100.0, 80.0)) { Stagger = new Vector2D(0.0, 0.0), Placement = placement }.OffsetOf(index);
    }

    [Fact]
    public void A_drawing_without_curves_has_no_place_on_a_blank()
    {
        var placed = Open(new DrawingSettings { Layers = ["none"], Placement = new DrawingPlacement { Place = BlankPlace.Corner } });
        Assert.Equal(PlacementRules.NothingToPlace, Assert.Single(placed.Diagnostics).Rule);
    }

    [Fact]
    public void A_path_that_leaves_the_blank_is_reported()
    {
        var settings = new DrawingSettings { Placement = new DrawingPlacement { Place = BlankPlace.Corner, Blank = new Vector2D(1000.0, 10.0) } };
        var height = Segments(Open(settings), settings).Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds)).MaxY;
        var finding = Assert.Single(JobPreparation.To<CheckedJob>(Open(settings), settings).Findings, found => found.Rule == PlacementRules.OutsideBlank);
        Assert.Equal(height - 10.0, double.Parse(finding.Facts[0], System.Globalization.CultureInfo.InvariantCulture), 2);
    }

    [Fact]
    public void Without_a_placement_the_drawing_is_the_one_of_the_file()
    {
        var drawing = Open(new DrawingSettings());

        Assert.Equal((DrawingPlacement.None, Transform2D.Identity), (drawing.Placement, drawing.PlacementMap));
        Assert.DoesNotContain(SettingValues.Of(new DrawingSettings()).Keys, key => key is "scale" or "mirror" or "rotate" or "move");
    }

    [Fact]
    public void A_drawing_that_cannot_be_placed_is_not_cut()
    {
        var placed = Open(new DrawingSettings { Placement = new DrawingPlacement { Move = new Vector2D(1e103, 0.0) } });

        Assert.Equal(PlacementRules.OutOfRange, Assert.Single(placed.Diagnostics).Rule);
        Assert.True(DrawingFile.IsUnreadable(placed));
    }

    [Fact]
    public void A_job_with_another_placement_is_another_job()
    {
        var settings = new DrawingSettings { Placement = new DrawingPlacement { Scale = 0.5, Rotation = Angle.FromDegrees(90.0) } };
        var drawing = Open(settings);
        var (one, other) = (JobIdentity.Of(drawing, settings, "galil", () => null), SettingValues.Of(settings with { Placement = new DrawingPlacement { Scale = 0.5, Mirror = MirrorAxis.X } }));

        Assert.Equal(["mirror", "rotate"], one.Differences(one.Drawing, other, one.Profile, []));
        Assert.Empty(one.Differences(one.Drawing, SettingValues.Of(new DrawingSettings().AsOpened(drawing)), one.Profile, []));
    }

    private Drawing Open(DrawingSettings settings)
    {
        var path = Path.Combine(_folder.FullName, "all.dxf");
        if (!File.Exists(path)) File.WriteAllBytes(path, EveryType());
        return DrawingFile.Open(path, settings, CancellationToken.None);
    }

    private static IReadOnlyList<Segment> Segments(Drawing drawing, DrawingSettings settings) => JobPreparation.To<AnalysedJob>(drawing, settings).Analysed.ToSegments();

    /// <summary>Heights of the first line, of a circle, an ellipse, a text and a point.</summary>
    private static IEnumerable<double> Heights(Drawing drawing) =>
        [drawing.Parts[0].C, drawing.Parts[0].F, drawing.Parts[1].C, drawing.Curves[0].StartZ, drawing.Texts[0].Position.Z, drawing.Texts[0].Inserts.Apply(new Vector3D(0.0, 0.0, 3.0)).Z, drawing.Points[0].Position.Z];

    /// <summary>In inches, with an extrusion against Z, a bulge and a mirrored block.</summary>
    private static byte[] EveryType() => new DxfText().Header("AC1015", 1)
        .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 0.0), (20, 0.0), (0, "ARC"), (10, 1.0), (20, 0.0), (40, 2.0), (50, 0.0), (51, 70.0), (0, "ENDBLK"))
        .Section(
            "ENTITIES",
            (0, "LINE"), (10, 1.0), (20, 2.0), (30, 3.0), (11, 4.0), (21, -5.0), (31, 6.0),
            (0, "CIRCLE"), (10, 3.0), (20, 1.0), (30, 2.0), (40, 2.0),
            (0, "ARC"), (10, 5.0), (20, 5.0), (30, 1.0), (40, 3.0), (50, 20.0), (51, 110.0), (210, 0.0), (220, 0.0), (230, -1.0),
            (0, "LWPOLYLINE"), (90, 3), (70, 1), (38, 2.0), (10, 0.0), (20, 0.0), (42, 0.5), (10, 4.0), (20, 0.0), (10, 4.0), (20, 4.0), (42, -0.3),
            (0, "ELLIPSE"), (10, 2.0), (20, 3.0), (30, 1.0), (11, 4.0), (21, 1.0), (40, 0.4), (41, 0.3), (42, 4.0),
            (0, "SPLINE"), (70, 8), (71, 3), (72, 8), (73, 4), (74, 0), (40, 0.0), (40, 0.0), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (40, 1.0), (40, 1.0), (10, 0.0), (20, 0.0), (30, 0.0), (10, 1.0), (20, 3.0), (30, 1.0), (10, 4.0), (20, 3.0), (30, 2.0), (10, 5.0), (20, 0.0), (30, 0.0),
            (0, "INSERT"), (2, "B"), (10, 6.0), (20, 2.0), (41, -1.5), (42, 1.5), (50, 25.0),
            (0, "TEXT"), (10, 2.0), (20, 10.0), (30, 1.0), (40, 2.0), (50, 15.0), (1, "A7"),
            (0, "POINT"), (10, 4.0), (20, 9.0), (30, 2.0))
        .End().ToAscii();
}
