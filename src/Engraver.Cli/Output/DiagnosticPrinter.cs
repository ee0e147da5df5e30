using System.Diagnostics;
using Engraver.Core.Diagnostics;

namespace Engraver.Cli.Output;

/// <summary>Diagnostics for people, on standard error: <c>FILE(LINE): Severity ID: sentence</c>.</summary>
internal static class DiagnosticPrinter
{
    /// <summary>Severity as the runner's texts and JSON spell it.</summary>
    public static string Word(Severity severity) => severity switch
    {
        Severity.Info => "info",
        Severity.Warning => "warning",
        Severity.Error => "error",
        _ => throw new UnreachableException(),
    };

    /// <summary>Prints those of at least the given severity, worst first, otherwise in the order found.</summary>
    public static void Print(TextWriter error, string file, IEnumerable<Diagnostic> diagnostics, Severity least)
    {
        foreach (var diagnostic in diagnostics.Where(d => d.Severity >= least).OrderByDescending(d => d.Severity))
        {
            var place = diagnostic.Source.Line > 0 ? FormattableString.Invariant($"{file}({diagnostic.Source.Line})") : file;
            var handle = diagnostic.Source.Handle is { } name ? $" [handle {name}]" : "";
            error.WriteLine($"{place}: {Word(diagnostic.Severity)} {diagnostic.Id}: {diagnostic.Message}{handle}");
        }
    }
}
