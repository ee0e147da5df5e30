using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.Workbench.Plots;

namespace Engraver.Workbench.Tests.Plots;

public class TraceSeriesTests
{
    [Fact]
    public void Speed_acceleration_and_path_follow_from_the_positions()
    {
        const double Acceleration = 200.0;
        var trace = new RunTrace("polled", [.. Enumerable.Range(0, 101).Select(i => i * 0.01).Select(t => new RunTracePlace(5.0 + t, new Point2D(0.5 * Acceleration * t * t, 3.0), true, 0.001 * t))]);

        var series = TraceSeries.From(trace);

        Assert.Equal(1.0, series.Seconds[^1], 9);
        Assert.Equal(0.5 * Acceleration, series.Path[^1], 9);
        Assert.Equal(Acceleration * 0.495 * 60.0, series.ValueAt(PlotQuantity.Speed, PlotAxis.Time, 0.5), 6);
        Assert.Equal(Acceleration, series.ValueAt(PlotQuantity.AccelerationX, PlotAxis.Time, 0.5), 6);
        Assert.Equal(0.0, series.ValueAt(PlotQuantity.AccelerationY, PlotAxis.Time, 0.5), 6);
        Assert.Equal(0.0005, series.ValueAt(PlotQuantity.Deviation, PlotAxis.Time, 0.5), 9);
        Assert.Null(series.Of(PlotQuantity.FollowingError));
        Assert.Null(series.Of(PlotQuantity.FeedOverride));
        Assert.True(double.IsNaN(series.ValueAt(PlotQuantity.Speed, PlotAxis.Time, 1.1)));
    }

    [Fact]
    public void Unknown_values_are_gaps()
    {
        RunTracePlace Place(double t, double? following, double? feed) => new(t, new Point2D(t, 0), true, 0.0, following) { Conditions = new TraceConditions(feed, null) };
        var series = TraceSeries.From(new RunTrace("record", [Place(0, null, 1.0), Place(1, 0.5, 1.5), Place(2, 0.25, 1.5), Place(3, null, null)]));

        Assert.Equal([1..3], series.KnownRanges(PlotQuantity.FollowingError));
        Assert.Equal([100.0, 150.0, 150.0, double.NaN], series.Of(PlotQuantity.FeedOverride)!);
        Assert.Null(series.Of(PlotQuantity.LinkLoad));
        Assert.Empty(series.KnownRanges(PlotQuantity.LinkLoad));
    }

    [Fact]
    public void Values_are_written_with_empty_cells_for_unknown_ones()
    {
        var series = TraceSeries.From(new RunTrace("polled", [new(1.0, new Point2D(0, 0), true, 0.25), new(2.0, new Point2D(3, 4), true, 0.5, 0.125)]));
        using var text = new StringWriter { NewLine = "\n" };

        PlotCsv.Write([new PlotSeries(PlotRole.Run, "", series)], text);

        Assert.Equal("motion,seconds,path_mm,entity,speed_mm_per_min,acceleration_x_mm_per_s2,acceleration_y_mm_per_s2,following_error_mm,deviation_mm\nrun,0,0,,0,0,0,,0.25\nrun,1,5,,300,3,4,0.125,0.5\n", text.ToString());
    }
}
