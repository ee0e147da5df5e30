using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>The next plate of the document at a start, and its numbers during the run.</summary>
internal static class PlateStart
{
    /// <summary>The next plate with the present date and numbers.</summary>
    /// <returns>Null for a drawing without plates.</returns>
    /// <exception cref="CommandException">There are no values for it.</exception>
    public static Plate? Take(CommandContext context)
    {
        var (plates, next) = (context.Plates, context.Plates.Refresh(context.Document.Current));
        if (next.Problem is not { } problem) return next.Plate;
        if (plates.Csv is { } csv && plates.Number > csv.Table.Rows.Count) throw new CommandException(CommandFailure.Refused, Wording.Get("Plates.AllEngraved", csv.Table.Rows.Count, Path.GetFileName(csv.File)));
        FindingMessages.Write(context, context.Drawing.FileName, [problem], Severity.Error);
        throw new CommandException(CommandFailure.Refused, Wording.Get("Plates.NoValues"));
    }

    /// <summary>Asks about a plate that was not finished, before a run that spends numbers.</summary>
    /// <returns>True if the next plate is another one now.</returns>
    /// <exception cref="CommandException">The operator decided for neither number.</exception>
    public static async Task<bool> DecideAsync(CommandContext context)
    {
        if (context.Plates.Refresh(context.Document.Current).Refusal is not { } unfinished) return false;
        FindingMessages.Write(context, context.Drawing.FileName, [unfinished], Severity.Error);
        var answer = await context.ChoiceAsync(Wording.Get("Plates.EnterDecision"), Keyword.List("Same", "Next", "Cancel"), "Cancel").ConfigureAwait(false);
        if (answer == "Cancel") throw new CommandException(CommandFailure.Refused, Wording.Get("Plates.NotDecided"));
        context.Plates.Decide(answer == "Same" ? CounterChoice.Again : CounterChoice.Next, context.Document.Current);
        if (context.Plates.Of(context.Document.Current) is { } plate) context.WriteMessage(context.Plates.TextOf(plate));
        return true;
    }

    /// <summary>The run of the plate of a job.</summary>
    /// <returns>Null for a job without a plate.</returns>
    public static PlateTurn? Turn(CommandContext context, PreparedJob job) => job.Plate is not { } plate ? null
        : new PlateTurn(plate, JobPreparation.FieldsOf(job.DocumentDrawing, job.Settings).Counters, context.Plates.Book, context.Plates.Choice, IsResumed: context.Machine.Runs.Part?.Plate is not null);

    /// <summary>Confirms the numbers of a complete plate, and shows the next one.</summary>
    /// <param name="report">Null if the run ended without a report.</param>
    public static async Task EndAsync(CommandContext context, PlateTurn turn, PreparedJob job, MachineRunReport? report)
    {
        if (report is not null && await turn.EndAsync(report).ConfigureAwait(false) is { } unnoted) FindingMessages.Write(context, job.Drawing.FileName, [unnoted], Severity.Warning);
        context.Plates.End(turn.Plate, report?.Result.Outcome == JobOutcome.Complete, context.Document.Current);
    }
}
