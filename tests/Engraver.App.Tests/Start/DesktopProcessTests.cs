using System.Diagnostics;
using Engraver.TestKit;

namespace Engraver.App.Tests.Start;

/// <summary>The program as an operator or a script starts it.</summary>
public sealed class DesktopProcessTests
{
    [Fact]
    public async Task Headless_it_opens_runs_a_script_takes_its_picture_and_ends()
    {
        using var folder = new TemporaryDesktopFolder();
        var script = Path.Combine(folder.Path, "look.scr");
        await File.WriteAllTextAsync(script, "SHOW OrderNumbers ON\nZOOM Extents\n");
        var picture = Path.Combine(folder.Path, "window.png");

        var (code, errors) = await RunAsync(folder, Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), "--script", script, "--headless", "--screenshot", picture, "--size", "1100x720", "--scale", "2");

        Assert.Equal("", errors);
        Assert.Equal(0, code);
        Assert.Equal((2200, 1440), SizeOfPng(await File.ReadAllBytesAsync(picture)));
    }

    [Fact]
    public async Task Without_a_display_it_says_so_and_ends_with_6()
    {
        using var folder = new TemporaryDesktopFolder();
        var (code, errors) = await RunAsync(folder);

        Assert.Equal(6, code);
        Assert.Contains("--headless", errors, StringComparison.Ordinal);
        Assert.Single(errors.TrimEnd().Split('\n'));
    }

    [Fact]
    public async Task A_drawing_that_is_not_there_is_one_sentence_and_a_code()
    {
        using var folder = new TemporaryDesktopFolder();
        var (code, errors) = await RunAsync(folder, "/nowhere/plate.dxf", "--headless");

        Assert.Equal(1, code);
        Assert.Contains("/nowhere/plate.dxf", errors, StringComparison.Ordinal);
    }

    private static (int Width, int Height) SizeOfPng(ReadOnlySpan<byte> png) =>
        (System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(png[16..]), System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(png[20..]));

    private static async Task<(int Code, string Errors)> RunAsync(TemporaryDesktopFolder folder, params string[] words)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardError = true, RedirectStandardOutput = true };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "engraver-desktop.dll"));
        foreach (var word in words) start.ArgumentList.Add(word);
        start.Environment.Remove("DISPLAY");
        start.Environment["XDG_DATA_HOME"] = folder.Path;
        start.Environment["LOCALAPPDATA"] = folder.Path;
        using var desktop = Process.Start(start)!;
        var errors = await desktop.StandardError.ReadToEndAsync();
        await desktop.WaitForExitAsync();
        return (desktop.ExitCode, errors);
    }
}
