using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.EntityTables;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver table</c>: the fixed-slot entity table of paper 001, in sequence order or as drawn.</summary>
internal static class TableVerb
{
    public static Command Build(VerbHost host)
    {
        var drawing = new DrawingOptions();
        var format = new Option<string>("--format") { Description = Wording.Get("Table.Format"), DefaultValueFactory = _ => "text" };
        format.AcceptOnlyFromAmong([.. EntityTableFormat.Names]);
        var asDrawn = new Option<bool>("--as-drawn") { Description = Wording.Get("Table.AsDrawn") };
        var command = new Command("table", Wording.Get("Table.Summary"));
        drawing.AddTo(command);
        command.Options.Add(format);
        command.Options.Add(asDrawn);
        command.SetAction((parsed, stop) =>
        {
            var settings = drawing.Settings(parsed);
            var read = DrawingFile.Open(drawing.File(parsed), settings, stop);
            var (table, findings) = parsed.GetValue(asDrawn) ? (JobPreparation.Analyse(read, settings), []) : JobPreparation.CutTableOf(read, settings);
            EntityTableFormat.Write(parsed.GetRequiredValue(format), table, host.Out);
            return Task.FromResult(host.Report(parsed, read.FileName, [.. read.Diagnostics, .. findings]));
        });
        return command;
    }
}
