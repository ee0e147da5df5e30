using System.CommandLine;
using System.CommandLine.Parsing;
using System.Diagnostics;
using System.Globalization;
using Engraver.Cli.Options;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver desktop</c>: starts the operator desktop, the program beside this one, and becomes its exit code.</summary>
internal sealed class DesktopVerb
{
    private const string Program = "engraver-desktop";
    private readonly Argument<string?> _file = new("FILE") { Description = Wording.Get("Desktop.DrawingOpen"), Arity = ArgumentArity.ZeroOrOne };
    private readonly Option<string?> _script = new("--script") { Description = Wording.Get("Desktop.CommandsRunOnceWindow"), HelpName = "FILE.scr" };
    private readonly Option<bool> _headless = new("--headless") { Description = Wording.Get("Desktop.NeedsNoDisplayEnds") };
    private readonly Option<string?> _screenshot = new("--screenshot") { Description = Wording.Get("Desktop.WherePictureWindowWritten"), HelpName = "OUT.png" };
    private readonly Option<string?> _size = new("--size") { Description = Wording.Get("Desktop.SizeWindow"), HelpName = "1280x800" };
    private readonly Option<double?> _scale = new("--scale") { Description = Wording.Get("Desktop.PixelsEachUnit"), HelpName = "1.0", CustomParser = result => OptionValue.PositiveNumber(result) };

    private readonly Option<string?> _benchmark = new("--benchmark") { Description = Wording.Get("Desktop.MeasuresInsteadOpeningStart"), HelpName = "WHAT", Hidden = true };

    private DesktopVerb()
    {
    }

    public static Command Build()
    {
        var verb = new DesktopVerb();
        var command = new MachineCommand("desktop", Wording.Get("Desktop.OpensOperatorDesktopExit"));
        verb._file.Validators.Add(NoOption);
        command.Arguments.Add(verb._file);
        foreach (var option in (Option[])[verb._script, verb._headless, verb._screenshot, verb._size, verb._scale, verb._benchmark]) command.Options.Add(option);
        command.SetAction(verb.RunAsync);
        return command;
    }

    /// <summary>Paths at which the desktop may be: published into this program's folder, into the folder beside, or built beside it.</summary>
    /// <param name="here">This program's folder.</param>
    internal static IEnumerable<string> Candidates(string here)
    {
        var folder = here.TrimEnd(Path.DirectorySeparatorChar);
        var kind = Path.GetFileName(folder);
        yield return Path.Combine(folder, Program + ".dll");
        yield return Path.Combine(folder, "..", "desktop", Program + ".dll");
        yield return Path.Combine(folder, "..", "..", "Engraver.App", kind, Program + ".dll");
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var program = Candidates(AppContext.BaseDirectory).FirstOrDefault(File.Exists)
            ?? throw new UsageException(Wording.Get("Desktop.DesktopNotThereNot", Program, AppContext.BaseDirectory));
        var start = new ProcessStartInfo(Dotnet()) { UseShellExecute = false };
        start.ArgumentList.Add(Path.GetFullPath(program));
        foreach (var word in Words(parsed)) start.ArgumentList.Add(word);
        using var desktop = Process.Start(start) ?? throw new UsageException(Wording.Get("Desktop.CouldNotStarted", program));
        await using var asked = stop.Register(() => AskToEnd(desktop.Id)).ConfigureAwait(false);
        await desktop.WaitForExitAsync(CancellationToken.None).ConfigureAwait(false);
        return desktop.ExitCode;
    }

    /// <summary>Refuses an argument that begins like an option, because no option of that name exists.</summary>
    private static void NoOption(ArgumentResult result)
    {
        foreach (var token in result.Tokens)
        {
            if (token.Value.StartsWith("--", StringComparison.Ordinal)) result.AddError(Wording.Get("Desktop.UnrecognizedOption", token.Value));
        }
    }

    /// <summary>The runtime this program itself runs on.</summary>
    private static string Dotnet() => Path.GetFileNameWithoutExtension(Environment.ProcessPath) == "dotnet" ? Environment.ProcessPath! : "dotnet";

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

    /// <summary>Asks the desktop to end by SIGTERM and leaves the waiting to the caller: the desktop stops the machine before it ends, however long that takes.</summary>
    private static void AskToEnd(int id)
    {
        if (OperatingSystem.IsWindows()) return; // Ctrl-C reaches every program of the console by itself
        using var kill = Process.Start(new ProcessStartInfo("kill") { ArgumentList = { "-TERM", id.ToString(CultureInfo.InvariantCulture) }, UseShellExecute = false });
        kill?.WaitForExit();
    }
}
