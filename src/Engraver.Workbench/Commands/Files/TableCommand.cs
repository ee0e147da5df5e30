using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Files;

/// <summary>TABLE: The fixed-slot entity table of 16 columns, in sequence order or as drawn.</summary>
internal sealed class TableCommand : ICommand
{
    public CommandInfo Info { get; } = new("TABLE", CommandGroup.Ask);

    private static readonly IReadOnlyList<Keyword> s_formats = Keyword.List("Text", "Csv", "Json");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var settings = context.Document.Current.Settings;
        var order = await context.ChoiceAsync(Wording.Get("Table.EnterRowOrder"), Keyword.List("Sequenced", "Drawn"), "Sequenced").ConfigureAwait(false);
        var format = (await context.ChoiceAsync(Wording.Get("Table.EnterFormat"), s_formats, context.LastValue("TABLE", "Text")).ConfigureAwait(false));
        context.Remember("TABLE", format);
        var (table, findings) = order == "Drawn" ? (JobPreparation.Analyse(drawing, settings, context.PlateValues), []) : JobPreparation.CutTableOf(drawing, settings, context.PlateValues);
        FindingMessages.Write(context, drawing.FileName, findings, Severity.Warning);
        await ResultFile.WriteAsync(context, "table", format == "Text" ? ".txt" : "." + format.ToLowerInvariant(), output => EntityTableFormat.Write(format.ToLowerInvariant(), table, output)).ConfigureAwait(false);
    }
}
