using Engraver.Cli.Verbs;

namespace Engraver.Cli.Tests.Verbs;

public sealed class DesktopVerbTests
{
    [Fact]
    public void The_desktop_is_looked_for_beside_this_program_however_it_was_built_or_published()
    {
        var run = Path.Combine(Path.GetTempPath(), "run");
        var beside = DesktopVerb.Candidates(Path.Combine(run, "engraver") + Path.DirectorySeparatorChar).Select(Path.GetFullPath).ToList();
        var built = DesktopVerb.Candidates(Path.Combine(run, "bin", "Engraver.Cli", "release")).Select(Path.GetFullPath).ToList();

        Assert.Contains(Path.Combine(run, "engraver", "engraver-desktop.dll"), beside);
        Assert.Contains(Path.Combine(run, "desktop", "engraver-desktop.dll"), beside);
        Assert.Contains(Path.Combine(run, "bin", "Engraver.App", "release", "engraver-desktop.dll"), built);
    }

    [Fact]
    public async Task An_option_that_is_not_there_is_a_usage_error()
    {
        var run = await CliRun.RunAsync("desktop", "--fullscreen");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--fullscreen", run.Error, StringComparison.Ordinal);
    }
}
