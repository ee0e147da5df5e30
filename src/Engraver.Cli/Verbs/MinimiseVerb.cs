using System.CommandLine;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Languages;
using Engraver.Tools.Minimising;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver minimise</c>: reduces a drawing to the smallest one that still shows a fault.</summary>
internal static class MinimiseVerb
{
    private const string Crash = "crash";

    public static Command Build(VerbHost host)
    {
        var file = new Argument<string>("FILE") { Description = Wording.Get("Minimise.Drawing") };
        var keep = new Option<string>("--keep") { Required = true, HelpName = "ID|crash", Description = Wording.Get("Minimise.Keep") };
        var output = new Option<string?>("-o", "--output") { HelpName = "OUT.dxf", Description = Wording.Get("Verbs.Output") };
        var command = new Command("minimise", Wording.Get("Minimise.Summary")) { file, keep, output };
        command.SetAction((parsed, stop) => Task.FromResult(Run(host, parsed.GetRequiredValue(file), parsed.GetRequiredValue(keep), parsed.GetValue(output), stop)));
        return command;
    }

    private static int Run(VerbHost host, string path, string fault, string? output, CancellationToken stop)
    {
        if (fault != Crash && DiagnosticTable.All.All(rule => rule.Id != fault)) throw new UsageException(Wording.Get("Minimise.InvalidFault", fault));
        if (Read(host, path) is not { } bytes) return ExitCode.DrawingError;
        Predicate<byte[]> shows = fault == Crash ? candidate => Crashes(candidate, stop) : candidate => Diagnostics(candidate, fault, stop).Any(found => found.Id == fault);
        if (!shows(bytes))
        {
            host.Error.WriteLine(Wording.Get("Minimise.DoesNotShow", path, fault));
            return ExitCode.DrawingError;
        }

        var smallest = DrawingMinimiser.Minimise(bytes, shows, stop);
        host.Write(output, writer => writer.Write(Encoding.Latin1.GetString(smallest)));
        host.Error.WriteLine(Wording.Get("Minimise.Reduced", bytes.Length, smallest.Length, fault));
        return ExitCode.Done;
    }

    private static byte[]? Read(VerbHost host, string path)
    {
        try
        {
            return File.ReadAllBytes(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            host.Error.WriteLine($"engraver: {SystemErrorText.WithPath(unreadable)}.");
            return null;
        }
    }

    private static IReadOnlyList<Diagnostic> Diagnostics(byte[] candidate, string fault, CancellationToken stop)
    {
        var drawing = DxfReader.Read(candidate, "candidate.dxf", DxfReadOptions.Default, stop);
        if (fault.StartsWith("DXF", StringComparison.Ordinal)) return drawing.Diagnostics;
        var ordered = JobPreparation.To<OrderedJob>(drawing, new DrawingSettings());
        return [.. ordered.Drawing.Diagnostics, .. ordered.Sequence.Diagnostics];
    }

    /// <summary>The reader and the first stages should throw no exception, so every exception except the operator's stop counts as a crash.</summary>
    private static bool Crashes(byte[] candidate, CancellationToken stop)
    {
        try
        {
            DrawingSummary.From(DxfReader.Read(candidate, "candidate.dxf", DxfReadOptions.Default, stop));
            _ = Diagnostics(candidate, Crash, stop);
            return false;
        }
        catch (Exception bug) when (bug is not OperationCanceledException)
        {
            return true;
        }
    }
}
