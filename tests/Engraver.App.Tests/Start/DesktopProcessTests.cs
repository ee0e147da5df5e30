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

    /// <summary>ScottPlot and Skia are loaded with the first page of plots, so that a start does not wait for them: a program without their files opens and
    /// shows a drawing.</summary>
    [Fact]
    public async Task The_libraries_of_the_plots_are_not_loaded_at_the_start()
    {
        using var folder = new TemporaryDesktopFolder();
        var program = Directory.CreateDirectory(Path.Combine(folder.Path, "program")).FullName;
        foreach (var file in Directory.EnumerateFiles(AppContext.BaseDirectory).Where(IsNeeded)) File.Copy(file, Path.Combine(program, Path.GetFileName(file)));
        Assert.True(File.Exists(Path.Combine(AppContext.BaseDirectory, "ScottPlot.dll")) && File.Exists(Path.Combine(AppContext.BaseDirectory, "SkiaSharp.dll")));
        var picture = Path.Combine(folder.Path, "window.png");

        var (code, errors) = await RunInAsync(program, folder, Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), "--headless", "--screenshot", picture);

        Assert.Equal((0, ""), (code, errors));
        Assert.True(File.Exists(picture));

        // Without the list of files (deps.json), which the runtime checks at the start, it loads what is beside the program.
        static bool IsNeeded(string file) => Path.GetFileName(file) is var name && Path.GetExtension(name) is ".dll" or ".json" && !name.EndsWith(".deps.json", StringComparison.Ordinal)
            && !name.StartsWith("ScottPlot", StringComparison.Ordinal) && !name.StartsWith("SkiaSharp", StringComparison.Ordinal) && !name.StartsWith("HarfBuzzSharp", StringComparison.Ordinal);
    }

    private static (int Width, int Height) SizeOfPng(ReadOnlySpan<byte> png) =>
        (System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(png[16..]), System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(png[20..]));

    private static Task<(int Code, string Errors)> RunAsync(TemporaryDesktopFolder folder, params string[] words) => RunInAsync(AppContext.BaseDirectory, folder, words);

    private static async Task<(int Code, string Errors)> RunInAsync(string program, TemporaryDesktopFolder folder, params string[] words)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardError = true, RedirectStandardOutput = true };
        start.ArgumentList.Add(Path.Combine(program, "engraver-desktop.dll"));
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
