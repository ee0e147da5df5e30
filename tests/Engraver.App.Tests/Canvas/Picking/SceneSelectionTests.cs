using Engraver.App.Canvas.Picking;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.App.Tests.Canvas.Picking;

public class SceneSelectionTests
{
    private static readonly Drawing s_drawing = RandomDrawings.Of(seed: 7, count: 300);
    private static readonly CanvasScene s_scene = CanvasScene.From(s_drawing);
    private static readonly Gen<Point2D> s_places = from x in Gen.Choose(-5000, 105_000) from y in Gen.Choose(-5000, 105_000) select new Point2D(x / 1000.0, y / 1000.0);

    [Property]
    public Property The_nearest_entity_is_that_of_looking_at_all() =>
        Prop.ForAll(s_places.ToArbitrary(), Gen.Elements(0.05, 1.0, 30.0).ToArbitrary(), (place, within) =>
            ScenePick.Nearest(s_scene, place, within) == DrawingPick.Nearest(s_drawing, place, within));

    [Property]
    public Property Windows_and_crossings_are_those_of_looking_at_all() =>
        Prop.ForAll(s_places.ToArbitrary(), s_places.ToArbitrary(), (a, b) =>
        {
            var box = Bounds2D.FromCorners(a, b);
            return SceneSelection.Inside(s_scene, box).SequenceEqual(DrawingPick.Inside(s_drawing, box)) && SceneSelection.Touching(s_scene, box).SequenceEqual(DrawingPick.Touching(s_drawing, box));
        });

    [Fact]
    public void A_window_takes_what_lies_inside_and_a_crossing_what_it_touches()
    {
        var drawing = new DrawingBuilder().Line(1.0, 1.0, 2.0, 2.0).Line(1.0, 1.0, 20.0, 2.0).Circle(5.0, 5.0, 50.0).Square(3.0, 3.0, 1.0).Build();
        var scene = CanvasScene.From(drawing);
        var box = new Bounds2D(0.0, 0.0, 10.0, 10.0);

        Assert.Equal([0, 3], SceneSelection.Inside(scene, box));
        Assert.Equal([0, 1, 3], SceneSelection.Touching(scene, box));
        Assert.Equal([0, 3], SceneSelection.Inside(scene, new Bounds2D(1.0, 1.0, 4.0, 4.0)));
        Assert.Empty(SceneSelection.Inside(scene, new Bounds2D(3.0, 3.0, 4.0, 3.9)));
    }

    [Fact]
    public void Of_two_in_one_place_the_one_drawn_last_is_picked_and_all_are_found_for_cycling()
    {
        var scene = CanvasScene.From(new DrawingBuilder().Line(0.0, 0.0, 10.0, 0.0).Line(0.0, 0.0, 10.0, 0.0).Line(0.0, 3.0, 10.0, 3.0).Build());

        Assert.Equal(1, ScenePick.Nearest(scene, new Point2D(5.0, 0.1), 1.0));
        Assert.Equal([0, 1], ScenePick.All(scene, new Point2D(5.0, 0.1), 1.0));
        Assert.Null(ScenePick.Nearest(scene, new Point2D(5.0, 1.5), 1.0));
    }
}
