using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Numbers that are valid separately but have an invalid product: NaN must never leave the reader.</summary>
public class RangeTests
{
    /// <summary>The square of 1e-200 is zero: without a check the direction becomes NaN, and the search for a length with it never ends.</summary>
    [Fact]
    public void A_tiny_extrusion_is_a_direction_like_any_other()
    {
        (int, object)[] tiny = [(210, 0.0), (220, 0.0), (230, -1e-200)];
        var drawing = DxfReading.Entities([.. OddDrawings.Ellipse, .. tiny, .. OddDrawings.Arc, .. tiny]);
        var usual = DxfReading.Entities([.. OddDrawings.Ellipse, (230, -1.0), .. OddDrawings.Arc, (230, -1.0)]);

        Assert.Equal(DrawingSummary.From(usual).Bounds, DrawingSummary.From(drawing).Bounds);
        Assert.True(DrawingSummary.From(drawing).Length.Total > 10.0);
    }

    public static TheoryData<string, (int, object)[]> Overflowing => new()
    {
        { "ELLIPSE", [(0, "ELLIPSE"), (10, 0), (20, 0), (11, 1e99), (21, 0), (40, 1e99)] },
        { "LWPOLYLINE", [(0, "LWPOLYLINE"), (10, 0), (20, 0), (42, 1e100), (10, 1e100), (20, 0)] },
        { "HATCH", [(0, "HATCH"), (92, 2), (72, 1), (73, 1), (10, 0), (20, 0), (42, 1e100), (10, 1e100), (20, 0), (75, 0)] },
    };

    [Theory]
    [MemberData(nameof(Overflowing))]
    public void What_a_factor_carries_out_of_range_is_refused(string type, (int, object)[] pairs)
    {
        var drawing = DxfReading.Of(DxfText.WithEntities([.. pairs, .. OddDrawings.Arc]).ToAscii(), new DxfReadOptions(Cut: CutChoice.Hatch));

        var refused = Assert.Single(drawing.Balance.Refused);
        Assert.Equal((type, "DXF0033"), (refused.Type, refused.DiagnosticId));
        Assert.Equal(1, drawing.Balance.Cut);
    }

    [Theory]
    [InlineData(1e-310, 1e-310)]
    [InlineData(1e100, 1e100)]
    [InlineData(1e-300, 1e-294)]
    public void Of_weights_only_the_ratios_count(double first, double second)
    {
        (int, object)[] Spline(double a, double b) =>
            [(0, "SPLINE"), (70, 4), (71, 1), (40, 0), (40, 0), (40, 1), (40, 1), (41, a), (41, b), (10, 0), (20, 0), (10, 3), (20, 4)];
        var drawing = DxfReading.Entities(Spline(first, second));

        Assert.Equal(5.0, DrawingSummary.From(drawing).Length.Total, 1e-9);
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void Fit_points_nearer_than_can_be_reckoned_with_are_one()
    {
        var drawing = DxfReading.Entities((0, "SPLINE"), (70, 8), (71, 3), (11, 0), (21, 0), (11, 1e-200), (21, 0), (11, 3), (21, 4));

        Assert.Equal(5.0, DrawingSummary.From(drawing).Length.Total, 1e-9);
    }

    [Fact]
    public void Too_few_control_points_leave_the_fit_points()
    {
        var drawing = DxfReading.Entities((0, "SPLINE"), (70, 8), (71, 3), (10, 9), (20, 9), (11, 0), (21, 0), (11, 3), (21, 4));

        Assert.Equal(5.0, DrawingSummary.From(drawing).Length.Total, 1e-9);
        Assert.Equal(["DXF0041"], DxfReading.Ids(drawing));
    }
}
