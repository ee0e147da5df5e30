using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCPLATE: Chooses the values of the next plate of a drawing whose texts have fields: the CSV file, its row, the numbers of counters; lists the
/// next plates.</summary>
internal sealed class CncPlateCommand : ICommand
{
    /// <summary>Plates in the list.</summary>
    private const int MaxListed = 10;

    public CommandInfo Info { get; } = new("CNCPLATE", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        if (context.Plates.StateOf(context.Document.Current).Problem is { } problem) FindingMessages.Write(context, context.Drawing.FileName, [problem], Severity.Warning);
        var options = context.Plates.Csv is null ? Keyword.List("Csv", "Number", "cOunter", "Status") : Keyword.List("Csv", "None", "Row", "cOunter", "Status");
        switch (await context.ChoiceAsync(Wording.Get("CncPlate.EnterOption"), options, "Status").ConfigureAwait(false))
        {
            case "Csv": await AskForFileAsync(context).ConfigureAwait(false); break;
            case "None": context.Plates.Use(null, context.Document.Current); break;
            case "cOunter": await AskForCounterAsync(context, cancellation).ConfigureAwait(false); break;
            case "Status": WriteUnfinished(context); break;
            default: await AskForNumberAsync(context).ConfigureAwait(false); break;
        }

        WriteNext(context);
    }

    private static async Task AskForFileAsync(CommandContext context)
    {
        var file = context.ResolveInputPath(await context.ValueAsync(new FilePrompt(Wording.Get("CncPlate.EnterFile"), new FileRequest("csv", false, ".csv", ".txt"))).ConfigureAwait(false));
        var (table, findings) = CsvTable.Read(file);
        FindingMessages.Write(context, file, findings, Severity.Warning);
        if (table is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncPlate.FileNotUsed", Path.GetFileName(file)));
        context.Plates.Use(new PlateCsv(file, table), context.Document.Current);
        if (context.Plates.StateOf(context.Document.Current).Fields is { } fields && (fields.UsesColumnOf(table) || fields.Columns.Count > 0)) return;
        context.Plates.Use(null, context.Document.Current);
        FindingMessages.Write(context, file, [SerialRules.CsvUnused.At(default, string.Join(", ", table.Columns))], Severity.Error);
        throw new CommandException(CommandFailure.Usage, Wording.Get("CncPlate.FileNotUsed", Path.GetFileName(file)));
    }

    private static async Task AskForNumberAsync(CommandContext context)
    {
        var (csv, present) = (context.Plates.Csv, context.Plates.Number);
        double last = csv?.Table.Rows.Count ?? int.MaxValue;
        var prompt = new NumberPrompt(csv is null ? Wording.Get("CncPlate.EnterNumber") : Wording.Get("CncPlate.EnterRow", last)) { IsInteger = true, Min = 1, Max = last, Default = NumberPrompt.Format(Math.Min(present, last)) };
        context.Plates.GoTo((int)await context.ValueAsync(prompt).ConfigureAwait(false), context.Document.Current);
    }

    private static async Task AskForCounterAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Plates.StateOf(context.Document.Current).Fields is not { Counters: { Count: > 0 } counters }) throw new CommandException(CommandFailure.Usage, Wording.Get("CncPlate.NoCounter"));
        var name = counters.Count == 1 ? counters[0].Name : await NameAsync(context, counters).ConfigureAwait(false);
        var number = (long)await context.ValueAsync(new NumberPrompt(Wording.Get("CncPlate.EnterCounter", name)) { IsInteger = true, Min = 0, Max = SerialFieldReader.MaxNumber }).ConfigureAwait(false);
        try
        {
            if (await context.Plates.Book.SetAsync(name, number, cancellation).ConfigureAwait(false) is { } warning) FindingMessages.Write(context, name, [warning], Severity.Warning);
        }
        catch (CounterException refused)
        {
            throw new CommandException(CommandFailure.Refused, refused.Message);
        }

        context.Plates.Refresh(context.Document.Current);
    }

    private static async Task<string> NameAsync(CommandContext context, IReadOnlyList<CounterDesign> counters)
    {
        while (true)
        {
            var typed = await context.ValueAsync(new TextPrompt(Wording.Get("CncPlate.EnterName", string.Join(", ", counters.Select(one => one.Name)))) { Default = counters[0].Name }).ConfigureAwait(false);
            if (counters.FirstOrDefault(one => one.Name.Equals(typed.Trim(), StringComparison.OrdinalIgnoreCase)) is { } known) return known.Name;
            context.WriteMessage(Wording.Get("CncPlate.UnknownCounter", typed), MessageKind.Error);
        }
    }

    /// <summary>Plates of the drawing's counters that were started and not finished.</summary>
    private static void WriteUnfinished(CommandContext context)
    {
        if (context.Plates.Refresh(context.Document.Current).Refusal is { } unfinished) FindingMessages.Write(context, context.Drawing.FileName, [unfinished], Severity.Warning);
    }

    private static void WriteNext(CommandContext context)
    {
        var next = context.Plates.StateOf(context.Document.Current);
        if (next.Fields is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncPlate.NoFields"));
        if (next.Problem is not null) return;
        if (context.Plates.Resumed is { } resumed) context.WriteMessage(Wording.Get("CncPlate.Resumed", context.Plates.TextOf(resumed)), MessageKind.Result);
        context.WriteResult(output =>
        {
            foreach (var plate in context.Plates.Forecast(context.Document.Current, context.Plates.Csv is null ? 1 : MaxListed)) output.WriteLine(context.Plates.TextOf(plate));
        });
    }
}
