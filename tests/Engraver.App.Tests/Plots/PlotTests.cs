using Engraver.App.Plots;

namespace Engraver.App.Tests.Plots;

[Collection(DesktopCollection.Name)]
public sealed class PlotTests(DesktopFixture fixture)
{
    [Fact]
    public Task The_plot_follows_the_tool_and_a_press_in_it_moves_the_tool() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Window.Model.Playback.At = 10.0;
        here.Show("Plots");
        var chart = here.Find<SpeedChart>("Plot");
        Assert.Equal(10.0, chart.At, 6);
        here.Window.Model.Playback.At = 20.0;
        Assert.Equal(20.0, chart.At, 6);

        here.Hands.Click(here.MiddleOf(chart));

        Assert.InRange(here.Desk.Derived.AtSeconds / here.Window.Model.Playback.Total, 0.4, 0.5);
        Assert.Equal(chart.At, here.Window.Model.Playback.At, 6);
    });

    [Fact]
    public Task The_curve_is_as_high_as_the_fastest_move() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var motion = here.Commands.Derivation.Current.Motion!;
        var curve = SpeedCurve.From(motion);

        Assert.Equal(motion.DurationSeconds, curve.TotalSeconds);
        Assert.Equal(curve.Samples.Max(sample => sample.Speed), curve.Peak);
        Assert.Equal(20.0, motion.At(motion.TimeOfStroke(0)!.Value + 2.0).Speed, 3);
    });
}
