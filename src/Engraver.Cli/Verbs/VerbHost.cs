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

/// <summary>The services of every verb: streams, global options, and printing diagnostics and converting them to an exit code.</summary>
internal sealed class VerbHost(ConsoleStreams streams, GlobalOptions global, ConnectionGuard machine)
{
    public TextWriter Out => streams.Out;

    public TextWriter Error => streams.Error;

    public TextReader In => streams.In;

    /// <summary>The next line that the operator types; null at the end of the input. A console read cannot be cancelled: the operator's stop does not wait for
    /// it.</summary>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    public Task<string?> ReadLineAsync(CancellationToken stop) => Task.Run(In.ReadLine, stop).WaitAsync(stop);

    /// <summary>For a verb that connects to a machine and disconnects during its run; others are a <see cref="MachineCommand"/>.</summary>
    public ConnectionGuard Machine => machine;

    /// <summary>True on an interactive terminal.</summary>
    public bool Interactive => streams.Interactive;

    /// <summary>Returns the next pressed key; null without an interactive terminal.</summary>
    public Func<ConsoleKeyInfo?>? Keys => streams.Keys;

    public bool Quiet(ParseResult parsed) => global.Quiet(parsed);

    public bool Verbose(ParseResult parsed) => global.Verbose(parsed);

    /// <summary>Prints findings (warnings and errors; with --verbose also infos, with --quiet only errors).</summary>
    /// <returns>The exit code for the findings.</returns>
    public int Report(ParseResult parsed, string file, IReadOnlyCollection<Diagnostic> diagnostics)
    {
        var least = global.Quiet(parsed) ? Severity.Error : global.Verbose(parsed) ? Severity.Info : Severity.Warning;
        DiagnosticPrinter.Print(Error, file, diagnostics, least);
        return diagnostics.Any(d => d.Severity == Severity.Error) ? ExitCode.DrawingError : ExitCode.Done;
    }

    /// <summary>Prints the start checks (with --quiet only the failed ones), without the findings of the drawing, which are already printed.</summary>
    public void Print(ParseResult parsed, ArmingChecklist list)
    {
        foreach (var check in list.Checks.Where(check => !check.Passed || (!global.Quiet(parsed) && !check.IsFinding))) Error.WriteLine(check.Line);
    }

    /// <summary>Reports why the machine was not moved.</summary>
    /// <returns>The exit code.</returns>
    public int NotMoved(string why)
    {
        Error.WriteLine(Wording.Get("Hand.NotMoved", why));
        return ExitCode.DrawingError;
    }

    /// <summary>Adds a job to the history; a write failure is only reported.</summary>
    public void Remember(HistoryEntry entry)
    {
        if (new JobHistory(JobHistory.FolderIn(null)).Add(entry).Failure is { } failure) WarnNotSaved(failure);
    }

    /// <summary>Records the result of reading a program back in its history entry, if there is one.</summary>
    public void NoteReadBack(string program, HistoryReadBack found)
    {
        if (new JobHistory(JobHistory.FolderIn(null)).NoteReadBack(program, found) is { } failure) WarnNotSaved(failure);
    }

    /// <summary>The start position saved beside a program; reports a file that is not used.</summary>
    /// <returns>Drawing millimetres; null for none.</returns>
    public Point2D? SavedStart(ParseResult parsed, string program)
    {
        var kept = ProgramStart.Find(program);
        if (kept.Message is { } unused && !global.Quiet(parsed)) Error.WriteLine(unused);
        return kept.Position;
    }

    /// <summary>Adds a run that starts to the history.</summary>
    public PendingRun BeginRun(HistoryEntry entry) => new(new JobHistory(JobHistory.FolderIn(null)), entry, WarnNotSaved);

    private void WarnNotSaved(string failure) => Error.WriteLine(Wording.Get("Verbs.HistoryNotWritten", failure));

    /// <summary>Writes a result atomically to a file, or to standard output when no file is named.</summary>
    /// <exception cref="UsageException">The path cannot be written.</exception>
    public void Write(string? path, Action<TextWriter> write)
    {
        if (path is null)
        {
            write(Out);
            return;
        }

        Attempt(path, () => OutputFile.Write(path, write));
    }

    /// <summary>Saves the start position beside a written program whose format does not contain it.</summary>
    /// <exception cref="UsageException">The path cannot be written.</exception>
    public static void SaveProgramStart(string program, PostForecast? forecast) => Attempt(program + ProgramStart.FileExtension, () => ProgramStart.Save(program, forecast));

    /// <summary>Checks before a long operation that its result can be written.</summary>
    /// <exception cref="UsageException">It cannot.</exception>
    public static void CheckWritable(string path) => Attempt(path, () => OutputFile.Check(path));

    /// <summary>Refuses to overwrite the source of a result with the result.</summary>
    /// <param name="path">Path of the result; null for standard output.</param>
    /// <exception cref="UsageException">Both are the same file.</exception>
    public static void RejectSameFile(string source, string? path)
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
            throw new UsageException(Wording.Get("Verbs.CannotWrite", path, SystemErrorText.FromException(unwritable)), unwritable);
        }
    }
}
