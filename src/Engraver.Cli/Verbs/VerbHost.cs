using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Output;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Languages;
using Engraver.Core.Posts;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Sidecars;

namespace Engraver.Cli.Verbs;

/// <summary>What every verb needs around it: the streams, the global options, and the way diagnostics are printed and turned into an exit code.</summary>
internal sealed class VerbHost(ConsoleStreams streams, GlobalOptions global, MachineInHand machine)
{
    public TextWriter Out => streams.Out;

    public TextWriter Error => streams.Error;

    public TextReader In => streams.In;

    /// <summary>For a verb that connects to a machine and lets it go as it likes; others are a <see cref="MachineCommand"/>.</summary>
    public MachineInHand Machine => machine;

    /// <summary>True when a person types and watches.</summary>
    public bool Interactive => streams.Interactive;

    /// <summary>Takes the next key that was pressed; null where nobody has keys.</summary>
    public Func<ConsoleKeyInfo?>? Keys => streams.Keys;

    public bool Quiet(ParseResult parsed) => global.Quiet(parsed);

    public bool Verbose(ParseResult parsed) => global.Verbose(parsed);

    /// <summary>Prints what was found (warnings and errors; with --verbose also infos, with --quiet only errors).</summary>
    /// <returns>The exit code that the findings ask for.</returns>
    public int Report(ParseResult parsed, string file, IReadOnlyCollection<Diagnostic> diagnostics)
    {
        var least = global.Quiet(parsed) ? Severity.Error : global.Verbose(parsed) ? Severity.Info : Severity.Warning;
        DiagnosticPrinter.Print(Error, file, diagnostics, least);
        return diagnostics.Any(d => d.Severity == Severity.Error) ? ExitCode.DrawingError : ExitCode.Done;
    }

    /// <summary>Prints the list before a start (with --quiet only what prevents it), without the findings of the drawing, which are printed already.</summary>
    public void Print(ParseResult parsed, ArmingChecklist list)
    {
        foreach (var check in list.Checks.Where(check => !check.Passed || (!global.Quiet(parsed) && !check.IsFinding))) Error.WriteLine(check.Line);
    }

    /// <summary>Adds a job to the history; that it cannot be kept is said, and changes nothing else.</summary>
    public void Remember(HistoryEntry entry)
    {
        if (new JobHistory(JobHistory.FolderIn(null)).Add(entry).Failure is { } failure) SayNotKept(failure);
    }

    /// <summary>Notes in the history how a program was read back, where the history knows it.</summary>
    public void NoteReadBack(string program, HistoryReadBack found)
    {
        if (new JobHistory(JobHistory.FolderIn(null)).NoteReadBack(program, found) is { } failure) SayNotKept(failure);
    }

    /// <summary>The start that is kept beside a program; that a file of it is not used is said.</summary>
    /// <returns>Drawing millimetres; null for none.</returns>
    public Point2D? KeptStart(ParseResult parsed, string program)
    {
        var kept = ProgramStart.Find(program);
        if (kept.Sentence is { } unused && !global.Quiet(parsed)) Error.WriteLine(unused);
        return kept.Place;
    }

    /// <summary>A run that begins is in the history from now on.</summary>
    public OpenJob Begin(HistoryEntry entry) => new(new JobHistory(JobHistory.FolderIn(null)), entry, SayNotKept);

    private void SayNotKept(string failure) => Error.WriteLine(Wording.Get("Verbs.HistoryNotWritten", failure));

    /// <summary>Writes a result to a file, whole or not at all, or to standard output when no file is named.</summary>
    /// <exception cref="UsageException">The place cannot be written.</exception>
    public void Write(string? path, Action<TextWriter> write)
    {
        if (path is null)
        {
            write(Out);
            return;
        }

        Attempt(path, () => OutputFile.Write(path, write));
    }

    /// <summary>Keeps beside a program that was written where it begins, where its form does not say it.</summary>
    /// <exception cref="UsageException">The place cannot be written.</exception>
    public static void Keep(string program, PostForecast? forecast) => Attempt(program + ProgramStart.Ending, () => ProgramStart.Keep(program, forecast));

    /// <summary>For a result that comes only once: the place of the result can be written.</summary>
    /// <exception cref="UsageException">It cannot.</exception>
    public static void CheckPlace(string path) => Attempt(path, () => OutputFile.Check(path));

    /// <summary>A result of another kind does not take the place of what it is made from.</summary>
    /// <param name="path">Of the result; null for standard output.</param>
    /// <exception cref="UsageException">The two are one file.</exception>
    public static void KeepApart(string source, string? path)
    {
        if (path is not null && Path.GetFullPath(path) == Path.GetFullPath(source) && !FileKind.IsStream(path)) throw new UsageException(Wording.Get("Verbs.OutputIsInput", path));
    }

    private static void Attempt(string path, Action write)
    {
        try
        {
            write();
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Verbs.CannotWrite", path, SystemReason.Of(unwritable)), unwritable);
        }
    }
}
