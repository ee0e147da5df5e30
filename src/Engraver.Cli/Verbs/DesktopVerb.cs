using System.CommandLine;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using Engraver.Cli.Options;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver desktop</c>: starts the operator desktop, which is installed beside this program, and returns its exit code.</summary>
internal sealed class DesktopVerb
{
    private readonly Argument<string?> _file = new("FILE") { Description = Wording.Get("Desktop.Drawing"), Arity = ArgumentArity.ZeroOrOne };
    private readonly Option<string?> _script = new("--script") { Description = Wording.Get("Desktop.Script"), HelpName = "FILE.scr" };
    private readonly Option<bool> _headless = new("--headless") { Description = Wording.Get("Desktop.Headless") };
    private readonly Option<string?> _screenshot = new("--screenshot") { Description = Wording.Get("Desktop.Screenshot"), HelpName = "OUT.png" };
    private readonly Option<string?> _size = new("--size") { Description = Wording.Get("Desktop.Size"), HelpName = "1280x800" };
    private readonly Option<double?> _scale = new("--scale") { Description = Wording.Get("Desktop.Scale"), HelpName = "1.0", CustomParser = result => OptionValue.PositiveNumber(result) };

    private readonly Option<string?> _benchmark = new("--benchmark") { Description = Wording.Get("Desktop.Benchmark"), HelpName = "WHAT", Hidden = true };

    private DesktopVerb()
    {
    }

    public static Command Build()
    {
        var verb = new DesktopVerb();
        var command = new MachineCommand("desktop", Wording.Get("Desktop.Summary"));
        command.Arguments.Add(verb._file);
        foreach (var option in (Option[])[verb._script, verb._headless, verb._screenshot, verb._size, verb._scale, verb._benchmark]) command.Options.Add(option);
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var program = DesktopExecutable.Find(AppContext.BaseDirectory, Environment.ProcessPath) ?? throw new UsageException(Wording.Get("Desktop.NotFound", AppContext.BaseDirectory));
        using var desktop = Start(program, parsed);
        await using var asked = stop.Register(() => RequestExit(desktop.Id)).ConfigureAwait(false);
        await desktop.WaitForExitAsync(CancellationToken.None).ConfigureAwait(false);
        return desktop.ExitCode;
    }

    private Process Start(DesktopExecutable program, ParseResult parsed)
    {
        try
        {
            return Process.Start(program.Start(Words(parsed)))!;
        }
        catch (Win32Exception failure)
        {
            throw new UsageException(Wording.Get("Desktop.CannotStart", program.Runtime ?? program.File), failure);
        }
    }

    private IEnumerable<string> Words(ParseResult parsed)
    {
        if (parsed.GetValue(_file) is { } file) yield return file;
        if (parsed.GetValue(_headless)) yield return "--headless";
        if (CultureInfo.CurrentUICulture.Name is { Length: > 0 } spoken)
        {
            yield return "--culture";
            yield return spoken;
        }

        foreach (var (name, value) in new[] { ("--script", parsed.GetValue(_script)), ("--screenshot", parsed.GetValue(_screenshot)), ("--size", parsed.GetValue(_size)), ("--benchmark", parsed.GetValue(_benchmark)), ("--scale", parsed.GetValue(_scale)?.ToString(CultureInfo.InvariantCulture)) })
        {
            if (value is null) continue;
            yield return name;
            yield return value;
        }
    }

    /// <summary>Sends SIGTERM to the desktop. The caller waits: the desktop stops the machine before it ends.</summary>
    private static void RequestExit(int id)
    {
        if (OperatingSystem.IsWindows()) return; // Ctrl-C already reaches every process of the console.
        using var kill = Process.Start(new ProcessStartInfo("kill") { ArgumentList = { "-TERM", id.ToString(CultureInfo.InvariantCulture) }, UseShellExecute = false });
        kill?.WaitForExit();
    }
}

/// <summary>The operator desktop beside this program: an executable if both were published, otherwise an assembly for the runtime.</summary>
/// <param name="File">Its path.</param>
/// <param name="Runtime">The program that runs an assembly; null for an executable.</param>
internal sealed record DesktopExecutable(string File, string? Runtime)
{
    private const string Name = "engraver-desktop";

    /// <summary>Finds the desktop: published into this program's folder, into the neighbouring folder, or built beside it.</summary>
    /// <param name="here">This program's folder.</param>
    /// <param name="process">This program's executable: the runtime if an assembly was started, or the self-contained published program.</param>
    /// <returns>Null when there is none.</returns>
    public static DesktopExecutable? Find(string here, string? process)
    {
        var runtime = Path.GetFileNameWithoutExtension(process) == "dotnet" ? process : null;
        var folders = Folders(here).ToList();
        var executable = folders.Select(folder => Path.Combine(folder, OperatingSystem.IsWindows() ? Name + ".exe" : Name)).FirstOrDefault(System.IO.File.Exists);
        var assembly = folders.Select(folder => Path.Combine(folder, Name + ".dll")).FirstOrDefault(System.IO.File.Exists);
        if (assembly is not null && (runtime is not null || executable is null)) return new DesktopExecutable(assembly, runtime ?? "dotnet");
        return executable is null ? null : new DesktopExecutable(executable, null);
    }

    /// <summary>The start information with these arguments.</summary>
    public ProcessStartInfo Start(IEnumerable<string> words)
    {
        var start = new ProcessStartInfo(Runtime ?? Path.GetFullPath(File)) { UseShellExecute = false };
        if (Runtime is not null) start.ArgumentList.Add(Path.GetFullPath(File));
        foreach (var word in words) start.ArgumentList.Add(word);
        return start;
    }

    private static IEnumerable<string> Folders(string here)
    {
        var folder = here.TrimEnd(Path.DirectorySeparatorChar);
        yield return folder;
        yield return Path.Combine(folder, "..", "desktop");
        yield return Path.Combine(folder, "..", "..", "Engraver.App", Path.GetFileName(folder));
    }
}
