using Engraver.Core.Diagnostics;
using Engraver.Core.Posts.Agie;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Files;

/// <summary>AGIEPOST: Writes the sequenced drawing as programs for the AGIECUT DEM15 (paper 000), and reports the forecast of the machine's
/// positions.</summary>
internal sealed class AgiePostCommand : ICommand
{
    private const string Name = "AGIEPOST";

    public CommandInfo Info { get; } = new(Name, CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var style = await context.ChoiceAsync(Wording.Get("AgiePost.EnterStyle"), Keyword.List("Exact", "Paper"), context.LastValue(Name, "Exact")).ConfigureAwait(false);
        context.Remember(Name, style);
        var options = new Dictionary<string, string> { [AgiePost.Style.Name] = style == "Paper" ? AgiePost.PaperStyle : AgiePost.ExactStyle };
        var posted = PostedProgram.Create(drawing, context.Document.Current.Settings, new AgiePost(), options, context.PlateValues);
        FindingMessages.Write(context, drawing.FileName, posted.Diagnostics, Severity.Warning);
        if (posted.Text is not { } text) throw new CommandException(CommandFailure.Drawing, $"{posted.NoProgramReason}.");
        var name = await ResultFile.WriteAsync(context, "program", new AgiePost().FileExtension, output => output.Write(text)).ConfigureAwait(false);
        if (name is not null)
        {
            context.Remember(VerifyCommand.Name, name);
            ProgramStart.Save(context.ResolveOutputPath(name), posted.Forecast);
        }

        context.Remember(HistoryEntry.OfPost(drawing, context.Document.Current.Settings, new AgiePost().Name, options, name is null ? null : context.ResolveOutputPath(name), context.Time.GetUtcNow()));
        if (posted.Forecast is { } forecast) context.WriteResult(output => ForecastText.WriteSum(output, forecast));
    }
}
