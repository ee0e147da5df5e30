using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Tests.Drawings;

public class DrawingScaleTests
{
    private static readonly DrawingScale s_inches = new(25.4);

    [Fact]
    public void Lengths_points_and_boxes_go_to_millimetres_and_back()
    {
        Assert.Equal((50.8, 2.0), (s_inches.ToMillimetres(2.0), s_inches.ToDrawing(50.8)));
        Assert.Equal(new Point2D(25.4, -50.8), s_inches.ToMillimetres(new Point2D(1.0, -2.0)));
        Assert.Equal(new Point2D(1.0, -2.0), s_inches.ToDrawing(new Point2D(25.4, -50.8)));
        Assert.Equal(new Bounds2D(1.0, -2.0, 2.0, 4.0), s_inches.ToDrawing(s_inches.ToMillimetres(new Bounds2D(1.0, -2.0, 2.0, 4.0))));
    }

    [Fact]
    public void An_arc_keeps_its_angles()
    {
        var arc = new ArcSegment(new Point2D(25.4, 0.0), 50.8, Angle.FromDegrees(10.0), Angle.FromDegrees(-90.0));
        Assert.Equal(arc with { Centre = new Point2D(1.0, 0.0), Radius = 2.0 }, s_inches.ToDrawing(Segment.FromArc(arc)).Arc);
    }

    [Fact]
    public void A_drawing_has_the_scale_of_its_unit()
    {
        Assert.Equal(s_inches, Drawing.Empty("new", LengthUnits.ChosenFrom(1)!, new Layer("0", On: true, Frozen: false, Plot: true)).Scale);
        Assert.Equal((LengthUnit.Chosen, "INSUNITS"), (LengthUnits.ChosenFrom(1)!.Source, LengthUnits.FromInsUnits(1)!.Source));
        Assert.Null(LengthUnits.ChosenFrom(0));
    }
}
