using Engraver.Core.Languages;
using Engraver.Core.Verification;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Reads stored runs of the open drawing.</summary>
internal static class StoredRun
{
    /// <summary>Asks for the journal of a run or the trace beside it.</summary>
    public static async Task<string> AskAsync(CommandContext context) =>
        context.ResolveInputPath(await context.ValueAsync(new FilePrompt(Wording.Get("CncTrace.EnterFile"), new FileRequest("journal", false))).ConfigureAwait(false));

    /// <summary>The journal of the last stored run.</summary>
    /// <exception cref="CommandException">There is none.</exception>
    public static string LastOf(CommandContext context) => TraceFile.LastOf(context.Drawing.FileName, context.RunJournalFolder) ?? throw NoRun(context);

    /// <summary>Writes the traces of all stored runs, the oldest first.</summary>
    /// <exception cref="CommandException">There is none.</exception>
    public static void WriteList(CommandContext context)
    {
        var kept = TraceFile.AllOf(context.Drawing.FileName, context.RunJournalFolder);
        if (kept.Count == 0) throw NoRun(context);
        context.WriteResult(output =>
        {
            foreach (var journal in kept) output.WriteLine(TraceFile.PathOf(journal));
        });
    }

    /// <summary>Reads a run.</summary>
    /// <param name="file">Its journal, or the trace beside it.</param>
    /// <exception cref="CommandException">It cannot be read, is not a trace, or belongs to another drawing.</exception>
    public static RecordedRun Read(CommandContext context, string file)
    {
        var job = PlateJob.Prepare(context.Drawing, context.Document.Current.Settings, context.Driver.DefaultStrategy.Style, JournalPlate.Read(TraceFile.JournalOf(file)));
        var trace = TraceOf(file);
        if (!trace.CanBeOf(DrawnFingerprint.Of(job.Analysed.ToSegments()))) throw new CommandException(CommandFailure.Usage, Wording.Get("CncTrace.OtherDrawing", file, Path.GetFileName(context.Drawing.FileName)));
        return new RecordedRun(job, trace);
    }

    private static RunTrace TraceOf(string file)
    {
        try
        {
            return TraceFile.Read(file);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or FormatException)
        {
            throw new CommandException(CommandFailure.Usage, Wording.Get("CncTrace.Unreadable", file, SystemErrorText.FromException(unreadable)));
        }
    }

    private static CommandException NoRun(CommandContext context) => new(CommandFailure.Usage, Wording.Get("CncTrace.NoRun", Path.GetFileName(context.Drawing.FileName)));
}
