using Engraver.Cli.Verbs;

namespace Engraver.Cli.Tests.Verbs;

public sealed class DesktopVerbTests
{
    /// <summary>A published program has no runtime beside it: the executable is started directly. A build contains both, and the desktop is started with the
    /// runtime of this program.</summary>
    [Theory]
    [InlineData("engraver", "engraver", false)]
    [InlineData("engraver", "desktop", false)]
    [InlineData("bin/Engraver.Cli/release", "bin/Engraver.App/release", true)]
    public void The_desktop_is_looked_for_beside_this_program_however_it_was_built_or_published(string here, string there, bool byRuntime)
    {
        using var folder = new TemporaryFolder();
        var (own, desktop) = (Directory.CreateDirectory(folder.PathOf(here)).FullName, Directory.CreateDirectory(folder.PathOf(there)).FullName);
        var executable = Path.Combine(desktop, OperatingSystem.IsWindows() ? "engraver-desktop.exe" : "engraver-desktop");
        foreach (var file in (string[])[executable, Path.Combine(desktop, "engraver-desktop.dll")]) File.WriteAllText(file, "");

        var start = DesktopExecutable.Find(own + Path.DirectorySeparatorChar, byRuntime ? "/usr/bin/dotnet" : Path.Combine(own, "engraver"))!.Start(["part.dxf"]);

        Assert.Equal(byRuntime ? "/usr/bin/dotnet" : executable, start.FileName);
        Assert.Equal(byRuntime ? [Path.Combine(desktop, "engraver-desktop.dll"), "part.dxf"] : ["part.dxf"], start.ArgumentList);
    }

    [Fact]
    public void A_single_executable_is_enough_and_nothing_is_no_desktop()
    {
        using var folder = new TemporaryFolder();
        var own = Directory.CreateDirectory(folder.PathOf("engraver")).FullName;
        Assert.Null(DesktopExecutable.Find(own, Path.Combine(own, "engraver")));

        File.WriteAllText(Path.Combine(own, OperatingSystem.IsWindows() ? "engraver-desktop.exe" : "engraver-desktop"), "");

        Assert.Null(DesktopExecutable.Find(own, Path.Combine(own, "engraver"))!.Runtime);
    }

    [Fact]
    public async Task An_option_that_is_not_there_is_a_usage_error()
    {
        var run = await CliRun.RunAsync("desktop", "--fullscreen");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--fullscreen", run.Error, StringComparison.Ordinal);
    }
}
