using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Documents;

/// <summary>Starts and tabs at picked places, which are on the drawing of the file, where the drawing is placed or copied.</summary>
public class PickedPlacementTests
{
    private static readonly DrawingSettings s_settings = new()
    {
        Machine = new MachineProfile { Height = new HeightDrive(), Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) } },
        Operations = OperationFile.Parse("""
            { "version": "1.0", "tools": [{"number": 1, "diameter": 2}], "operations": [
              { "id": "cut", "kind": "profile", "side": "outside", "select": "rest", "tool": 1, "depth": 2, "start": {"at": [[0, 12]]}, "tabs": {"at": [[30, 10], [20, 0]], "width": 3, "height": 1} } ] }
            """),
    };

    [Fact]
    public void They_are_at_the_same_places_of_the_part_on_every_copy()
    {
        var first = PlateJob.Prepare(Part(), s_settings, MotionStyle.Continuous, new Plate(1, PlateValues.None, default));
        var second = PlateJob.Prepare(Part(), s_settings, MotionStyle.Continuous, new Plate(2, PlateValues.None, new Vector2D(60, -5)));

        Assert.Equal(2, TabsOf(first).Count);
        Assert.All(TabsOf(first).Zip(TabsOf(second)), pair => Assert.Equal(0.0, (pair.Second - pair.First - new Vector2D(60, -5)).Length, 6));
        Assert.Equal(0.0, (second.Toolpath.Strokes[0].Start - first.Toolpath.Strokes[0].Start - new Vector2D(60, -5)).Length, 6);
        Assert.Empty(second.Diagnostics);
    }

    [Fact]
    public void They_follow_the_placement_of_the_drawing_and_are_in_its_coordinates_when_it_is_saved()
    {
        var (drawing, settings) = (Part(), s_settings with { Placement = new DrawingPlacement { Mirror = MirrorAxis.Y, Rotation = Angle.FromDegrees(90), Move = new Vector2D(100, 7) } });
        var placed = PlacedDrawing.Try(drawing, settings, Transform2D.Identity).Placed!;
        var job = JobPreparation.Prepare(placed, settings, MotionStyle.Continuous);

        var expected = TabsOf(JobPreparation.Prepare(drawing, s_settings, MotionStyle.Continuous)).Select(placed.Placed).ToList();
        Assert.Equal(2, TabsOf(job).Count);
        Assert.All(TabsOf(job), tab => Assert.Contains(expected, place => place.DistanceTo(tab) < 1e-6));
        Assert.True(new Point2D(3, 4).DistanceTo(placed.Unplaced(placed.Placed(new Point2D(3, 4)))) < 1e-9);

        var saved = new DocumentState { Drawing = placed, Settings = settings }.WithPlacementSaved();
        Assert.Equal(TabsOf(job).Count, TabsOf(JobPreparation.Prepare(saved.Drawing!, saved.Settings, MotionStyle.Continuous)).Count);
        Assert.Equal(0.0, placed.Placed(new Point2D(30, 10)).DistanceTo(saved.Settings.Operations!.Operations[0].Tabs!.At[0]), 6);
    }

    private static Drawing Part() => new DrawingBuilder().Line(0, 0, 30, 0).Line(30, 0, 30, 20).Line(30, 20, 0, 20).Line(0, 20, 0, 0).Build();

    private static List<Point2D> TabsOf(PreparedJob job) => [.. job.Toolpath.Strokes.SelectMany(stroke => stroke.Moves).Where(move => move is { Role: StrokeRole.Tab, Segment.Length: > 0.0 }).Select(move => move.Segment.PointAt(0.5))];
}
