using Engraver.Workbench.Commands;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Plots;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Plots;

/// <summary>PLOTEXPORT and PLOTCOMPARE without a window.</summary>
public class PlotCommandTests
{
    [Fact]
    public async Task Values_are_exported_and_pictures_need_the_desktop()
    {
        await using var talk = new CommandTestSession();
        Assert.Contains("No drawing", Failure(await talk.TypeAsync("PLOTEXPORT")), StringComparison.Ordinal);
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "PLOTEXPORT", "plots.csv");
        var lines = await File.ReadAllLinesAsync(talk.PathOf("plots.csv"));
        Assert.StartsWith("motion,seconds,path_mm,entity,speed_mm_per_min", lines[0], StringComparison.Ordinal);
        Assert.All(lines.Skip(1), line => Assert.StartsWith("plan,", line, StringComparison.Ordinal));

        Assert.Contains("only the desktop", Failure(await talk.TypeAsync("PLOTEXPORT", "plots.png")), StringComparison.Ordinal);
        Assert.Contains("one of .png, .svg, .csv", Failure(await talk.TypeAsync("PLOTEXPORT", "plots.bmp")), StringComparison.Ordinal);
        Assert.False(File.Exists(talk.PathOf("plots.png")));
    }

    [Fact]
    public async Task A_stored_run_is_compared_until_it_is_removed()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"));
        Assert.Contains("No run of paper-001.dxf is stored", Failure(await talk.TypeAsync("PLOTCOMPARE", "LAst")), StringComparison.Ordinal);
        await talk.TypeAsync("CNCSIM");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("PLOTCOMPARE", "LAst"));
        await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);

        var content = talk.Session.Plots.Content(talk.Session.Settings.Current, CancellationToken.None);
        Assert.Equal([PlotRole.Plan, PlotRole.Run, PlotRole.Compared], content.Series.Select(series => series.Role));
        Assert.Equal(content.Series[1].Motion.Path[^1], content.Series[2].Motion.Path[^1], 0.01);
        Assert.NotNull(content.Series[2].Motion.Of(PlotQuantity.FeedOverride));
        Assert.Equal(["Speed", "Acceleration", "FollowingError", "Deviation"], content.Panels.Select(panel => panel.Key));

        await talk.TypeAsync("PLOTCOMPARE", "Off", "CNCPLOTS", "16", "CNCPLOTAXIS", "1");
        content = talk.Session.Plots.Content(talk.Session.Settings.Current, CancellationToken.None);
        Assert.Equal([PlotRole.Plan, PlotRole.Run], content.Series.Select(series => series.Role));
        Assert.Equal("FeedOverride", Assert.Single(content.Panels).Key);
        Assert.Equal(PlotAxis.Path, content.Axis);
        Assert.Equal(PlotAxis.Path, talk.Session.Settings.Current.PlotAxis());
    }

    private static string Failure(InputResult result) => Assert.IsType<InputResult.Failed>(result).Message;
}
